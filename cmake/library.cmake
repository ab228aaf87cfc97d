# ronda_library(NAME SOURCES… [LINKS ronda::x …] [PRIVATE_LINKS …])
# A static library `ronda_NAME` with alias `ronda::NAME`; headers are included as "common/…/x.h" from the root.
# Warnings are errors on our own code.
add_library(ronda_warnings INTERFACE)
# (-Wrestrict of g++ 12 is wrong about std::string at -O3: GCC bug 105651.)
target_compile_options(ronda_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                                -Wno-sign-conversion -Wno-restrict -Werror)

function(ronda_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  set(include_dirs $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/ronda>)
  if(arg_SOURCES)
    add_library(ronda_${name} STATIC ${arg_SOURCES})
    target_include_directories(ronda_${name} PUBLIC ${include_dirs})
    target_link_libraries(ronda_${name} PUBLIC ${arg_LINKS}
                          PRIVATE ${arg_PRIVATE_LINKS} $<BUILD_INTERFACE:ronda_warnings>)
    target_compile_features(ronda_${name} PUBLIC cxx_std_20)
  else()
    add_library(ronda_${name} INTERFACE)
    target_include_directories(ronda_${name} INTERFACE ${include_dirs})
    target_link_libraries(ronda_${name} INTERFACE ${arg_LINKS})
  endif()
  add_library(ronda::${name} ALIAS ronda_${name})
endfunction()

# ronda_program(NAME SOURCES… LINKS …): an executable under build/<preset>/bin.
function(ronda_program name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${arg_LINKS} ronda_warnings)
endfunction()

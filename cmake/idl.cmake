# ronda_idl_library(TARGET FILES a.idl …): runs fastddsgen at build time, in the build tree, and compiles what it
# writes as one static library. Its headers are SYSTEM includes: <experience.h>, <experiencePubSubTypes.h>, …
find_package(fastcdr REQUIRED)
find_package(fastrtps 2.9 REQUIRED)
find_program(FASTDDSGEN fastddsgen REQUIRED)

function(ronda_idl_library target)
  cmake_parse_arguments(arg "" "" "FILES" ${ARGN})
  set(directory ${CMAKE_CURRENT_BINARY_DIR}/generated)
  set(sources)
  foreach(file ${arg_FILES})
    get_filename_component(name ${file} NAME_WE)
    set(generated ${directory}/${name}.h ${directory}/${name}.cxx ${directory}/${name}PubSubTypes.h
                  ${directory}/${name}PubSubTypes.cxx)
    add_custom_command(
      OUTPUT ${generated}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${directory}
      COMMAND ${FASTDDSGEN} -replace -cs -d ${directory} ${file} > ${directory}/${name}.log
      DEPENDS ${file}
      COMMENT "fastddsgen ${name}.idl"
      VERBATIM)
    list(APPEND sources ${generated})
  endforeach()
  add_library(${target} STATIC ${sources})
  target_include_directories(${target} SYSTEM PUBLIC ${directory})
  target_link_libraries(${target} PUBLIC fastrtps fastcdr)
endfunction()

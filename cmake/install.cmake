# cmake --install: the programs; maps, policies and what draws figures; the libraries that load a policy and run it, with
# their headers; and the package for find_package(ronda). A prefix may be moved. Programs find share/ronda beside their own folder
# (common/run/paths).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(data_dir share/ronda)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ronda)

install(TARGETS ronda ronda-actor ronda-replay ronda-learner RUNTIME DESTINATION bin)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/maps DESTINATION ${data_dir})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/policies DESTINATION ${data_dir} OPTIONAL)
install(FILES ${PROJECT_SOURCE_DIR}/python/figures.py ${PROJECT_SOURCE_DIR}/python/comparison_figures.py
        DESTINATION ${data_dir}/python)

foreach(library base world nn rl environments policies team)
  set_target_properties(ronda_${library} PROPERTIES EXPORT_NAME ${library})
  install(TARGETS ronda_${library} EXPORT ronda ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  # network_config.h is about runs, which nobody outside has.
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/common/${library} DESTINATION include/ronda/common
          FILES_MATCHING PATTERN "*.h" PATTERN network_config.h EXCLUDE)
endforeach()

install(EXPORT ronda NAMESPACE ronda:: FILE rondaTargets.cmake DESTINATION ${package_dir})
configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/rondaConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/rondaConfig.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS data_dir)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/rondaConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/rondaConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/rondaConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/FindGLPK.cmake
        DESTINATION ${package_dir})

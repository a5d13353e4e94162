# `cmake --install`: the commands with their data, the libraries with their headers, the CMake package and pkg-config's file.
include(CMakePackageConfigHelpers)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/openevc)
set(libraries openevc_headers openevc_core openevc_curves openevc_kernel)
if(NOT EVC_KERNEL_ONLY)
  list(APPEND libraries openevc_language openevc_sim openevc_c)
endif()
install(TARGETS ${libraries} EXPORT openevcTargets)
install(EXPORT openevcTargets NAMESPACE openevc:: DESTINATION ${package})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/openevc DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h" PATTERN "*.inc")

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/openevcConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/openevcConfig.cmake INSTALL_DESTINATION ${package})
# Before 1.0 an interface may change with every minor version.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/openevcConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/openevcConfig.cmake ${PROJECT_BINARY_DIR}/openevcConfigVersion.cmake
        DESTINATION ${package})

if(TARGET openevc_c)
  # Found from the file itself, so that an installed tree may be moved.
  file(RELATIVE_PATH prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  set(prefix "\${pcfiledir}/${prefix}")
  configure_file(${PROJECT_SOURCE_DIR}/cmake/openevc.pc.in ${PROJECT_BINARY_DIR}/openevc.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/openevc.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
if(TARGET evc)
  install(TARGETS evc)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/openevc)
endif()
# Alone by `--component cluster`; with it the data come along, which a whole installation has anyway.
if(TARGET evc-mpi)
  install(TARGETS evc-mpi COMPONENT cluster)
  install(PROGRAMS ${PROJECT_SOURCE_DIR}/examples/cluster/sweep.sbatch DESTINATION ${CMAKE_INSTALL_DATADIR}/openevc/cluster
          COMPONENT cluster)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/openevc COMPONENT cluster EXCLUDE_FROM_ALL)
endif()

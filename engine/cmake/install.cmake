# Installs libraries, headers, programs and scripts, and the package that find_package(stiction) finds.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(layer_targets ${STICTION_LAYERS})
list(TRANSFORM layer_targets PREPEND stiction_)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/stiction)

install(TARGETS stiction_flags ${layer_targets} EXPORT stiction)
install(EXPORT stiction NAMESPACE stiction:: DESTINATION ${package_folder})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/engine/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/stiction
        FILES_MATCHING PATTERN *.hpp PATTERN mesher EXCLUDE PATTERN petsc EXCLUDE PATTERN cmake EXCLUDE)
if(TARGET stiction-figures)
  install(TARGETS stiction-figures)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/stiction-config.cmake.in stiction-config.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(stiction-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/stiction-config.cmake ${PROJECT_BINARY_DIR}/stiction-config-version.cmake
        DESTINATION ${package_folder})

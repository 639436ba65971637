# `cmake --install` puts the library where find_package(delone) finds it (component `library`), and the command line
# into bin (component `app`).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set_target_properties(delone PROPERTIES EXPORT_NAME delone)
target_compile_features(delone PUBLIC cxx_std_20)
set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/delone)
install(TARGETS delone EXPORT deloneTargets COMPONENT library)
install(DIRECTORY include/delone DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library PATTERN io EXCLUDE
  PATTERN lab EXCLUDE)
install(EXPORT deloneTargets NAMESPACE delone:: DESTINATION ${package_directory} COMPONENT library)

configure_package_config_file(cmake/deloneConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/deloneConfig.cmake
  INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/deloneConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/deloneConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/deloneConfigVersion.cmake
  DESTINATION ${package_directory} COMPONENT library)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT library)
if(TARGET delone_app)
  install(TARGETS delone_app COMPONENT app)
endif()

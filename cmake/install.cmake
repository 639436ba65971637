# `cmake --install` puts the library where find_package(delone) finds it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set_target_properties(delone PROPERTIES EXPORT_NAME delone)
target_compile_features(delone PUBLIC cxx_std_20)
install(TARGETS delone EXPORT deloneTargets)
install(DIRECTORY include/delone DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} PATTERN io EXCLUDE)
install(EXPORT deloneTargets NAMESPACE delone:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/delone)

file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/deloneConfig.cmake
  "include(CMakeFindDependencyMacro)\nfind_dependency(Threads)\ninclude(\"\${CMAKE_CURRENT_LIST_DIR}/deloneTargets.cmake\")\n")
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/deloneConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/deloneConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/deloneConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/delone)

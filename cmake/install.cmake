# cmake --install: the header and its C++ wrapper, the shared library, the tool, and what CMake and
# pkg-config need to find them. The prefix may be moved afterwards.
include(CMakePackageConfigHelpers)

set(gp_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/glitterpath)

install(TARGETS glitterpath EXPORT glitterpath-targets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/glitterpath
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")
if(TARGET glitterpath_tool)
  # GNUInstallDirs' relation of bin to lib, so that the tool finds its library in any prefix.
  file(RELATIVE_PATH gp_lib_from_bin /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
  set_target_properties(glitterpath_tool PROPERTIES INSTALL_RPATH "$ORIGIN/${gp_lib_from_bin}")
  install(TARGETS glitterpath_tool RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

install(EXPORT glitterpath-targets NAMESPACE glitterpath:: DESTINATION ${gp_cmake_dir})
configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/glitterpath-config.cmake.in
  ${PROJECT_BINARY_DIR}/glitterpath-config.cmake INSTALL_DESTINATION ${gp_cmake_dir})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/glitterpath-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/glitterpath-config.cmake
              ${PROJECT_BINARY_DIR}/glitterpath-config-version.cmake
        DESTINATION ${gp_cmake_dir})

# The .pc file names its prefix relative to itself (pcfiledir), as the CMake files do.
file(RELATIVE_PATH gp_prefix_from_pc
     /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${PROJECT_SOURCE_DIR}/cmake/glitterpath.pc.in
               ${PROJECT_BINARY_DIR}/glitterpath.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/glitterpath.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

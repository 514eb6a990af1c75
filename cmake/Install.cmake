# What others find us by, pkg-config and find_package(Anteroom), and the Debian packages: `cpack` in the build folder.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/Anteroom)
install(EXPORT Anteroom NAMESPACE Anteroom:: FILE AnteroomTargets.cmake DESTINATION ${config} COMPONENT development)
configure_package_config_file(cmake/AnteroomConfig.cmake.in ${PROJECT_BINARY_DIR}/AnteroomConfig.cmake
  INSTALL_DESTINATION ${config} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/AnteroomConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/AnteroomConfig.cmake ${PROJECT_BINARY_DIR}/AnteroomConfigVersion.cmake
  DESTINATION ${config} COMPONENT development)

file(RELATIVE_PATH PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" PREFIX ${PREFIX})
configure_file(cmake/anteroom.pc.in anteroom.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/anteroom.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

# The packages' documents.
anteroom_compress(changelog cmake/package/changelog)
foreach(component runtime development)
  set(package anteroom)
  if(component STREQUAL development)
    set(package anteroom-dev)
  endif()
  install(FILES ${changelog} cmake/package/copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endforeach()

add_custom_target(uninstall
  COMMAND ${CMAKE_COMMAND} -DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt
          -P ${CMAKE_CURRENT_LIST_DIR}/Uninstall.cmake
  VERBATIM)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME anteroom)
set(CPACK_PACKAGE_VENDOR "the Anteroom project")
set(CPACK_PACKAGE_CONTACT "Anteroom maintainers <maintainers@anteroom.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME anteroom)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
# The Vulkan loader is opened by name, and its drivers by the loader.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS libvulkan1)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "mesa-vulkan-drivers | vulkan-icd, libegl1, libgles1")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
"Runs programs that were written for OpenGL ES 1.1 and EGL on any Vulkan 1.1
driver. The libraries replace the system's only where that is asked for: by
anteroom-run, or as a vendor of libglvnd's that comes after the others.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME anteroom-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "anteroom (= ${PROJECT_VERSION}), libegl-dev, libgles-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"What pkg-config and CMake need to link programs to Anteroom's libEGL and
libGLESv1_CM, and the header of its own EGL extensions.")
include(CPack)

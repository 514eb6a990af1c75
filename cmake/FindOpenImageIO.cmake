# OpenImageIO::OpenImageIO. Debian's own CMake package refuses to load without the package of command-line
# tools and so cannot be used; pkg-config knows all that is needed.
find_package(PkgConfig REQUIRED)
pkg_check_modules(OpenImageIO QUIET IMPORTED_TARGET OpenImageIO)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenImageIO
  REQUIRED_VARS OpenImageIO_LINK_LIBRARIES VERSION_VAR OpenImageIO_VERSION)
if(OpenImageIO_FOUND AND NOT TARGET OpenImageIO::OpenImageIO)
  add_library(OpenImageIO::OpenImageIO INTERFACE IMPORTED)
  target_link_libraries(OpenImageIO::OpenImageIO INTERFACE PkgConfig::OpenImageIO)
endif()

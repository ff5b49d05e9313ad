# Every dependency is a package of Debian 12; when one is missing, say which.
macro(overfly_require package debian_package)
  # QUIET silences CMake, not the package's own files: Debian's Imath reports a Python library that nobody links. The
  # log level silences those too; an error still comes through.
  set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
  find_package(${package} ${ARGN} QUIET)
  unset(CMAKE_MESSAGE_LOG_LEVEL)
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "${package} not found. On Debian 12: apt-get install ${debian_package}")
  endif()
endmacro()

list(APPEND CMAKE_MODULE_PATH /usr/share/cmake/geographiclib)

overfly_require(GDAL libgdal-dev 3.6)
overfly_require(GeographicLib libgeographiclib-dev MODULE)
overfly_require(GEOS libgeos-dev 3.11)
overfly_require(assimp libassimp-dev 5.2)
# Debian's target names the libraries that assimp itself was linked with; whoever links the shared one needs none of them,
# and libassimp-dev does not bring them.
set_target_properties(assimp::assimp PROPERTIES INTERFACE_LINK_LIBRARIES "")
overfly_require(OpenEXR libopenexr-dev 3.1)
overfly_require(OpenImageIO libopenimageio-dev 2.4)
# Debian's target names the headers of OpenCV as well, which its package does not bring and we do not need; CMake refuses
# a folder that is not there.
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${OpenImageIO_INCLUDE_DIR}")
overfly_require(OpenColorIO libopencolorio-dev 2.1 MODULE)
overfly_require(OpenSSL libssl-dev 3.0)
overfly_require(yaml-cpp libyaml-cpp-dev 0.7)
overfly_require(embree libembree-dev 3.13)
overfly_require(TBB libtbb-dev)
overfly_require(hwy libhwy-dev)
overfly_require(fmt libfmt-dev)
overfly_require(nlohmann_json nlohmann-json3-dev)
overfly_require(CLI11 libcli11-dev)
if(OVERFLY_BUILD_TESTS)
  overfly_require(GTest libgtest-dev)
  # Debian puts its GoogleMock into a package of its own, which GoogleTest's package file can do without.
  if(NOT TARGET GTest::gmock)
    message(FATAL_ERROR "GoogleMock not found. On Debian 12: apt-get install libgmock-dev")
  endif()
  include(GoogleTest)
endif()
if(OVERFLY_BUILD_BENCHMARKS)
  overfly_require(benchmark libbenchmark-dev)
endif()

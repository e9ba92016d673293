# The three libraries: the system's where it has them, or else the same source text everywhere, which
# CMake downloads once (2 MB) from Debian's archive and compares with a checksum.
include(FetchContent)

set(debian "https://deb.debian.org/debian/pool/main")
set(snapshot "https://snapshot.debian.org/archive/debian/20240601T000000Z/pool/main")

function(download name path checksum)
  message(STATUS "${name} is not installed: downloading it")
  FetchContent_Declare(${name}
    URL "${debian}/${path}" "${snapshot}/${path}"
    URL_HASH SHA256=${checksum} DOWNLOAD_EXTRACT_TIMESTAMP OFF)
endfunction()

macro(find_libraries)
  find_package(tinyxml2 QUIET)
  find_path(STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb)
  find_package(GTest QUIET)
  set(CMAKE_UNITY_BUILD OFF)  # others' files are not ours to batch
  if(NOT TARGET tinyxml2::tinyxml2)
    download(tinyxml2 t/tinyxml2/tinyxml2_9.0.0+dfsg.orig.tar.xz
      96510f47a5db537f70dff3e83dd71fd2180cbba4aa76c589a549467e7f34bc9b)
    set(tinyxml2_BUILD_TESTING OFF)
    FetchContent_MakeAvailable(tinyxml2)
  endif()
  if(NOT STB_INCLUDE_DIR)
    download(stb libs/libstb/libstb_0.0~git20220908.8b5f1f3+ds.orig.tar.xz
      6949c8ff9f86d982cff1b384f1301a731cbaf3b3fa4d1728c7b48a02386d31d8)
    FetchContent_MakeAvailable(stb)
    set(STB_INCLUDE_DIR "${stb_SOURCE_DIR}" CACHE PATH "stb_image.h lies here" FORCE)
  endif()
  if(NOT TARGET GTest::gtest)
    download(googletest g/googletest/googletest_1.12.1.orig.tar.gz
      81964fe578e9bd7c94dfdb09c8e4d6e6759e19967e397dbea48d1c10e45d0df2)
    set(BUILD_GMOCK OFF)
    set(INSTALL_GTEST OFF)
    set(gtest_force_shared_crt ON)
    FetchContent_MakeAvailable(googletest)
  endif()
  set(CMAKE_UNITY_BUILD ON)
endmacro()

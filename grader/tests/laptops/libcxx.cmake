# What macOS compiles with, as near as Debian has it. Debian's own libraries are of the other C++
# library.
set(CMAKE_C_COMPILER clang-14)
set(CMAKE_CXX_COMPILER clang++-14)
# What Microsoft's compiler does not know either is an error: extensions of GCC, and of C.
set(CMAKE_CXX_FLAGS_INIT "-stdlib=libc++ -pedantic-errors -Werror=gnu")
set(CMAKE_DISABLE_FIND_PACKAGE_GTest ON)
set(CMAKE_DISABLE_FIND_PACKAGE_tinyxml2 ON)
# Debian's cpp-httplib is a library of its own, compiled for GCC's standard library.
set(TICK1STAR_VIEW OFF CACHE BOOL "")

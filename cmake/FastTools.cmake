# Uses ccache and lld if they are installed: the same results, faster.
find_program(TICKER_CCACHE ccache)
if(TICKER_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Without these settings ccache does not cache files that use precompiled headers. (time_macros is safe: no
  # code of ours uses __TIME__.)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${TICKER_CCACHE}")
endif()

find_program(TICKER_LLD ld.lld)
if(TICKER_LLD)
  add_link_options(-fuse-ld=lld)
endif()

# Clang's parser, for `ticker explain`; without it everything else works.
file(GLOB TICKER_LLVM_FOLDERS "/usr/lib/llvm-*")
find_path(TICKER_LIBCLANG_INCLUDE clang-c/Index.h PATHS ${TICKER_LLVM_FOLDERS}
  PATH_SUFFIXES include)
find_library(TICKER_LIBCLANG clang PATHS ${TICKER_LLVM_FOLDERS} PATH_SUFFIXES lib)
if(NOT TICKER_LIBCLANG_INCLUDE)
  set(TICKER_LIBCLANG "")
endif()

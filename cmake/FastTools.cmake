# Uses ccache and lld if they are installed: the same results, faster.
find_program(TICKER_CCACHE ccache)
if(TICKER_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${TICKER_CCACHE}")
endif()

find_program(TICKER_LLD ld.lld)
if(TICKER_LLD)
  add_link_options(-fuse-ld=lld)
endif()

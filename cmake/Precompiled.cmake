# Headers that the compiler reads once for many targets, all with equal flags. Folders with full
# optimisation take no part: they are few.
#
# Every file still includes what it uses: the presets debug, clang and tidy do without, so that the guards
# clang and tidy find what is missing.
option(TICKER_PRECOMPILED_HEADERS "Read common headers once for many targets" ON)

# Most files include these.
set(TICKER_COMMON_HEADERS
  <algorithm> <array> <cmath> <cstddef> <cstdint> <cstdio> <cstring> <filesystem> <functional>
  <iterator> <limits> <map> <memory> <numeric> <optional> <set> <span> <sstream> <stdexcept> <string>
  <string_view> <system_error> <tuple> <unordered_map> <utility> <variant> <vector>)

# ticker_precompile(folders LIBRARIES lib... HEADERS <header>...): a target of precompiled headers alone.
function(ticker_precompile name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;HEADERS" ${ARGN})
  if(NOT TICKER_PRECOMPILED_HEADERS)
    return()
  endif()
  set(empty "${CMAKE_BINARY_DIR}/precompiled/${name}.cpp")
  file(CONFIGURE OUTPUT "${empty}" CONTENT "")
  add_library(ticker_precompiled_${name} OBJECT "${empty}")
  target_link_libraries(ticker_precompiled_${name} PRIVATE ${ARG_LIBRARIES} raytracer::warnings)
  target_precompile_headers(ticker_precompiled_${name} PRIVATE ${TICKER_COMMON_HEADERS} ${ARG_HEADERS})
  ticker_optimise_little(ticker_precompiled_${name})
endfunction()

function(ticker_use_precompiled target name)
  if(TICKER_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ticker_precompiled_${name})
  endif()
endfunction()

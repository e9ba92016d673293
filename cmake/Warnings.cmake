# Warnings for our own code; link to it PRIVATE. They are errors only with TICKER_WERROR, as in CI.
add_library(raytracer_warnings INTERFACE)
add_library(raytracer::warnings ALIAS raytracer_warnings)
target_compile_options(raytracer_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -Wold-style-cast
  # GCC 12 reports overlapping copies in "text" + std::string{...} that do not exist (GCC bug
  # 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # Files compile in batches: a file of a batch counts as a header for this warning.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>
  $<$<BOOL:${TICKER_WERROR}>:-Werror>)

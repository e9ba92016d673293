#ifndef TICKER_BUILD_DIAGNOSTICS_H
#define TICKER_BUILD_DIAGNOSTICS_H

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::build {

/// Most bytes of diagnostics that are kept.
inline constexpr std::size_t kMostDiagnostics = 16U << 10U;

/// A compiler's output in the form that a student reads: without the folders in `hidden`, with the
/// linker's temporary object called `fileName` and the assembler's file named after it, cut at the
/// end of a line, as valid UTF-8.
[[nodiscard]] std::string readableDiagnostics(std::string_view output,
                                              const std::vector<std::filesystem::path>& hidden,
                                              std::string_view fileName);

}  // namespace ticker::build

#endif

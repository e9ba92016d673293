#ifndef TICKER_TESTS_LAYERING_INCLUDES_H
#define TICKER_TESTS_LAYERING_INCLUDES_H

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ticker::tests {

/// The layer that a source file belongs to; empty for tests, benchmarks and tools.
[[nodiscard]] std::optional<std::string> layerOf(const std::filesystem::path& file);

/// "raytracer/math" of "raytracer/math/Ray.h", "grader/tasks" of "grader/tasks/bump/Fit.h".
[[nodiscard]] std::optional<std::string> folderOf(const std::string& header);

/// Headers and sources of the whole project, sorted.
[[nodiscard]] std::vector<std::filesystem::path> sources();

[[nodiscard]] std::vector<std::string> linesOf(const std::filesystem::path& file);

/// The headers in a file's #include lines, in order.
[[nodiscard]] std::vector<std::string> includesOf(const std::filesystem::path& file);

}  // namespace ticker::tests

#endif

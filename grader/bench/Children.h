#ifndef TICKER_BENCH_CHILDREN_H
#define TICKER_BENCH_CHILDREN_H

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::bench {

/// CPU time of all child processes that have ended, and of their descendants.
[[nodiscard]] double childSeconds();

/// Starts a program; its output goes to `output`. @throws raytracer::Error if it cannot be run.
[[nodiscard]] pid_t start(std::vector<std::string> words, const std::filesystem::path& output);

/// @throws raytracer::Error if the program failed.
void finish(pid_t child, const std::filesystem::path& output);

}  // namespace ticker::bench

#endif

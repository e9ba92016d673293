#ifndef TICKER_ORACLE_KERNEL_H
#define TICKER_ORACLE_KERNEL_H

#include <grader/oracle/Setup.h>
#include <grader/oracle/kernel/Workspace.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace ticker::oracle {

/// How the samples of a call's paths are drawn.
enum class Drawing {
    student,      ///< shadowRayCount independent rays for each hit and light, points from the pool
    independent,  ///< the same, but each path's samples follow from its numbers: equal on every
                  ///< machine
    paired        ///< two shadow rays for each hit and light, and closed forms: for moments
};

/// State of the student renders' generator: one for each lane.
struct LaneSeeds {
    std::array<std::uint32_t, 16> lane;
    std::uint64_t common;            ///< state of the generator that all lanes share
    std::array<float, 2> frameLens;  ///< in [0, 1): the one lens point of lensSharedByFrame
};

/// Traces the paths of a workspace with the widest vectors of this machine. `Drawing::student`
/// alone reads and advances `seeds`.
void tracePaths(const Setup& setup, Drawing drawing, Workspace& work, LaneSeeds& seeds);

/// Sums of the colours of paths [first, end) of a traced workspace.
std::array<double, 3> sumColours(const Workspace& work, std::size_t first, std::size_t end);

/// Sums over the paths of one pixel, of colours relative to `pivot`.
struct PathSums {
    std::array<double, 3> pivot{};
    std::array<double, 3> mean{};
    std::array<double, 6> second{};  ///< products of two independent estimates: rr gg bb rg rb gb
    std::array<double, 6> noise{};   ///< covariance that shadow rays add
};

/// @param paired  As traced: `Drawing::paired`.
PathSums sumPaths(const Workspace& work, std::size_t first, std::size_t end, bool paired);

/// Name of the instruction set that `tracePaths` uses: "AVX3", "AVX2", "SSE4", ...
const char* instructionSet();

}  // namespace ticker::oracle

#endif

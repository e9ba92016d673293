#include <grader/oracle/Replicate.h>

#include <grader/oracle/Tiles.h>
#include <grader/oracle/kernel/Kernel.h>
#include <grader/oracle/kernel/Lattice.h>
#include <grader/oracle/kernel/Paths.h>

namespace ticker::oracle {
namespace {

std::uint32_t keyOf(std::uint64_t seed, std::uint64_t number, int pixel) {
    const auto low = static_cast<std::uint32_t>(seed);
    const auto high = static_cast<std::uint32_t>(seed >> 32U);
    const std::uint32_t run = mixed(mixed(mixed(low) + high) + static_cast<std::uint32_t>(number));
    return mixed(run + static_cast<std::uint32_t>(pixel));
}

// Adds sums that are relative to a pivot, and takes the pivot out in double precision.
void add(const PathSums& sums, double paths, PathMoments& to) {
    constexpr std::size_t kFirst[6] = {0, 1, 2, 0, 0, 1};
    constexpr std::size_t kSecond[6] = {0, 1, 2, 1, 2, 2};
    const auto& p = sums.pivot;
    for (std::size_t c = 0; c < 3; ++c)
        to.mean[c] += sums.mean[c] + paths * p[c];
    for (std::size_t e = 0; e < 6; ++e) {
        const std::size_t a = kFirst[e];
        const std::size_t b = kSecond[e];
        to.second[e] +=
            sums.second[e] + p[a] * sums.mean[b] + p[b] * sums.mean[a] + paths * p[a] * p[b];
        to.noise[e] += sums.noise[e];
    }
}

}  // namespace

PathMoments& PathMoments::operator+=(const PathMoments& other) {
    for (std::size_t c = 0; c < 3; ++c)
        mean[c] += other.mean[c];
    for (std::size_t e = 0; e < 6; ++e) {
        second[e] += other.second[e];
        noise[e] += other.noise[e];
    }
    return *this;
}

PathMoments& PathMoments::operator*=(double factor) {
    for (double& value : mean)
        value *= factor;
    for (std::size_t e = 0; e < 6; ++e) {
        second[e] *= factor;
        noise[e] *= factor;
    }
    return *this;
}

Replicate replicate(const Setup& setup, std::uint64_t seed, std::uint64_t number,
                    const std::vector<std::uint32_t>& counts) {
    Replicate result(counts.size());
    const auto at = [](int pixel) { return static_cast<std::size_t>(pixel); };
    // All-or-nothing is not linear in the samples: paired estimates do not apply.
    const bool straight = setup.mistake.allOrNothing || setup.mistake.litIfAny;
    const bool paired = setup.tricks.pairedShadows && !straight;
    const auto trace = [&](Workspace& full, const std::vector<PathPacker::Run>& runs) {
        LaneSeeds none{};
        tracePaths(setup, paired ? Drawing::paired : Drawing::independent, full, none);
        for (const PathPacker::Run& run : runs)
            add(sumPaths(full, run.first, run.end, paired),
                static_cast<double>(run.end - run.first), result[at(run.pixel)]);
    };
    forEachTile(static_cast<int>(counts.size()), setup.settings.threads, setup.settings.monitor,
                [&](const Tile& tile, Workspace& work) {
                    PathPacker packer{setup, work};
                    for (int pixel = tile.first; pixel < tile.end; ++pixel)
                        packer.add(pixel, keyOf(seed, number, pixel), counts[at(pixel)], trace);
                    packer.finish(trace);
                    for (int pixel = tile.first; pixel < tile.end; ++pixel)
                        result[at(pixel)] *= 1.0 / counts[at(pixel)];
                });
    return result;
}

}  // namespace ticker::oracle

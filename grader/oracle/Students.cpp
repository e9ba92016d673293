#include <grader/oracle/Students.h>

#include <grader/base/SplitMix.h>
#include <grader/oracle/Tiles.h>
#include <grader/oracle/kernel/Kernel.h>
#include <grader/oracle/kernel/Paths.h>

#include <array>
#include <vector>

namespace ticker::oracle {
namespace {

float unitFloat(std::uint64_t bits) {
    return static_cast<float>(bits >> 40U) * 0x1p-24F;
}

LaneSeeds seedsOf(std::uint64_t seed, int tile) {
    LaneSeeds seeds{};
    std::uint64_t frame = seed;
    seeds.frameLens = {unitFloat(splitMix(frame)), unitFloat(splitMix(frame))};
    std::uint64_t state = splitMix(frame) + static_cast<std::uint64_t>(tile);
    for (std::uint32_t& lane : seeds.lane)
        lane = static_cast<std::uint32_t>(splitMix(state) >> 32U) | 1U;  // xorshift never leaves 0
    seeds.common = splitMix(state);
    return seeds;
}

void renderTile(const Setup& setup, const Tile& tile, std::uint64_t seed, Workspace& work,
                raytracer::Image& image) {
    LaneSeeds seeds = seedsOf(seed, tile.number);
    std::vector<std::array<double, 3>> sums(static_cast<std::size_t>(tile.end - tile.first));
    const auto trace = [&](Workspace& full, const std::vector<PathPacker::Run>& runs) {
        tracePaths(setup, Drawing::student, full, seeds);
        for (const PathPacker::Run& run : runs) {
            const std::array<double, 3> colours = sumColours(full, run.first, run.end);
            for (std::size_t channel = 0; channel < 3; ++channel)
                sums[static_cast<std::size_t>(run.pixel - tile.first)][channel] += colours[channel];
        }
    };
    PathPacker packer{setup, work};
    for (int pixel = tile.first; pixel < tile.end; ++pixel)
        packer.add(pixel, 0, static_cast<std::uint32_t>(setup.settings.dofRayCount), trace);
    packer.finish(trace);

    const double scale = setup.mistake.pixelScale / setup.settings.dofRayCount;
    for (int pixel = tile.first; pixel < tile.end; ++pixel) {
        const auto& sum = sums[static_cast<std::size_t>(pixel - tile.first)];
        image.set(pixel % setup.width, pixel / setup.width,
                  {sum[0] * scale, sum[1] * scale, sum[2] * scale});
    }
}

}  // namespace

raytracer::Image studentRender(const Setup& setup, std::uint64_t seed) {
    raytracer::RenderSettings settings = setup.settings;
    settings.observer = nullptr;
    raytracer::Image image{settings};
    forEachTile(
        setup.width * setup.height, settings.threads, settings.monitor,
        [&](const Tile& tile, Workspace& work) { renderTile(setup, tile, seed, work, image); });
    return image;
}

}  // namespace ticker::oracle

#include <grader/oracle/Students.h>

#include <grader/oracle/Kernel.h>
#include <grader/oracle/Tiles.h>

#include <array>
#include <vector>

namespace ticker::oracle {
namespace {

std::uint64_t splitMix(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
}

float unitFloat(std::uint64_t bits) {
    return static_cast<float>(bits >> 40U) * 0x1p-24F;
}

LaneSeeds seedsOf(std::uint64_t seed, int tile) {
    LaneSeeds seeds{};
    std::uint64_t frame = seed;
    seeds.frameLens = {unitFloat(splitMix(frame)), unitFloat(splitMix(frame))};
    std::uint64_t state = splitMix(frame) + static_cast<std::uint64_t>(tile);
    for (std::uint32_t& lane : seeds.lane)
        lane = static_cast<std::uint32_t>(splitMix(state) >> 32U) | 1U;  // zero would stay zero
    seeds.common = splitMix(state);
    return seeds;
}

/// Pixels of one tile, path after path.
class TileRender {
public:
    TileRender(const Setup& setup, const Tile& tile, Workspace& work, std::uint64_t seed)
        : setup_(setup),
          tile_(tile),
          work_(work),
          seeds_(seedsOf(seed, tile.number)),
          sums_(static_cast<std::size_t>(tile.end - tile.first)) {}

    void run() {
        work_.paths = 0;
        for (int pixel = tile_.first; pixel < tile_.end; ++pixel)
            for (int ray = 0; ray < setup_.settings.dofRayCount; ++ray)
                add(pixel);
        flush();
    }

    void write(raytracer::Image& image) const {
        const double scale = setup_.mistake.pixelScale / setup_.settings.dofRayCount;
        for (std::size_t i = 0; i < sums_.size(); ++i) {
            const int pixel = tile_.first + static_cast<int>(i);
            image.set(pixel % setup_.width, pixel / setup_.width,
                      {sums_[i][0] * scale, sums_[i][1] * scale, sums_[i][2] * scale});
        }
    }

private:
    void add(int pixel) {
        if (work_.paths == kPaths) flush();
        const std::size_t at = work_.paths++;
        work_.column[at] = pixel % setup_.width;
        work_.row[at] = pixel / setup_.width;
        pixelOf_[at] = static_cast<std::size_t>(pixel - tile_.first);
    }
    void flush() {
        if (work_.paths == 0) return;
        tracePaths(setup_, Drawing::student, work_, seeds_);
        for (std::size_t channel = 0; channel < 3; ++channel)
            for (std::size_t i = 0; i < work_.paths; ++i)
                sums_[pixelOf_[i]][channel] += work_.colour[channel][i];
        work_.paths = 0;
    }

    const Setup& setup_;
    Tile tile_;
    Workspace& work_;
    LaneSeeds seeds_;
    std::vector<std::array<float, 3>> sums_;
    std::array<std::size_t, kPaths> pixelOf_{};
};

}  // namespace

raytracer::Image studentRender(const Setup& setup, std::uint64_t seed) {
    raytracer::RenderSettings settings = setup.settings;
    settings.observer = nullptr;
    raytracer::Image image{settings};
    forEachTile(setup.width * setup.height, settings.threads, settings.monitor,
                [&](const Tile& tile, Workspace& work) {
                    TileRender render{setup, tile, work, seed};
                    render.run();
                    render.write(image);
                });
    return image;
}

}  // namespace ticker::oracle

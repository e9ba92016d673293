#include "Stages.h"

#include <raytracer/base/Error.h>
#include <raytracer/base/RenderObserver.h>
#include <raytracer/image/Image.h>
#include <raytracer/io/ImageWriter.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace raytracer::view {
namespace {

constexpr int kCoarser = 4;
// Each coarse pass has this many times the rays of the one before. With the handout's 50 rays all
// coarse passes cost about a fortieth of the whole picture.
constexpr int kMoreRays = 4;
constexpr int kTileWidth = 128;
constexpr int kTileHeight = 96;

class Stopper final : public RenderMonitor {
public:
    explicit Stopper(const std::function<bool()>& stop) : stop_(stop) {}
    void rowFinished(int, int, int) override {}
    [[nodiscard]] bool interrupted() const override { return stop_(); }

private:
    const std::function<bool()>& stop_;
};

class Stages {
public:
    Stages(const Scene& scene, const RenderSettings& settings, const Sink& sink,
           const std::function<bool()>& stop)
        : scene_(scene), settings_(settings), sink_(sink), stop_(stop), stopper_(stop) {
        settings_.monitor = &stopper_;
        settings_.region = {};
    }

    void run() {
        RenderSettings coarse = settings_;
        coarse.width = std::max(1, settings_.width / kCoarser);
        coarse.height = std::max(1, settings_.height / kCoarser);
        coarse.shadowRayCount = 1;
        for (int rays = 1; rays < settings_.dofRayCount || rays == 1; rays *= kMoreRays) {
            coarse.dofRayCount = rays;
            if (!addCoarse(coarse)) return;
            coarse.shadowRayCount = settings_.shadowRayCount;
        }
        if (!addTiles()) addWhole();
    }

private:
    [[nodiscard]] Image render(const RenderSettings& settings) const {
        seedRandom(settings.seed);  // for solutions that loop over the pixels themselves
        return Renderer{settings}.render(scene_);
    }

    bool addCoarse(const RenderSettings& coarse) {
        const ByteImage picture = toBytes(render(coarse));
        if (stop_()) return false;
        const int rays = coarse.dofRayCount;
        sink_({wholeFrame(), picture,
               std::to_string(rays) + " of " + std::to_string(settings_.dofRayCount) +
                   (settings_.dofRayCount == 1 ? " ray" : " rays"),
               0.0, false});
        return true;
    }

    [[nodiscard]] Region wholeFrame() const { return {0, 0, settings_.width, settings_.height}; }

    [[nodiscard]] std::vector<Region> tiles() const {
        std::vector<Region> tiles;
        for (int y = 0; y < settings_.height; y += kTileHeight)
            for (int x = 0; x < settings_.width; x += kTileWidth)
                tiles.push_back({x, y, std::min(kTileWidth, settings_.width - x),
                                 std::min(kTileHeight, settings_.height - y)});
        return tiles;
    }

    /// False for a solution that ignores regions.
    bool addTiles() {
        const std::vector<Region> all = tiles();
        const auto start = std::chrono::steady_clock::now();
        for (std::size_t i = 0; i < all.size(); ++i) {
            RenderSettings settings = settings_;
            settings.region = all[i];
            ByteImage picture;
            try {
                picture = toBytes(render(settings));
            } catch (const Error&) {
                return false;
            }
            if (stop_()) return true;
            if (picture.width != all[i].width || picture.height != all[i].height) return false;
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
            const double left = taken.count() / static_cast<double>(i + 1) *
                                static_cast<double>(all.size() - i - 1);
            sink_({all[i], std::move(picture), {}, left, i + 1 == all.size()});
        }
        return true;
    }

    void addWhole() {
        const ByteImage picture = toBytes(render(settings_));
        if (!stop_()) sink_({wholeFrame(), picture, {}, 0.0, true});
    }

    const Scene& scene_;
    RenderSettings settings_;
    const Sink& sink_;
    const std::function<bool()>& stop_;
    Stopper stopper_;
};

}  // namespace

void renderInStages(const Scene& scene, const RenderSettings& settings, const Sink& sink,
                    const std::function<bool()>& stop) {
    Stages{scene, settings, sink, stop}.run();
}

ByteImage renderWhole(const Scene& scene, const RenderSettings& settings) {
    seedRandom(settings.seed);
    return toBytes(Renderer{settings}.render(scene));
}

}  // namespace raytracer::view

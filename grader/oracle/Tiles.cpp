#include <grader/oracle/Tiles.h>

#include <raytracer/base/RenderObserver.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace ticker::oracle {
namespace {

// Small enough for 32 x 24 pixels to keep two threads busy, large enough to fill vectors.
constexpr int kTilePixels = 64;

class TileLoop {
public:
    TileLoop(int pixels, raytracer::RenderMonitor* monitor,
             const std::function<void(const Tile&, Workspace&)>& work)
        : pixels_(pixels),
          tiles_((pixels + kTilePixels - 1) / kTilePixels),
          monitor_(monitor),
          work_(work) {}

    void run() {
        try {
            const auto workspace = std::make_unique<Workspace>();
            for (int i = next_++; i < tiles_ && !stopped(); i = next_++)
                work_({i, i * kTilePixels, std::min(pixels_, (i + 1) * kTilePixels)}, *workspace);
        } catch (...) {
            const std::lock_guard lock{mutex_};
            if (!error_) error_ = std::current_exception();
            interrupted_ = true;
        }
    }

    bool finish() const {
        if (error_) std::rethrow_exception(error_);
        return !interrupted_;
    }
    [[nodiscard]] int tiles() const { return tiles_; }

private:
    bool stopped() {
        if (monitor_ != nullptr && monitor_->interrupted()) interrupted_ = true;
        return interrupted_;
    }

    int pixels_;
    int tiles_;
    raytracer::RenderMonitor* monitor_;
    const std::function<void(const Tile&, Workspace&)>& work_;
    std::atomic<int> next_{0};
    std::atomic<bool> interrupted_{false};
    std::mutex mutex_;
    std::exception_ptr error_;
};

}  // namespace

bool forEachTile(int pixels, int threads, raytracer::RenderMonitor* monitor,
                 const std::function<void(const Tile&, Workspace&)>& work) {
    TileLoop loop{pixels, monitor, work};
    std::vector<std::jthread> helpers;
    for (int i = 1; i < std::min(threads, loop.tiles()); ++i)
        helpers.emplace_back([&loop] { loop.run(); });
    loop.run();
    helpers.clear();
    return loop.finish();
}

}  // namespace ticker::oracle

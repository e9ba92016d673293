#include <raytracer/base/RenderObserver.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/ForEachPixel.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace raytracer {
namespace {

// Any odd multiplier works: seeding the generator mixes the bits.
std::uint64_t pixelSeed(std::uint64_t seed, int column, int row) {
    return seed * 0xD1342543DE82EF95U + (static_cast<std::uint64_t>(row) << 32U) +
           static_cast<std::uint64_t>(column);
}

/// Distributes the rows of an image over threads that all run `work`.
class RowLoop {
public:
    RowLoop(const Image& image, const std::function<void(int, int)>& function)
        : image_(image), function_(function) {}

    void work() {
        try {
            for (int row = next_++; row < image_.height() && !stopped(); row = next_++) {
                renderRow(row);
                report(row);
            }
        } catch (...) {
            const std::lock_guard lock{mutex_};
            if (!error_) error_ = std::current_exception();
        }
    }

    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

private:
    [[nodiscard]] bool stopped() {
        const RenderMonitor* monitor = image_.settings().monitor;
        if (monitor != nullptr && monitor->interrupted()) return true;
        const std::lock_guard lock{mutex_};
        return error_ != nullptr;
    }

    void renderRow(int row) const {
        const RenderSettings& settings = image_.settings();
        const Region region = settings.region.isWholeFrame() ? Region{} : settings.region;
        for (int x = 0; x < image_.width(); ++x) {
            seedRandom(pixelSeed(settings.seed, region.x + x, region.y + row));
            function_(x, row);
        }
    }

    void report(int row) {
        RenderMonitor* monitor = image_.settings().monitor;
        const int done = ++done_;
        if (monitor != nullptr) monitor->rowFinished(row, done, image_.height());
    }

    const Image& image_;
    const std::function<void(int, int)>& function_;
    std::atomic<int> next_{0};
    std::atomic<int> done_{0};
    std::mutex mutex_;
    std::exception_ptr error_;
};

/// Threads that are joined on destruction, also after an exception, like std::jthread, which not
/// every standard library has.
class Helpers {
public:
    Helpers() = default;
    ~Helpers() {
        for (std::thread& thread : threads_)
            thread.join();
    }
    Helpers(const Helpers&) = delete;
    Helpers& operator=(const Helpers&) = delete;

    void start(const std::function<void()>& work) { threads_.emplace_back(work); }

private:
    std::vector<std::thread> threads_;
};

}  // namespace

void forEachPixel(const Image& image, const std::function<void(int x, int y)>& function) {
    RowLoop loop{image, function};
    const int threads = std::clamp(image.settings().threads, 1, image.height());
    {
        Helpers helpers;
        for (int i = 1; i < threads; ++i)
            helpers.start([&loop] { loop.work(); });
        loop.work();
    }
    // Numbers drawn after the loop must not depend on the last pixel that this thread rendered.
    seedRandom(pixelSeed(image.settings().seed, -1, -1));
    loop.rethrow();
}

}  // namespace raytracer

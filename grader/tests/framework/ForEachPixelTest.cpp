#include <raytracer/base/RenderObserver.h>
#include <raytracer/math/Random.h>
#include <raytracer/math/Vector3.h>
#include <raytracer/render/ForEachPixel.h>

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace raytracer {
namespace {

RenderSettings sized(int width, int height, int threads) {
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.threads = threads;
    settings.seed = 42;
    return settings;
}

Image randomPicture(const RenderSettings& settings) {
    Image image{settings};
    forEachPixel(image, [&image](int x, int y) {
        const double first = randomBetween(0.0, 1.0);
        image.set(x, y, {first, Vector3::randomInsideUnitSphere().x, randomBetween(-1.0, 1.0)});
    });
    return image;
}

/// Stops the loop once `rowsWanted` rows are finished.
class StoppingMonitor : public RenderMonitor {
public:
    explicit StoppingMonitor(int rowsWanted) : rowsWanted_(rowsWanted) {}

    void rowFinished(int row, int done, int rows) override {
        const std::lock_guard lock{mutex_};
        finished.insert(row);
        counts.insert(done);
        rowsInAll = rows;
    }
    [[nodiscard]] bool interrupted() const override {
        const std::lock_guard lock{mutex_};
        return static_cast<int>(finished.size()) >= rowsWanted_;
    }

    std::set<int> finished;
    std::set<int> counts;
    int rowsInAll = 0;

private:
    int rowsWanted_;
    mutable std::mutex mutex_;
};

TEST(ForEachPixel, VisitsEveryPixelOnce) {
    for (const int threads : {1, 2, 4, 100}) {
        const Image image{sized(13, 7, threads)};
        std::vector<std::atomic<int>> visits(13 * 7);
        forEachPixel(image,
                     [&visits](int x, int y) { ++visits[static_cast<std::size_t>(y * 13 + x)]; });
        for (const std::atomic<int>& count : visits)
            EXPECT_EQ(count, 1) << threads << " threads";
    }
}

TEST(ForEachPixel, GivesOnePictureWhateverTheThreads) {
    const Image one = randomPicture(sized(31, 17, 1));
    EXPECT_EQ(randomPicture(sized(31, 17, 2)).pixels(), one.pixels());
    EXPECT_EQ(randomPicture(sized(31, 17, 4)).pixels(), one.pixels());
}

TEST(ForEachPixel, GivesEachPixelItsOwnDraws) {
    const Image image = randomPicture(sized(40, 30, 1));
    std::set<double> values;
    for (const ColourRGB& colour : image.pixels())
        values.insert(colour.r);
    // Two of 1200 draws of 53 bits are equal with probability 8e-11.
    EXPECT_EQ(values.size(), image.pixels().size());
    RenderSettings other = sized(40, 30, 1);
    other.seed = 43;
    EXPECT_NE(randomPicture(other).pixels(), image.pixels());
}

TEST(ForEachPixel, GivesARegionTheDrawsOfTheWhole) {
    const Image whole = randomPicture(sized(31, 17, 1));
    RenderSettings cut = sized(31, 17, 2);
    cut.region = {5, 3, 11, 9};
    const Image region = randomPicture(cut);
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 11; ++x)
            EXPECT_EQ(region.at(x, y), whole.at(x + 5, y + 3));
    }
}

TEST(ForEachPixel, LeavesTheGeneratorAlikeWhateverTheThreads) {
    const auto drawAfter = [](int threads) {
        static_cast<void>(randomPicture(sized(9, 50, threads)));
        return randomBetween(0.0, 1.0);
    };
    const double afterOne = drawAfter(1);
    EXPECT_EQ(drawAfter(4), afterOne);
    EXPECT_EQ(drawAfter(4), afterOne);
}

TEST(ForEachPixel, LetsAnExceptionOutAndStops) {
    for (const int threads : {1, 4}) {
        const Image image{sized(10, 1000, threads)};
        std::atomic<int> calls{0};
        const auto throwing = [&calls](int x, int /*y*/) {
            ++calls;
            if (x == 3) throw std::runtime_error("from a pixel");
        };
        EXPECT_THROW(forEachPixel(image, throwing), std::runtime_error);
        EXPECT_LE(calls, 4 * threads);  // no thread begins another row after it threw
    }
}

TEST(ForEachPixel, ReportsEachRowOnce) {
    for (const int threads : {1, 3}) {
        StoppingMonitor monitor{1000};
        RenderSettings settings = sized(4, 20, threads);
        settings.monitor = &monitor;
        static_cast<void>(randomPicture(settings));
        EXPECT_EQ(monitor.finished.size(), 20U);
        EXPECT_EQ(monitor.counts.size(), 20U);
        EXPECT_EQ(*monitor.counts.rbegin(), 20);
        EXPECT_EQ(monitor.rowsInAll, 20);
    }
}

TEST(ForEachPixel, StopsWhenTheMonitorIsInterrupted) {
    StoppingMonitor monitor{5};
    RenderSettings settings = sized(4, 20, 1);
    settings.monitor = &monitor;
    const Image image = randomPicture(settings);
    EXPECT_EQ(monitor.finished.size(), 5U);
    EXPECT_NE(image.at(0, 4), ColourRGB());
    EXPECT_EQ(image.at(0, 5), ColourRGB());  // the rest stays black
}

}  // namespace
}  // namespace raytracer

#include <grader/metrics/Noise.h>

#include <grader/metrics/StudentT.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace ticker::metrics {
namespace {

// Width of a coarse tile in fine tiles, for noiseTiles.
constexpr int kCoarser = 4;

struct Score {
    double score = 0.0;
    double probability = 1.0;
};

/// One tile: pixels from (x0, y0) up to but not (x1, y1).
struct Tile {
    int x0, y0, x1, y1;
};

std::size_t indexOf(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
}

TileTest testTiles(int width, int height, int tileSize, const std::function<Score(Tile)>& judge) {
    const int across = (width + tileSize - 1) / tileSize;
    const int down = (height + tileSize - 1) / tileSize;
    TileTest test{
        .tileSize = tileSize, .score = {across, down, {}}, .probability = {across, down, {}}};
    for (int ty = 0; ty < down; ++ty)
        for (int tx = 0; tx < across; ++tx) {
            const Score score =
                judge({tx * tileSize, ty * tileSize, std::min((tx + 1) * tileSize, width),
                       std::min((ty + 1) * tileSize, height)});
            test.score.values.push_back(static_cast<float>(score.score));
            test.probability.values.push_back(static_cast<float>(score.probability));
            test.smallest = std::min(test.smallest, score.probability);
        }
    return test;
}

/// Corrects for `tests` tests in all (Bonferroni) and counts the significant tiles.
void correct(TileTest& test, double tests, double alpha) {
    test.smallest = std::min(1.0, test.smallest * tests);
    test.threshold = alpha / tests;
    test.differing = static_cast<int>(
        std::count_if(test.probability.values.begin(), test.probability.values.end(),
                      [&](float p) { return static_cast<double>(p) < test.threshold; }));
}

void requireTiles(int tileSize) {
    if (tileSize < 1) throw raytracer::InputError("", 0, "tiles must be 1 pixel wide or more");
}

Score welch(const Moments& a, const Moments& b, const Tile& tile) {
    double difference = 0.0;
    double variance = 0.0;
    double spread = 0.0;  // Satterthwaite's denominator
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) {
            const std::size_t i = indexOf(x, y, a.mean.width);
            difference +=
                static_cast<double>(b.mean.values[i]) - static_cast<double>(a.mean.values[i]);
            for (const Moments* m : {&a, &b}) {
                const double part = static_cast<double>(m->variance.values[i]) / m->renders;
                variance += part;
                spread += part * part / (m->renders - 1.0);
            }
        }
    if (!(variance > 0.0)) {
        if (difference == 0.0) return {};
        return {std::copysign(std::numeric_limits<double>::infinity(), difference), 0.0};
    }
    const double t = difference / std::sqrt(variance);
    return {t, twoSidedTail(t, variance * variance / spread)};
}

/// A sum of terms whose signs are random if the pictures are equal but for noise.
struct SignTest {
    double sum = 0.0;
    double squares = 0.0;

    void add(double term) {
        sum += term;
        squares += term * term;
    }
    [[nodiscard]] double score() const { return squares > 0.0 ? sum / std::sqrt(squares) : 0.0; }
};

constexpr double kTestsOfEachChannel = 3.0;

/// The tests of one channel: of the differences, and of the products of neighbours.
double worstScore(const ByteView& reference, const ByteView& test, const Tile& tile,
                  std::size_t channel) {
    const auto difference = [&](int x, int y) {
        const std::size_t i = indexOf(x, y, reference.width) * kChannels + channel;
        return static_cast<double>(int{test.rgb[i]} - int{reference.rgb[i]});
    };
    SignTest mean;
    SignTest across;
    SignTest down;
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) {
            const double here = difference(x, y);
            mean.add(here);
            if (x + 1 < tile.x1) across.add(here * difference(x + 1, y));
            if (y + 1 < tile.y1) down.add(here * difference(x, y + 1));
        }
    double worst = std::abs(mean.score());
    for (const SignTest& each : {across, down})
        worst = std::max(worst, std::abs(each.score()));
    return std::copysign(worst, mean.sum);
}

Score signs(const ByteView& reference, const ByteView& test, const Tile& tile) {
    Score worst;
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
        const double score = worstScore(reference, test, tile, channel);
        if (std::abs(score) > std::abs(worst.score)) worst.score = score;
    }
    const double bound = 2.0 * std::exp(-worst.score * worst.score / 2.0);
    worst.probability = std::min(1.0, kTestsOfEachChannel * static_cast<double>(kChannels) * bound);
    return worst;
}

/// Squared deviation of a byte from a plane through its neighbours, scaled so that its mean over
/// independent pixels is their variance.
double squaredDetail(const ByteView& picture, int x, int y, std::size_t channel) {
    constexpr std::array<int, 3> kStencil{1, -2, 1};
    constexpr double kSquares = 36.0;  // of the nine weights
    int sum = 0;
    for (int dy = 0; dy < 3; ++dy)
        for (int dx = 0; dx < 3; ++dx) {
            const int column = std::clamp(x + dx - 1, 0, picture.width - 1);
            const int row = std::clamp(y + dy - 1, 0, picture.height - 1);
            sum += kStencil[static_cast<std::size_t>(dx)] * kStencil[static_cast<std::size_t>(dy)] *
                   picture.rgb[indexOf(column, row, picture.width) * kChannels + channel];
        }
    return sum * sum / kSquares;
}

/// The fine tiles that lie in a coarse one.
Tile fineTilesIn(const TileTest& fine, int column, int row) {
    return {column * kCoarser, row * kCoarser, std::min((column + 1) * kCoarser, fine.score.width),
            std::min((row + 1) * kCoarser, fine.score.height)};
}

void forEachIn(const Tile& area, int width, const std::function<void(std::size_t)>& visit) {
    for (int y = area.y0; y < area.y1; ++y)
        for (int x = area.x0; x < area.x1; ++x)
            visit(indexOf(x, y, width));
}

/// If a coarse tile is significant but none of its fine tiles is, the fine ones take over its
/// score.
void takeOver(TileTest& fine, const TileTest& coarse, double threshold) {
    for (int row = 0; row < coarse.score.height; ++row)
        for (int column = 0; column < coarse.score.width; ++column) {
            const std::size_t i = indexOf(column, row, coarse.score.width);
            double least = 1.0;
            const Tile inside = fineTilesIn(fine, column, row);
            forEachIn(inside, fine.score.width, [&](std::size_t own) {
                least = std::min(least, static_cast<double>(fine.probability.values[own]));
            });
            if (static_cast<double>(coarse.probability.values[i]) >= threshold || least < threshold)
                continue;
            forEachIn(inside, fine.score.width, [&](std::size_t own) {
                fine.probability.values[own] = coarse.probability.values[i];
                fine.score.values[own] = coarse.score.values[i];
            });
        }
}

}  // namespace

TileTest welchTiles(const Moments& reference, const Moments& test, int tileSize, double alpha) {
    requireSameSize(reference.mean, test.mean);
    requireSameSize(reference.mean, reference.variance);
    requireSameSize(test.mean, test.variance);
    requireTiles(tileSize);
    if (!(reference.renders > 1.0 && test.renders > 1.0))
        throw raytracer::InputError("", 0, "Welch's test needs two renders or more of each");
    TileTest result = testTiles(reference.mean.width, reference.mean.height, tileSize,
                                [&](const Tile& tile) { return welch(reference, test, tile); });
    correct(result, static_cast<double>(result.score.values.size()), alpha);
    return result;
}

TileTest noiseTiles(const ByteView& reference, const ByteView& test, int tileSize, double alpha) {
    requireSameSize(reference, test);
    requireTiles(tileSize);
    const auto judge = [&](const Tile& tile) { return signs(reference, test, tile); };
    TileTest fine = testTiles(reference.width, reference.height, tileSize, judge);
    const TileTest coarse =
        testTiles(reference.width, reference.height, tileSize * kCoarser, judge);
    const auto tests = static_cast<double>(fine.score.values.size() + coarse.score.values.size());
    takeOver(fine, coarse, alpha / tests);
    fine.smallest = std::min(fine.smallest, coarse.smallest);
    correct(fine, tests, alpha);
    return fine;
}

double excessOverNoise(const ByteView& reference, const ByteView& test) {
    requireSameSize(reference, test);
    double differences = 0.0;
    double details = 0.0;
    for (int y = 0; y < test.height; ++y)
        for (int x = 0; x < test.width; ++x)
            for (std::size_t channel = 0; channel < kChannels; ++channel) {
                const std::size_t i = indexOf(x, y, test.width) * kChannels + channel;
                const double difference = int{test.rgb[i]} - int{reference.rgb[i]};
                if (difference == 0.0) continue;
                differences += difference * difference;
                details +=
                    squaredDetail(reference, x, y, channel) + squaredDetail(test, x, y, channel);
            }
    if (differences == 0.0) return 0.0;
    return differences / std::max(details, std::numeric_limits<double>::min());
}

Measured zMap(const Moments& reference, const Map& test, double testRenders, double floor) {
    requireSameSize(reference.mean, test);
    requireSameSize(reference.mean, reference.variance);
    const double share =
        1.0 / testRenders + (reference.renders > 0.0 ? 1.0 / reference.renders : 0.0);
    Measured result;
    result.map = {test.width, test.height, {}};
    for (std::size_t i = 0; i < test.values.size(); ++i) {
        const double variance =
            std::max(static_cast<double>(reference.variance.values[i]), floor) * share;
        const double difference =
            static_cast<double>(test.values[i]) - static_cast<double>(reference.mean.values[i]);
        const double z = difference / std::sqrt(variance);
        result.map.values.push_back(static_cast<float>(z));
        // Written so that NaN counts as the largest value.
        if (!(std::abs(z) <= result.value)) result.value = std::abs(z);
    }
    return result;
}

}  // namespace ticker::metrics

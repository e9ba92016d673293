#include <grader/metrics/Whereabouts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ticker::metrics {
namespace {

constexpr std::size_t kColours = 3;
constexpr int kSketchColumns = 40;
// Share of the tiles that the box leaves out on each side.
constexpr double kLeftOut = 0.1;

/// A tile that differs.
struct GridTile {
    int column = 0;
    int row = 0;
};

bool differs(const TileTest& noise, int column, int row) {
    const auto i = static_cast<std::size_t>(row * noise.score.width + column);
    return static_cast<double>(noise.probability.values[i]) < noise.threshold;
}

std::vector<GridTile> differingTiles(const TileTest& noise) {
    std::vector<GridTile> tiles;
    for (int row = 0; row < noise.score.height; ++row)
        for (int column = 0; column < noise.score.width; ++column)
            if (differs(noise, column, row)) tiles.push_back({column, row});
    return tiles;
}

/// Sums of differences over some pixels.
struct Sums {
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;

    Sums& operator+=(const Sums& other) {
        sum += other.sum;
        squares += other.squares;
        count += other.count;
        return *this;
    }
    [[nodiscard]] double mean() const { return count > 0.0 ? sum / count : 0.0; }
    [[nodiscard]] double rms() const { return count > 0.0 ? std::sqrt(squares / count) : 0.0; }
};

Patch pixelsOf(const GridTile& tile, const ByteView& picture, int tileSize) {
    return {tile.column * tileSize, tile.row * tileSize,
            std::min((tile.column + 1) * tileSize, picture.width),
            std::min((tile.row + 1) * tileSize, picture.height)};
}

Sums sumsOver(const Patch& patch, const ByteView& reference, const ByteView& test) {
    Sums sums;
    for (int y = patch.top; y < patch.bottom; ++y)
        for (int x = patch.left; x < patch.right; ++x)
            for (std::size_t channel = 0; channel < kColours; ++channel) {
                const std::size_t i =
                    (static_cast<std::size_t>(y) * static_cast<std::size_t>(test.width) +
                     static_cast<std::size_t>(x)) *
                        kColours +
                    channel;
                const double difference = int{test.rgb[i]} - int{reference.rgb[i]};
                sums += {difference, difference * difference, 1.0};
            }
    return sums;
}

/// The ends of a range that holds all numbers except the lowest and the highest tenth.
std::pair<int, int> middleOf(std::vector<int> numbers) {
    std::sort(numbers.begin(), numbers.end());
    const auto cut = static_cast<std::size_t>(kLeftOut * static_cast<double>(numbers.size()));
    return {numbers[cut], numbers[numbers.size() - 1 - cut]};
}

std::string wordsFor(const std::vector<GridTile>& tiles, const TileTest& noise) {
    double x = 0.0;
    double y = 0.0;
    for (const GridTile& tile : tiles) {
        x += (tile.column + 0.5) / noise.score.width;
        y += (tile.row + 0.5) / noise.score.height;
    }
    const auto third = [&](double sum, const char* low, const char* high) {
        const double middle = sum / static_cast<double>(tiles.size());
        return std::string{middle < 1.0 / 3.0 ? low : middle > 2.0 / 3.0 ? high : ""};
    };
    const std::string vertical = third(y, "top", "bottom");
    const std::string horizontal = third(x, "left", "right");
    if (vertical.empty() && horizontal.empty()) return "around the centre";
    return "towards the " + vertical + (vertical.empty() || horizontal.empty() ? "" : " ") +
           horizontal;
}

/// '+' or '-', the sign of the mean difference, if that is three standard errors or more from 0;
/// otherwise '~'.
char symbolFor(const Sums& sums) {
    const double error = sums.rms() / std::sqrt(std::max(1.0, sums.count));
    if (std::abs(sums.mean()) < 3.0 * error) return '~';
    return sums.mean() < 0.0 ? '-' : '+';
}

}  // namespace

Whereabouts whereabouts(const ByteView& reference, const ByteView& test, const TileTest& noise) {
    const std::vector<GridTile> tiles = differingTiles(noise);
    Whereabouts where;
    if (tiles.empty()) return where;
    std::vector<int> columns;
    std::vector<int> rows;
    Sums all;
    for (const GridTile& tile : tiles) {
        Patch patch = pixelsOf(tile, test, noise.tileSize);
        const Sums sums = sumsOver(patch, reference, test);
        patch.meanDifference = sums.mean();
        patch.rmse = sums.rms();
        if (where.worst.right == 0 || patch.rmse > where.worst.rmse) where.worst = patch;
        all += sums;
        columns.push_back(tile.column);
        rows.push_back(tile.row);
    }
    const auto [left, right] = middleOf(std::move(columns));
    const auto [top, bottom] = middleOf(std::move(rows));
    const Patch first = pixelsOf({left, top}, test, noise.tileSize);
    const Patch last = pixelsOf({right, bottom}, test, noise.tileSize);
    where.box = {first.left, first.top, last.right, last.bottom, all.mean(), all.rms()};
    where.words = wordsFor(tiles, noise);
    return where;
}

std::string sketch(const ByteView& reference, const ByteView& test, const TileTest& noise) {
    // A character is about twice as high as it is wide.
    const int across = (noise.score.width + kSketchColumns - 1) / kSketchColumns;
    const int down = 2 * across;
    std::string text;
    for (int top = 0; top < noise.score.height; top += down) {
        for (int left = 0; left < noise.score.width; left += across) {
            Sums sums;
            for (int row = top; row < std::min(top + down, noise.score.height); ++row)
                for (int column = left; column < std::min(left + across, noise.score.width);
                     ++column)
                    if (differs(noise, column, row))
                        sums += sumsOver(pixelsOf({column, row}, test, noise.tileSize), reference,
                                         test);
            text += sums.count > 0.0 ? symbolFor(sums) : '.';
        }
        text += '\n';
    }
    return text;
}

}  // namespace ticker::metrics

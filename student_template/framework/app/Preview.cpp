#include "Preview.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace raytracer {
namespace {

using Bytes = std::array<std::uint8_t, 3>;

constexpr std::string_view kUpperHalfBlock = "\u2580";

/// The picture scaled down to two samples for each cell, one above the other.
class Samples {
public:
    Samples(const ByteImage& picture, const Terminal& terminal) : picture_(picture) {
        const double across = std::max(1, terminal.columns - 1);
        const double down = 2.0 * std::max(1, terminal.lines - 2);
        step_ = std::max({1.0, picture.width / across, picture.height / down});
        columns_ = std::max(1, static_cast<int>(picture.width / step_));
        rows_ = std::max(1, static_cast<int>(picture.height / step_));
    }

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }

    /// The mean of the bytes of one sample's pixels; black below the picture.
    [[nodiscard]] Bytes at(int column, int row) const {
        if (row >= rows_) return {};
        std::array<unsigned, 3> sum{};
        const Span across = spanOf(column, picture_.width);
        const Span down = spanOf(row, picture_.height);
        for (int y = down.from; y < down.to; ++y)
            for (int x = across.from; x < across.to; ++x)
                for (std::size_t channel = 0; channel < sum.size(); ++channel)
                    sum[channel] += picture_.rgb[indexOf(x, y) + channel];
        const auto count = static_cast<unsigned>((across.to - across.from) * (down.to - down.from));
        return {static_cast<std::uint8_t>(sum[0] / count),
                static_cast<std::uint8_t>(sum[1] / count),
                static_cast<std::uint8_t>(sum[2] / count)};
    }

private:
    struct Span {
        int from;
        int to;
    };
    [[nodiscard]] Span spanOf(int sample, int size) const {
        const int from = std::min(static_cast<int>(sample * step_), size - 1);
        const int to = std::min(static_cast<int>((sample + 1) * step_), size);
        return {from, std::max(to, from + 1)};
    }

    [[nodiscard]] std::size_t indexOf(int x, int y) const {
        return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
                    static_cast<std::size_t>(x));
    }

    const ByteImage& picture_;
    double step_ = 1.0;
    int columns_ = 1;
    int rows_ = 1;
};

/// The nearest colour of xterm's cube of 6 x 6 x 6, or of its 24 greys.
int colourOf256(const Bytes& colour) {
    const auto [low, high] = std::minmax({colour[0], colour[1], colour[2]});
    if (high - low < 12) {
        const int grey = (high + low) / 2;
        if (grey < 4) return 16;
        return grey > 246 ? 231 : 232 + std::min(23, (grey - 3) / 10);
    }
    constexpr std::array<int, 6> kLevels{0, 95, 135, 175, 215, 255};
    const auto level = [&](int value) {
        const auto nearest =
            std::min_element(kLevels.begin(), kLevels.end(), [value](int one, int other) {
                return std::abs(one - value) < std::abs(other - value);
            });
        return static_cast<int>(nearest - kLevels.begin());
    };
    return 16 + 36 * level(colour[0]) + 6 * level(colour[1]) + level(colour[2]);
}

/// The parameters of an escape sequence that select a colour.
std::string chosen(const Bytes& colour, Palette palette) {
    if (palette == Palette::colours256) return "5;" + std::to_string(colourOf256(colour));
    return "2;" + std::to_string(colour[0]) + ";" + std::to_string(colour[1]) + ";" +
           std::to_string(colour[2]);
}

std::string colourLine(const Samples& samples, int row, Palette palette) {
    std::string line;
    std::string before;
    for (int column = 0; column < samples.columns(); ++column) {
        const std::string colours = "\033[38;" + chosen(samples.at(column, row), palette) + ";48;" +
                                    chosen(samples.at(column, row + 1), palette) + "m";
        if (colours != before) line += colours;
        before = colours;
        line += kUpperHalfBlock;
    }
    return line + "\033[0m";
}

std::string textLine(const Samples& samples, int row) {
    constexpr std::string_view kInk = " .:-=+*#%@";
    constexpr std::size_t kBrightest = std::size_t{2} * (3 + 6 + 1) * 256;
    std::string line;
    for (int column = 0; column < samples.columns(); ++column) {
        int sum = 0;
        for (const Bytes& colour : {samples.at(column, row), samples.at(column, row + 1)})
            sum += 3 * colour[0] + 6 * colour[1] + colour[2];
        line += kInk[static_cast<std::size_t>(sum) * kInk.size() / kBrightest];
    }
    return line;
}

}  // namespace

std::string Preview::frame(const ByteImage& picture) {
    const Samples samples{picture, terminal_};
    std::string text;
    if (linesDrawn_ > 0) text = "\r\033[" + std::to_string(linesDrawn_) + "A";
    linesDrawn_ = 0;
    for (int row = 0; row < samples.rows(); row += 2) {
        text += terminal_.palette == Palette::text ? textLine(samples, row)
                                                   : colourLine(samples, row, terminal_.palette);
        text += terminal_.redraws ? "\033[K\n" : "\n";
        ++linesDrawn_;
    }
    return text;
}

}  // namespace raytracer

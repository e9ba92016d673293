#include "LetterAsset.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace assets {
namespace {

constexpr int kWidth = 2048;
constexpr int kHeight = 1024;
constexpr int kColumns = 12;  // letters around the sphere
constexpr int kRows = 6;      // the first and the last stay empty: too close to the poles
constexpr int kGround = 128;
constexpr int kBevelWidth = 6;      // texels
constexpr int kStepsPerTexel = 20;  // bytes: a tilt of 21 degrees

/// Part of a letter; texels relative to the letter's middle, both ends included.
struct Bar {
    int left, top, right, bottom;
};

constexpr auto kLetterH =
    std::to_array<Bar>({{-48, -60, -20, 60}, {20, -60, 48, 60}, {-34, -14, 34, 14}});
constexpr auto kLetterL = std::to_array<Bar>({{-40, -60, -12, 60}, {-40, 32, 42, 60}});

// Depth inside of the bar: 0 outside, 1 on its outermost texels.
int depthIn(const Bar& bar, int x, int y) {
    return std::max(0, 1 + std::min({x - bar.left, bar.right - x, y - bar.top, bar.bottom - y}));
}

int depthIn(std::span<const Bar> letter, int x, int y) {
    int depth = 0;
    for (const Bar& bar : letter)
        depth = std::max(depth, depthIn(bar, x, y));
    return depth;
}

std::uint8_t heightAt(int column, int row) {
    const int cellColumn = column * kColumns / kWidth;
    const int cellRow = row * kRows / kHeight;
    if (cellRow == 0 || cellRow == kRows - 1) return kGround;
    const int x = column - (2 * cellColumn + 1) * kWidth / (2 * kColumns);
    const int y = row - (2 * cellRow + 1) * kHeight / (2 * kRows);
    const bool raised = (cellColumn + cellRow) % 2 == 0;
    const int depth = raised ? depthIn(kLetterH, x, y) : depthIn(kLetterL, x, y);
    const int step = kStepsPerTexel * std::min(depth, kBevelWidth);
    return static_cast<std::uint8_t>(kGround + (raised ? step : -step));
}

}  // namespace

raytracer::ByteImage makeLetterMap() {
    raytracer::ByteImage map{kWidth, kHeight, {}};
    map.rgb.reserve(std::size_t{3} * kWidth * kHeight);
    for (int row = 0; row < kHeight; ++row)
        for (int column = 0; column < kWidth; ++column)
            map.rgb.insert(map.rgb.end(), 3, heightAt(column, row));
    return map;
}

}  // namespace assets

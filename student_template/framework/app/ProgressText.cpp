#include "ProgressText.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace raytracer {
namespace {

constexpr int kBarWidth = 30;

std::string durationText(double seconds) {
    const long whole = std::lround(seconds);
    if (whole < 60) return std::to_string(whole) + " s";
    if (whole < 3600)
        return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

}  // namespace

std::string progressText(int done, int all, double seconds) {
    const int filled = kBarWidth * done / std::max(1, all);
    const std::string percent = std::to_string(100 * done / std::max(1, all));
    std::string text = "[";
    text.append(static_cast<std::size_t>(filled), '#');
    text.append(static_cast<std::size_t>(kBarWidth - filled), '-');
    text += "] ";
    text.append(3 - std::min<std::size_t>(3, percent.size()), ' ');
    text += percent + " %";
    if (done == 0) return text;
    return text + ", " + durationText(seconds * (all - done) / done) + " left";
}

}  // namespace raytracer

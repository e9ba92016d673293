#include <grader/tasks/bump/words/Phrases.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ticker::tasks::bump {

std::string percent(double share) {
    const double value = 100.0 * share;
    return value > 0.0 && value < 1.0 ? fmt::format("{:.2g} %", value)
                                      : fmt::format("{:.0f} %", value);
}

std::string quoted(const std::string& text) {
    constexpr std::size_t kLongest = 160;
    std::string line = text.substr(0, kLongest);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return line.size() < text.size() ? line + "..." : line;
}

std::string pointsOf(const Offence& offence) {
    return fmt::format("{:.0f} of {:.0f} points", offence.count, offence.asked);
}

std::string firstAt(const Offence& offence) {
    return fmt::format("{}, on a map of {} x {} texels", placeInWords(offence.direction),
                       offence.width, offence.height);
}

std::string placeInWords(const Vector3& direction) {
    const double latitude = std::asin(std::clamp(direction.y, -1.0, 1.0)) * kDegrees;
    const double longitude = std::atan2(direction.x, -direction.z) * kDegrees;
    if (std::abs(latitude) > 89.9) return latitude > 0.0 ? "at the top pole" : "at the bottom pole";
    return fmt::format(
        "{:.1f} degrees {} the equator and {:.1f} degrees {} of the meridian nearest "
        "to the camera",
        std::abs(latitude), latitude < 0.0 ? "below" : "above", std::abs(longitude),
        longitude < 0.0 ? "left" : "right");
}

}  // namespace ticker::tasks::bump

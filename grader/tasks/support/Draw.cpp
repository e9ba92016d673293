#include <grader/tasks/support/Draw.h>

#include <grader/base/SplitMix.h>

#include <cmath>
#include <numbers>

namespace ticker::tasks {

Draw::Draw(std::uint64_t seed, std::uint64_t purpose)
    : state_(seed ^ (purpose * 0xD1342543DE82EF95U)) {
    state_ = word();
}

std::uint64_t Draw::word() {
    return splitMix(state_);
}

double Draw::between(double low, double high) {
    return low + (high - low) * (static_cast<double>(word() >> 11U) * 0x1p-53);
}

int Draw::whole(int low, int high) {
    return low + static_cast<int>(word() % static_cast<std::uint64_t>(high - low + 1));
}

Vector3 Draw::direction() {
    const double z = between(-1.0, 1.0);
    const double angle = between(0.0, 2.0 * std::numbers::pi);
    const double ring = std::sqrt(1.0 - z * z);
    return {ring * std::cos(angle), ring * std::sin(angle), z};
}

Vector3 Draw::directionAround(const Vector3& axis, double maxAngle) {
    const Perpendiculars sides = perpendicularsOf(axis);
    const double away = between(0.0, maxAngle);
    const double around = between(0.0, 2.0 * std::numbers::pi);
    return axis * std::cos(away) +
           (sides.first * std::cos(around) + sides.second * std::sin(around)) * std::sin(away);
}

ColourRGB Draw::colour(double low, double high) {
    const double r = between(low, high);
    const double g = between(low, high);
    const double b = between(low, high);
    return {r, g, b};
}

Perpendiculars perpendicularsOf(const Vector3& axis) {
    const Vector3 helper = std::abs(axis.x) < 0.6 ? Vector3{1.0, 0.0, 0.0} : Vector3{0.0, 1.0, 0.0};
    const Vector3 first = axis.cross(helper).normalised();
    return {first, axis.cross(first)};
}

}  // namespace ticker::tasks

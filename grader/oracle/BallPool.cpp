#include <grader/oracle/BallPool.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

namespace ticker::oracle {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

AimPoint onSphere(double radius, double height, double turn) {
    const double across = radius * std::sqrt(std::max(0.0, 1.0 - height * height));
    return {across * std::cos(kTurn * turn), across * std::sin(kTurn * turn), radius * height};
}

double fraction(double value) {
    return value - std::floor(value);
}

// Consecutive points of the sequence are stratified, not independent; a random order makes the few
// points of one vector nearly independent.
std::vector<std::uint32_t> shuffled(std::size_t count) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::minstd_rand engine{20260721};
    for (std::size_t i = count - 1; i > 0; --i)
        std::swap(order[i], order[engine() % (i + 1)]);
    return order;
}

}  // namespace

AimPoint aimPoint(LightShape shape, double u, double v, double w) {
    switch (shape) {
        case LightShape::ball:
            return onSphere(std::cbrt(u), 2.0 * v - 1.0, w);
        case LightShape::surface:
            return onSphere(1.0, 2.0 * v - 1.0, w);
        case LightShape::uniformRadius:
            return onSphere(u, 2.0 * v - 1.0, w);
        case LightShape::polarHelper:
            return onSphere(u, std::cos(std::numbers::pi * v), w);
        case LightShape::cube:
            return {2.0 * u - 1.0, 2.0 * v - 1.0, 2.0 * w - 1.0};
        case LightShape::disc:
            return onSphere(std::sqrt(u), 0.0, w);
        case LightShape::halfBall: {
            const AimPoint point = onSphere(std::cbrt(u), v, w);
            return {point.x, point.z, point.y};
        }
        case LightShape::centre:
            break;
    }
    return {};
}

BallPool::BallPool(LightShape shape, double radius)
    : x(kSize),
      y(kSize),
      z(kSize),
      flipX(0x80000000U),
      flipY(shape == LightShape::halfBall ? 0U : 0x80000000U),
      flipZ(0x80000000U) {
    const std::vector<std::uint32_t> order = shuffled(kSize);
    for (std::size_t i = 0; i < kSize; ++i) {
        const double step = order[i] + 1.0;
        const AimPoint point = aimPoint(shape, fraction(0.5 + step * 0.8191725133961645),
                                        fraction(0.5 + step * 0.6710436067037893),
                                        fraction(0.5 + step * 0.5497004779019703));
        x[i] = static_cast<float>(radius * point.x);
        y[i] = static_cast<float>(radius * point.y);
        z[i] = static_cast<float>(radius * point.z);
    }
}

}  // namespace ticker::oracle

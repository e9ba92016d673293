#include <grader/metrics/StudentT.h>

#include <cmath>
#include <initializer_list>
#include <limits>

namespace ticker::metrics {
namespace {

/// The continued fraction of the incomplete beta function, by Lentz's method.
/// @see  Abramowitz and Stegun, 26.5.8.
double betaFraction(double a, double b, double x) {
    constexpr int kMostTerms = 10'000;
    constexpr double kTiny = 1e-300;
    const auto away = [](double value) { return std::abs(value) < kTiny ? kTiny : value; };
    double c = 1.0;
    double d = 1.0 / away(1.0 - (a + b) * x / (a + 1.0));
    double fraction = d;
    for (int m = 1; m < kMostTerms; ++m) {
        const double k = m;
        const double even = k * (b - k) * x / ((a + 2.0 * k - 1.0) * (a + 2.0 * k));
        const double odd = -(a + k) * (a + b + k) * x / ((a + 2.0 * k) * (a + 2.0 * k + 1.0));
        double step = 1.0;
        for (const double term : {even, odd}) {
            d = 1.0 / away(1.0 + term * d);
            c = away(1.0 + term / c);
            step = c * d;
            fraction *= step;
        }
        if (std::abs(step - 1.0) < 4.0 * std::numeric_limits<double>::epsilon()) break;
    }
    return fraction;
}

/// The regularised incomplete beta function I_x(a, b).
double incompleteBeta(double a, double b, double x) {
    if (x <= 0.0) return 0.0;
    if (x >= 1.0) return 1.0;
    const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) +
                                  a * std::log(x) + b * std::log1p(-x));
    // Both forms are correct; this one converges fast here.
    if (x < (a + 1.0) / (a + b + 2.0)) return front * betaFraction(a, b, x) / a;
    return 1.0 - front * betaFraction(b, a, 1.0 - x) / b;
}

}  // namespace

double twoSidedTail(double t, double degrees) {
    if (std::isnan(t) || std::isnan(degrees)) return std::numeric_limits<double>::quiet_NaN();
    if (std::isinf(t)) return 0.0;
    return incompleteBeta(degrees / 2.0, 0.5, degrees / (degrees + t * t));
}

}  // namespace ticker::metrics

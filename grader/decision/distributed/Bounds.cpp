#include <grader/decision/distributed/Bounds.h>

#include <algorithm>
#include <cmath>

namespace ticker::decision {

double dkwBound(std::size_t count, double risk) {
    if (count == 0) return 1.0;
    return std::min(1.0, std::sqrt(std::log(2.0 / risk) / (2.0 * static_cast<double>(count))));
}

double missedShare(std::size_t count, double risk) {
    if (count == 0) return 1.0;
    return 1.0 - std::exp(std::log(risk) / static_cast<double>(count));
}

double chernoffTail(std::size_t hits, std::size_t count, double p) {
    if (count == 0) return 1.0;
    const double share = static_cast<double>(hits) / static_cast<double>(count);
    const auto part = [](double a, double b) { return a > 0.0 ? a * std::log(a / b) : 0.0; };
    return std::exp(-static_cast<double>(count) * (part(share, p) + part(1.0 - share, 1.0 - p)));
}

double largestGap(std::vector<double> samples, const std::function<double(double)>& distribution) {
    std::sort(samples.begin(), samples.end());
    const double count = static_cast<double>(samples.size());
    double gap = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double expected = distribution(samples[i]);
        gap = std::max({gap, expected - static_cast<double>(i) / count,
                        static_cast<double>(i + 1) / count - expected});
    }
    return gap;
}

double largestGap(std::vector<double> left, std::vector<double> right) {
    std::sort(right.begin(), right.end());
    const double count = static_cast<double>(right.size());
    return largestGap(std::move(left), [&](double value) {
        const auto below = std::upper_bound(right.begin(), right.end(), value) - right.begin();
        return static_cast<double>(below) / count;
    });
}

}  // namespace ticker::decision

#include <grader/tasks/support/Bounds.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks {

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

double largestGap(const std::vector<double>& left, const std::vector<double>& right, double size) {
    const double leftShare = 1.0 / static_cast<double>(std::max<std::size_t>(left.size(), 1));
    const double rightShare = 1.0 / static_cast<double>(std::max<std::size_t>(right.size(), 1));
    double gap = 0.0;
    std::size_t below = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
        while (below < right.size() && right[below] <= left[i] / size)
            ++below;
        const double expected = static_cast<double>(below) * rightShare;
        gap = std::max({gap, expected - static_cast<double>(i) * leftShare,
                        static_cast<double>(i + 1) * leftShare - expected});
    }
    return gap;
}

}  // namespace ticker::tasks

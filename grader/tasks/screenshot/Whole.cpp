#include <grader/tasks/screenshot/Whole.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace ticker::tasks::screenshot {
namespace {

constexpr int kAcross = 20;
constexpr int kDown = 15;
// The largest value of 120 honest pictures was 4.0.
constexpr double kOff = 5.0;
constexpr std::size_t kTerms = ColourChange::kTerms;

using Terms = std::array<double, kTerms>;

Picture small(const ByteView& picture) {
    return metrics::resized(picture, kSmallWidth, kSmallHeight);
}

Picture tilesOf(const ByteView& picture) {
    return metrics::resized(picture, kAcross, kDown);
}

Terms termsOf(const std::uint8_t* rgb) {
    const double r = rgb[0] / 255.0;
    const double g = rgb[1] / 255.0;
    const double b = rgb[2] / 255.0;
    return {1.0, r, g, b, r * r, g * g, b * b};
}

// Gaussian elimination; the matrix is symmetric and positive definite, so it needs no pivots.
Terms solved(std::array<Terms, kTerms> matrix, Terms right) {
    for (std::size_t i = 0; i < kTerms; ++i)
        for (std::size_t row = i + 1; row < kTerms; ++row) {
            const double factor = matrix[row][i] / matrix[i][i];
            for (std::size_t k = i; k < kTerms; ++k)
                matrix[row][k] -= factor * matrix[i][k];
            right[row] -= factor * right[i];
        }
    for (std::size_t i = kTerms; i-- > 0;) {
        for (std::size_t k = i + 1; k < kTerms; ++k)
            right[i] -= matrix[i][k] * right[k];
        right[i] /= matrix[i][i];
    }
    return right;
}

}  // namespace

double likeness(const ByteView& reference, const ByteView& picture) {
    return metrics::correlation(small(reference).view(), small(picture).view());
}

TileDifference tileDifference(const ByteView& reference, const ByteView& picture) {
    const Picture first = tilesOf(reference);
    const Picture second = tilesOf(picture);
    TileDifference result;
    double squares = 0.0;
    for (int y = 0; y < kDown; ++y)
        for (int x = 0; x < kAcross; ++x) {
            const auto i = static_cast<std::size_t>(3 * (y * kAcross + x));
            double sum = 0.0;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const int off = int{second.rgb[i + channel]} - int{first.rgb[i + channel]};
                sum += std::abs(off);
                squares += off * off;
            }
            if (sum / 3.0 > kOff) ++result.tilesOff;
            if (sum / 3.0 <= result.worst) continue;
            result.worst = sum / 3.0;
            result.worstX = (x + 0.5) / kAcross;
            result.worstY = (y + 0.5) / kDown;
        }
    result.rms = std::sqrt(squares / (3.0 * kAcross * kDown));
    return result;
}

ColourChange::ColourChange(const ByteView& reference, const ByteView& picture) {
    const Picture from = tilesOf(reference);
    const Picture to = tilesOf(picture);
    std::array<Terms, kTerms> matrix{};
    std::array<Terms, 3> right{};
    for (std::size_t i = 0; i < from.rgb.size(); i += 3) {
        const Terms terms = termsOf(&from.rgb[i]);
        for (std::size_t row = 0; row < kTerms; ++row) {
            for (std::size_t column = 0; column < kTerms; ++column)
                matrix[row][column] += terms[row] * terms[column];
            for (std::size_t channel = 0; channel < 3; ++channel)
                right[channel][row] += terms[row] * to.rgb[i + channel];
        }
    }
    // Regularisation: with proportional channels, as in a grey picture, the solution is not unique.
    constexpr double kRidge = 1e-3;
    for (std::size_t row = 0; row < kTerms; ++row)
        matrix[row][row] += kRidge;
    for (std::size_t channel = 0; channel < 3; ++channel)
        weights_[channel] = solved(matrix, right[channel]);
}

Picture ColourChange::appliedTo(const ByteView& picture) const {
    Picture result{picture.width, picture.height, {}};
    result.rgb.resize(picture.rgb.size());
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
        const Terms terms = termsOf(&picture.rgb[i]);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            double value = 0.0;
            for (std::size_t k = 0; k < kTerms; ++k)
                value += weights_[channel][k] * terms[k];
            result.rgb[i + channel] =
                static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
        }
    }
    return result;
}

}  // namespace ticker::tasks::screenshot

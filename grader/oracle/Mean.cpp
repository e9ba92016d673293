#include <grader/oracle/Mean.h>

#include <grader/oracle/Replicate.h>

#include <algorithm>
#include <cmath>

namespace ticker::oracle {
namespace {

constexpr int kReplicates = 4;

// Moments from replicates that all have the same counts for a pixel.
Moments assembled(const Setup& setup, const std::vector<Replicate>& replicates,
                  std::int64_t lensPaths) {
    const auto pixels =
        static_cast<std::size_t>(setup.width) * static_cast<std::size_t>(setup.height);
    const auto count = static_cast<double>(replicates.size());
    const double scale = setup.mistake.pixelScale;
    const double scale2 = scale * scale;
    const double rays = setup.settings.dofRayCount;
    Moments moments;
    moments.width = setup.width;
    moments.height = setup.height;
    moments.replicates = static_cast<int>(replicates.size());
    moments.lensPaths = lensPaths;
    moments.mean.resize(pixels);
    moments.covariance.resize(pixels);
    moments.meanError.resize(pixels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        PathMoments sum;
        std::array<double, 3> squares{};
        for (const Replicate& replicate : replicates) {
            sum += replicate[pixel];
            for (std::size_t c = 0; c < 3; ++c)
                squares[c] += replicate[pixel].mean[c] * replicate[pixel].mean[c];
        }
        sum *= 1.0 / count;
        std::array<double, 3> error{};
        for (std::size_t c = 0; c < 3; ++c)
            error[c] = count > 1.0 ? std::max(0.0, squares[c] / count - sum.mean[c] * sum.mean[c]) /
                                         (count - 1.0)
                                   : 0.0;
        const auto& m = sum.mean;
        // Squares of the mean are too large by the mean's own error on average; it is small.
        const auto covariance = [&](std::size_t entry, std::size_t a, std::size_t b) {
            const double between = sum.second[entry] - m[a] * m[b] + (a == b ? error[a] : 0.0);
            return scale2 * ((a == b ? std::max(0.0, between) : between) + sum.noise[entry]) / rays;
        };
        moments.mean[pixel] = {scale * m[0], scale * m[1], scale * m[2]};
        moments.meanError[pixel] = {scale2 * error[0], scale2 * error[1], scale2 * error[2]};
        moments.covariance[pixel] = {covariance(0, 0, 0), covariance(1, 1, 1), covariance(2, 2, 2),
                                     covariance(3, 0, 1), covariance(4, 0, 2), covariance(5, 1, 2)};
    }
    return moments;
}

bool reached(const Moments& moments, const Precision& precision) {
    const bool share =
        precision.share <= 0.0 || moments.shareOfVariance(precision.renders) <= precision.share;
    const bool rms = precision.rms <= 0.0 || moments.rmsError() <= precision.rms;
    return share && rms && (precision.share > 0.0 || precision.rms > 0.0);
}

}  // namespace

Moments momentsOf(const Setup& setup, std::uint64_t seed, const Precision& precision) {
    const std::size_t pixels =
        static_cast<std::size_t>(setup.width) * static_cast<std::size_t>(setup.height);
    std::uint32_t count =
        static_cast<std::uint32_t>(std::max(1, precision.minLensPaths / kReplicates));
    for (std::uint64_t round = 0;; ++round) {
        std::vector<Replicate> replicates;
        for (std::uint64_t i = 0; i < kReplicates; ++i)
            replicates.push_back(replicate(setup, seed, round * kReplicates + i,
                                           std::vector<std::uint32_t>(pixels, count)));
        Moments moments = assembled(setup, replicates, std::int64_t{count} * kReplicates);
        if (reached(moments, precision) ||
            2 * std::int64_t{count} * kReplicates > precision.maxLensPaths)
            return moments;
        count *= 2;
    }
}

}  // namespace ticker::oracle

#include <grader/oracle/Mean.h>

#include <grader/oracle/Allocation.h>
#include <grader/oracle/Replicate.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ticker::oracle {
namespace {

constexpr int kReplicates = 4;
constexpr std::uint32_t kPilotPaths = 32;

std::size_t pixelsOf(const Setup& setup) {
    return static_cast<std::size_t>(setup.width) * static_cast<std::size_t>(setup.height);
}

std::vector<Replicate> replicates(const Setup& setup, std::uint64_t seed, std::uint64_t round,
                                  const std::vector<std::uint32_t>& counts) {
    std::vector<Replicate> result;
    for (std::uint64_t i = 0; i < kReplicates; ++i)
        result.push_back(replicate(setup, seed, round * kReplicates + i, counts));
    return result;
}

/// One pixel of all replicates: averages, and the variance of the average of each channel.
struct PixelAverage {
    PathMoments moments;
    std::array<double, 3> error{};
};

PixelAverage averaged(const std::vector<Replicate>& all, std::size_t pixel) {
    const auto count = static_cast<double>(all.size());
    PixelAverage result;
    for (const Replicate& replicate : all)
        result.moments += replicate[pixel];
    result.moments *= 1.0 / count;
    for (const Replicate& replicate : all)
        for (std::size_t c = 0; c < 3; ++c) {
            const double off = replicate[pixel].mean[c] - result.moments.mean[c];
            result.error[c] += off * off / (count * (count - 1.0));
        }
    return result;
}

Covariance covarianceOf(const PixelAverage& pixel, double scale) {
    const auto& m = pixel.moments.mean;
    // On average, the square of an estimated mean exceeds the squared mean by the variance of the
    // estimate, so that m[a] * m[a] takes off too much: the variance is added again.
    const auto entry = [&](std::size_t e, std::size_t a, std::size_t b) {
        double between = pixel.moments.second[e] - m[a] * m[b];
        if (a == b) between = std::max(0.0, between + pixel.error[a]);
        return scale * (between + pixel.moments.noise[e]);
    };
    return {entry(0, 0, 0), entry(1, 1, 1), entry(2, 2, 2),
            entry(3, 0, 1), entry(4, 0, 2), entry(5, 1, 2)};
}

Moments assembled(const Setup& setup, const std::vector<Replicate>& all,
                  const std::vector<std::uint32_t>& counts) {
    const double scale = setup.mistake.pixelScale;
    Moments moments;
    moments.width = setup.width;
    moments.height = setup.height;
    moments.replicates = kReplicates;
    moments.lensPaths =
        kReplicates * std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const PixelAverage pixel = averaged(all, i);
        const auto& m = pixel.moments.mean;
        const auto& e = pixel.error;
        moments.mean.push_back(raytracer::ColourRGB{m[0], m[1], m[2]} * scale);
        moments.meanError.push_back(raytracer::ColourRGB{e[0], e[1], e[2]} * (scale * scale));
        moments.covariance.push_back(
            covarianceOf(pixel, scale * scale / setup.settings.dofRayCount));
    }
    return moments;
}

/// Upper bound for the sum of `Moments::meanError` over pixels and channels.
double targetOf(const Moments& moments, const Precision& precision) {
    double target = std::numeric_limits<double>::infinity();
    if (precision.share > 0.0) {
        double variance = 0.0;
        for (const Covariance& c : moments.covariance)
            variance += c.rr + c.gg + c.bb;
        target = precision.share * variance / precision.renders;
    }
    if (precision.rms > 0.0)
        target = std::min(
            target, precision.rms * precision.rms * 3.0 * static_cast<double>(moments.mean.size()));
    return target;
}

double errorOf(const Moments& moments) {
    double sum = 0.0;
    for (const raytracer::ColourRGB& e : moments.meanError)
        sum += e.r + e.g + e.b;
    return sum;
}

PilotNoise noiseOf(const Setup& setup, const Moments& pilot) {
    PilotNoise noise;
    noise.width = setup.width;
    noise.height = setup.height;
    noise.paths = kPilotPaths;
    noise.decay = setup.tricks.lowDiscrepancy ? 1.9 : 1.0;
    for (const raytracer::ColourRGB& e : pilot.meanError)
        noise.variance.push_back(kReplicates * (e.r + e.g + e.b));
    return noise;
}

}  // namespace

Moments momentsOf(const Setup& setup, std::uint64_t seed, const Precision& precision) {
    const auto least =
        static_cast<std::uint32_t>(std::max(1, precision.minLensPaths / kReplicates));
    const auto most = std::max(
        least, static_cast<std::uint32_t>(std::max(1, precision.maxLensPaths / kReplicates)));
    if (least == most) {
        const std::vector<std::uint32_t> counts(pixelsOf(setup), least);
        return assembled(setup, replicates(setup, seed, 0, counts), counts);
    }
    const std::vector<std::uint32_t> few(pixelsOf(setup), kPilotPaths);
    const Moments pilot = assembled(setup, replicates(setup, seed, 0, few), few);
    const PilotNoise noise = noiseOf(setup, pilot);
    // The pilot's samples are discarded: sample counts that depend on the samples they weight would
    // bias the mean.
    double ask = 0.8;
    for (std::uint64_t round = 1;; ++round) {
        const double target = targetOf(pilot, precision);
        const std::vector<std::uint32_t> counts =
            allocated(noise, kReplicates, ask * target, least, most, !setup.tricks.allocation);
        Moments moments = assembled(setup, replicates(setup, seed, round, counts), counts);
        const double error = errorOf(moments);
        const bool enough = error <= targetOf(moments, precision);
        const bool full = std::all_of(counts.begin(), counts.end(),
                                      [&](std::uint32_t n) { return 2 * n > most; });
        if (enough || full || interrupted(setup)) return moments;
        ask *= std::min(0.5, target / error);
    }
}

}  // namespace ticker::oracle

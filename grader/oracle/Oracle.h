#ifndef TICKER_ORACLE_ORACLE_H
#define TICKER_ORACLE_ORACLE_H

#include <grader/oracle/Reading.h>

#include <raytracer/base/RenderSettings.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/image/Image.h>
#include <raytracer/scene/SceneDescription.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace ticker::oracle {

/// Covariance matrix of the three channels of one pixel, linear colours squared.
struct Covariance {
    double rr = 0.0, gg = 0.0, bb = 0.0, rg = 0.0, rb = 0.0, gb = 0.0;

    /// Variance of weights.r * red + weights.g * green + weights.b * blue (luminance, say).
    [[nodiscard]] double along(const raytracer::ColourRGB& weights) const {
        return weights.r * weights.r * rr + weights.g * weights.g * gg +
               weights.b * weights.b * bb +
               2.0 * (weights.r * weights.g * rg + weights.r * weights.b * rb +
                      weights.g * weights.b * gb);
    }
};

/// The distribution of one student render, pixel by pixel: rows from the top, linear colours.
/// Pixels of one render are independent of each other (lens and shadow rays are drawn for each
/// pixel separately), so the distribution of every linear statistic of renders follows from these
/// moments.
struct Moments {
    int width = 0;
    int height = 0;
    std::vector<raytracer::ColourRGB> mean;
    std::vector<Covariance> covariance;  ///< of ONE render with the settings' ray counts

    /// Estimated squared standard error of `mean`, from independent replicates. Noisy for one pixel
    /// (`replicates` - 1 degrees of freedom), good when summed over many.
    std::vector<raytracer::ColourRGB> meanError;
    int replicates = 0;          ///< independent randomisations that were averaged
    std::int64_t lensPaths = 0;  ///< lens paths in all of them, over all pixels

    /// Sum over pixels and channels of meanError, divided by that of variance / renders: what the
    /// error of `mean` adds to the variance of a statistic of the mean of `renders` renders.
    [[nodiscard]] double shareOfVariance(int renders) const;
    /// Root mean square of the standard error over pixels and channels.
    [[nodiscard]] double rmsError() const;
};

/// Precision goals of moments. Work ends when every goal that is set is met, or when all pixels
/// have `maxLensPaths`. With equal minimum and maximum every pixel gets exactly that many.
struct Precision {
    double share = 0.01;  ///< goal for Moments::shareOfVariance(renders); 0: no such goal
    int renders = 16;
    double rms = 0.0;            ///< goal for Moments::rmsError(), linear; 0: no such goal
    int minLensPaths = 128;      ///< of each pixel
    int maxLensPaths = 1 << 18;  ///< likewise
};

/// An independent renderer of the exercise's scenes (docs/decisions/0005), fast enough to compute
/// fresh expected answers for every submission. It shares scene data with the framework, but no
/// code.
///
/// It uses `settings.threads` threads and `settings.region` (pixels equal those of the whole
/// frame), and stops early when `settings.monitor` asks for it. `settings.observer` is ignored. For
/// one seed the results are the same bytes for every number of threads; between instruction sets
/// means agree within single-precision error.
class Oracle {
public:
    /// Copies what it needs; the scene may be destroyed afterwards.
    /// @throws raytracer::Error if settings make no sense (sizes or ray counts below 1, bounces
    ///         below 0).
    Oracle(const raytracer::SceneDescription& scene, const raytracer::RenderSettings& settings,
           const Reading& reading = {}, const Mistake& mistake = {}, const Tricks& tricks = {});
    ~Oracle();
    Oracle(const Oracle&) = delete;
    Oracle& operator=(const Oracle&) = delete;
    Oracle(Oracle&&) noexcept;
    Oracle& operator=(Oracle&&) noexcept;

    /// Mean and variance of one student render. `seed` selects the randomisation.
    [[nodiscard]] Moments moments(std::uint64_t seed, const Precision& precision = {}) const;

    /// One student render: the estimator itself, with dofRayCount lens rays for each pixel and
    /// shadowRayCount shadow rays for each hit and light, all independent. Another seed gives an
    /// independent render.
    [[nodiscard]] raytracer::Image studentRender(std::uint64_t seed) const;

private:
    struct State;
    std::unique_ptr<const State> state_;
};

}  // namespace ticker::oracle

#endif

#include <grader/oracle/Oracle.h>

#include <grader/oracle/Mean.h>
#include <grader/oracle/Students.h>

#include <cmath>

namespace ticker::oracle {

struct Oracle::State {
    Setup setup;
};

Oracle::Oracle(const raytracer::SceneDescription& scene, const raytracer::RenderSettings& settings,
               const Reading& reading, const Mistake& mistake, const Tricks& tricks)
    : state_(std::make_unique<State>(State{{scene, settings, reading, mistake, tricks}})) {}

Oracle::~Oracle() = default;
Oracle::Oracle(Oracle&&) noexcept = default;
Oracle& Oracle::operator=(Oracle&&) noexcept = default;

Moments Oracle::moments(std::uint64_t seed, const Precision& precision) const {
    return momentsOf(state_->setup, seed, precision);
}

raytracer::Image Oracle::studentRender(std::uint64_t seed) const {
    return oracle::studentRender(state_->setup, seed);
}

double Moments::shareOfVariance(int renders) const {
    double error = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < mean.size(); ++i) {
        error += meanError[i].r + meanError[i].g + meanError[i].b;
        variance += covariance[i].rr + covariance[i].gg + covariance[i].bb;
    }
    return error > 0.0 ? error * renders / variance : 0.0;
}

double Moments::rmsError() const {
    double error = 0.0;
    for (const raytracer::ColourRGB& pixel : meanError)
        error += pixel.r + pixel.g + pixel.b;
    return mean.empty() ? 0.0 : std::sqrt(error / (3.0 * static_cast<double>(mean.size())));
}

}  // namespace ticker::oracle

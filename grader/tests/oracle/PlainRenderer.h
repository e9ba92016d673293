#ifndef TICKER_TESTS_ORACLE_PLAINRENDERER_H
#define TICKER_TESTS_ORACLE_PLAINRENDERER_H

#include <grader/oracle/Reading.h>

#include <raytracer/base/RenderSettings.h>
#include <raytracer/image/Image.h>
#include <raytracer/scene/Scene.h>

#include <cstdint>
#include <random>

namespace ticker::oracle::test {

/// The exercise under any reading and mistake, written like a student's code: one ray after the
/// other, double precision, the framework's intersections. Checks the oracle where the reference
/// solution covers only one reading.
class PlainRenderer {
public:
    PlainRenderer(const raytracer::Scene& scene, const raytracer::RenderSettings& settings,
                  const Reading& reading, const Mistake& mistake, std::uint64_t seed);

    [[nodiscard]] raytracer::Image render();

private:
    double uniform() { return unit_(engine_); }
    raytracer::Vector3 aimPoint();
    raytracer::Vector3 lensPoint();
    double placeInPixel();
    raytracer::ColourRGB trace(const raytracer::Ray& ray, int bouncesLeft);
    raytracer::ColourRGB illuminate(const raytracer::RaycastHit& hit,
                                    const raytracer::Vector3& viewer);
    raytracer::ColourRGB lightOf(std::size_t light, const raytracer::RaycastHit& hit,
                                 const raytracer::Vector3& toViewer);

    const raytracer::Scene& scene_;
    raytracer::RenderSettings settings_;
    Reading reading_;
    Mistake mistake_;
    std::mt19937_64 engine_;
    std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

}  // namespace ticker::oracle::test

#endif

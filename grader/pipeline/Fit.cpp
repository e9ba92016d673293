#include <grader/pipeline/Fit.h>

#include <grader/tasks/lens/checks/PictureDoubt.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace ticker::pipeline {
namespace {

// A picture with a larger misfit than this is not explained by another reading of the light.
constexpr double kNearMiss = 2.0;

/// Mean square of the sums over square tiles of a map of z-scores, each sum in its own standard
/// errors. Incomplete tiles at the right and lower border are left out.
/// @param side  Pixels.
double meanSquare(const metrics::Map& z, int side) {
    const int across = z.width / side;
    const int down = z.height / side;
    std::vector<double> sums(static_cast<std::size_t>(across) * static_cast<std::size_t>(down));
    for (int y = 0; y < down * side; ++y)
        for (int x = 0; x < across * side; ++x)
            sums[static_cast<std::size_t>(y / side * across + x / side)] +=
                static_cast<double>(z.values[static_cast<std::size_t>(y * z.width + x)]) / side;
    double squares = 0.0;
    for (const double sum : sums)
        squares += sum * sum;
    return squares / static_cast<double>(sums.size());
}

}  // namespace

Fit bestFit(const SpecScene& scene, const probe::RenderAnswer& answer, Rays rays) {
    if (!scene.isRandom) return {&scene.expected(), {}, {}, true};
    const bool few = rays == Rays::few;
    const double enough = few ? kMostMisfitOfFewRays : tasks::kMostMisfit;
    const double share = 1.0 * settingsFor(scene, rays).dofRayCount / scene.settings.dofRayCount;
    const metrics::Map picture = brightnessOf(answer.width, answer.height, answer.images[0]);
    Fit fit;
    Misfit best;
    for (std::size_t i = 0; i < scene.readings.size(); ++i) {
        const bool isOfLight = i >= kAcceptedApertures.size();
        const double own = scene.readings[i].apertureFactor;
        // The first reading is always tried, and the others only until one fits. The apertures come
        // first; another light explains near misses alone, with the aperture that fits best so far.
        if (i > 0 && best.meanSquare <= enough) break;
        if (isOfLight && (best.meanSquare > kNearMiss || own != best.apertureFactor)) continue;
        // An expectation costs some 300 ms when it is first used. A picture of few rays that nearly
        // fits the first aperture is not compared with the second one.
        if (few && i > 0 && !isOfLight && best.meanSquare <= kNearMiss) continue;
        const Expectation& expected = scene.expected(i);
        metrics::Measured z = metrics::zMap(expected.brightness, picture, share);
        fit.misfits.push_back({own, meanSquare(z.map, few ? kTileOfFewRays : 1)});
        if (i > 0 && fit.misfits.back().meanSquare >= best.meanSquare) continue;
        best = fit.misfits.back();
        fit.expected = &expected;
        fit.z = std::move(z);
    }
    fit.isClear = !few || best.meanSquare <= enough;
    return fit;
}

}  // namespace ticker::pipeline

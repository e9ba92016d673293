#include <grader/oracle/references/ReferenceRender.h>

#include <raytracer/base/RenderObserver.h>

namespace ticker::oracle {
namespace {

using raytracer::RenderSettings;

Oracle oracleOf(const raytracer::SceneDescription& scene, RenderSettings settings, bool pinhole) {
    Reading reading;
    Mistake mistake;
    if (pinhole) {
        settings.dofRayCount = 1;
        settings.shadowRayCount = 1;
        reading.lightShape = LightShape::centre;
        mistake.aperture = Mistake::Aperture::none;
    }
    return {scene, settings, reading, mistake};
}

}  // namespace

Moments momentsOf(const ReferenceScene& scene, double rms, std::uint64_t seed) {
    Precision precision;
    precision.share = 0.0;
    precision.rms = rms;
    // A pinhole camera has no lens samples: all paths of a pixel are equal.
    if (scene.pinhole) precision.minLensPaths = precision.maxLensPaths = 4;
    return oracleOf(scene.scene, scene.settings, scene.pinhole).moments(seed, precision);
}

raytracer::Image toImage(const Moments& moments) {
    raytracer::Image image{moments.width, moments.height};
    for (int y = 0; y < moments.height; ++y)
        for (int x = 0; x < moments.width; ++x)
            image.set(x, y, moments.mean[static_cast<std::size_t>(y * moments.width + x)]);
    return image;
}

std::filesystem::path fileOf(const std::filesystem::path& folder, const std::string& name,
                             const char* suffix) {
    return folder / (name + suffix);
}

bool interrupted(const ReferenceScene& scene) {
    return scene.settings.monitor != nullptr && scene.settings.monitor->interrupted();
}

void ReferenceClock::tell(std::size_t done) const {
    if (!listener_) return;
    const std::string name = done < scenes_.size() ? scenes_[done].name : "";
    const double spent =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double share = cost(0, done) / cost(0, scenes_.size());
    listener_({name, static_cast<int>(done), static_cast<int>(scenes_.size()),
               done == 0 ? -1.0 : spent * (1.0 - share) / share});
}

// A path-traced pixel takes about as long as a hundred pinhole pixels.
double ReferenceClock::cost(std::size_t first, std::size_t end) const {
    double sum = 0.0;
    for (std::size_t i = first; i < end; ++i) {
        const RenderSettings& s = scenes_[i].settings;
        sum += static_cast<double>(s.imageWidth()) * s.imageHeight() *
               (scenes_[i].pinhole ? 1.0 : 100.0);
    }
    return sum;
}

raytracer::Image renderWithOracle(const raytracer::SceneDescription& scene,
                                  const RenderSettings& settings, std::uint64_t seed,
                                  int lensPaths) {
    Precision precision;
    precision.share = 0.0;
    precision.rms = 5e-4;
    if (lensPaths > 0) precision.minLensPaths = precision.maxLensPaths = lensPaths;
    return toImage(oracleOf(scene, settings, false).moments(seed, precision));
}

raytracer::Image renderPinholeWithOracle(const raytracer::SceneDescription& scene,
                                         const RenderSettings& settings) {
    // Nothing is random here, so one render is the mean.
    return oracleOf(scene, settings, true).studentRender(0);
}

}  // namespace ticker::oracle

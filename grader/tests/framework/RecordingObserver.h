#ifndef TICKER_TESTS_FRAMEWORK_RECORDINGOBSERVER_H
#define TICKER_TESTS_FRAMEWORK_RECORDINGOBSERVER_H

#include <raytracer/base/RenderObserver.h>
#include <raytracer/geometry/RaycastHit.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Ray.h>

#include <string>
#include <vector>

namespace ticker {

/// Records the work of one thread: the names of the events, and the rays.
class RecordingObserver : public raytracer::RenderObserver {
public:
    void cameraRayAsked(int /*x*/, int /*y*/, const raytracer::Ray& ray) override {
        names.emplace_back("cameraRayAsked");
        cameraRay = ray;
    }
    void traceBegan(const raytracer::Ray& ray, int bouncesLeft) override {
        names.push_back("traceBegan " + std::to_string(bouncesLeft));
        if (depth_++ == 0) tracedRays.push_back(ray);
    }
    void traceEnded(const raytracer::ColourRGB& colour) override {
        names.emplace_back("traceEnded");
        if (--depth_ == 0) tracedColours.push_back(colour);
    }
    void illuminateBegan(const raytracer::SceneObject& /*object*/,
                         const raytracer::Vector3& /*position*/,
                         const raytracer::Vector3& /*normal*/,
                         const raytracer::Vector3& /*viewer*/) override {
        names.emplace_back("illuminateBegan");
    }
    void illuminateEnded(const raytracer::ColourRGB& /*colour*/) override {
        names.emplace_back("illuminateEnded");
    }
    void rayCast(const raytracer::Ray& ray, const raytracer::RaycastHit* hit) override {
        names.emplace_back(hit != nullptr ? "rayCast hit" : "rayCast miss");
        rays.push_back(ray);
        hits.push_back(hit != nullptr ? *hit : raytracer::RaycastHit{});
    }
    void pixelSet(int /*x*/, int /*y*/, const raytracer::ColourRGB& /*colour*/) override {
        names.emplace_back("pixelSet");
    }

    std::vector<std::string> names;
    raytracer::Ray cameraRay;
    std::vector<raytracer::Ray> rays;
    std::vector<raytracer::RaycastHit> hits;  ///< one for each ray; without object for a miss
    std::vector<raytracer::Ray> tracedRays;   ///< rays of the outermost traces
    std::vector<raytracer::ColourRGB> tracedColours;  ///< results of these traces

private:
    int depth_ = 0;
};

}  // namespace ticker

#endif

#ifndef TICKER_TASKS_SHADOWS_ANSWERS_LIGHTPARTS_H
#define TICKER_TASKS_SHADOWS_ANSWERS_LIGHTPARTS_H

#include <grader/tasks/shadows/answers/Phong.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <vector>

namespace ticker::tasks {

/// Interval of possible colours.
struct Range {
    ColourRGB low;
    ColourRGB high;

    Range& operator+=(const Range& other) {
        low += other.low;
        high += other.high;
        return *this;
    }
};

inline Range operator*(const Range& range, double scale) {
    return {range.low * scale, range.high * scale};
}

/// One light at one point: its full light, the light that arrives, and the share of rays that
/// arrive.
struct LightParts {
    Range fullDiffuse;
    Range fullSpecular;
    Range litDiffuse;
    Range litSpecular;
    double lowShare = 0.0;
    double highShare = 0.0;
    double ray = 1.0;  ///< share of one ray
};

/// One point, one light, one reading: input of the functions below.
struct Setting {
    const raytracer::Material& material;
    const raytracer::PointLight& light;
    const PointLog& point;
    const raytracer::RenderSettings& settings;
    const ShadowReading& reading;
    bool endless;

    [[nodiscard]] Vector3 toViewer() const {
        const Vector3 viewer = reading.viewerIsEye ? Vector3{} : point.point.viewer;
        return (viewer - point.point.position).normalised();
    }
    [[nodiscard]] PhongTerms terms(const Vector3& toLight, double distance) const {
        return phongTerms(material, light, point.point.normal, toViewer(), toLight, distance);
    }
};

/// The light that the logged rays of one light give; without rays, every share is possible.
[[nodiscard]] LightParts partsOf(const Setting& at, const std::vector<AimLine>& logged);

/// Diffuse and specular light of one sample. The sample's place on its line may be unknown, so both
/// are intervals.
struct SampleTerms {
    Range diffuse;
    Range specular;
};
/// The full light in the central reading, without shadow.
[[nodiscard]] SampleTerms centralTerms(const Setting& at);

/// Largest distance of a logged ray's start from the point, at most 2e-3; 0 without rays. With rays
/// it is at least the framework's shadow bias: directions may be computed from a start that the
/// rays do not have.
[[nodiscard]] double biasOf(const PointLog& point);

}  // namespace ticker::tasks

#endif

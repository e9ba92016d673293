// Where the camera rays of one pixel meet.
#include <lens/DepthOfField.h>
#include <lens/LensPoints.h>
#include <questions/RayGeometry.h>
#include <raytracer/base/RenderSettings.h>
#include <raytracer/image/Image.h>
#include <raytracer/math/Ray.h>
#include <raytracer/math/Vector3.h>
#include <raytracer/render/Renderer.h>
#include <raytracer/scene/Camera.h>
#include <raytracer/scene/Scene.h>
#include <support/Complaint.h>
#include <support/KeptScene.h>
#include <support/RayLog.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace raytracer::tests::lens {
namespace {

/// The meeting point of one pixel's rays: the point with the smallest sum of squared distances from
/// their lines.
class Meeting {
public:
    explicit Meeting(const std::vector<Ray>& rays) {
        // Least squares: sum of (I - d d^T) p = sum of (I - d d^T) o
        std::array<Vector3, 3> rows{};
        Vector3 right;
        for (const Ray& ray : rays) {
            const Vector3& d = ray.direction;
            rows[0] += Vector3{1.0, 0.0, 0.0} - d * d.x;
            rows[1] += Vector3{0.0, 1.0, 0.0} - d * d.y;
            rows[2] += Vector3{0.0, 0.0, 1.0} - d * d.z;
            right += ray.origin - d * d.dot(ray.origin);
        }
        const double determinant = rows[0].dot(rows[1].cross(rows[2]));
        const double size = static_cast<double>(rays.size());
        clear_ = std::abs(determinant) > 1e-9 * size * size * size;
        if (!clear_) return;
        point_ = (rows[1].cross(rows[2]) * right.x + rows[2].cross(rows[0]) * right.y +
                  rows[0].cross(rows[1]) * right.z) /
                 determinant;
        for (const Ray& ray : rays)
            farthest_ = std::max(farthest_, questions::footFrom(point_, ray).magnitude());
    }

    /// False if the rays are parallel or equal.
    [[nodiscard]] bool clear() const { return clear_; }
    [[nodiscard]] bool isPoint() const { return clear_ && farthest_ <= 2e-3; }
    [[nodiscard]] const Vector3& point() const { return point_; }
    /// Largest distance of a ray's line from the point.
    [[nodiscard]] double farthest() const { return farthest_; }

private:
    bool clear_ = false;
    Vector3 point_;
    double farthest_ = 0.0;
};

const std::string kSection = "Depth of field (T2.2), steps 1 and 2";

/// Whether all rays pass through the pixel's own square of the focal plane.
bool stayInPixel(const std::vector<Ray>& rays, const RenderSettings& settings, int x) {
    const Camera camera{settings};
    const double plane = settings.dofFocalPlane;
    const Vector3 middle = inPlane(camera.castRay(x, 0), plane);
    const double half = (inPlane(camera.castRay(x + 1, 0), plane) - middle).magnitude() / 2.0;
    constexpr double kRounding = 2e-4;
    return std::all_of(rays.begin(), rays.end(), [&](const Ray& ray) {
        const Vector3 beside = inPlane(ray, plane) - middle;
        return std::max(std::abs(beside.x), std::abs(beside.y)) <= half + kRounding;
    });
}

/// The same for pixel `x` of a frame whose pixels are as small as the handout's.
bool stayInFinePixel(int x) {
    RayLog log;
    RenderSettings settings;
    settings.height = 1;
    settings.region = {x, 0, 1, 1};
    settings.observer = &log;
    static_cast<void>(Renderer{settings}.render(keptScene(twoBalls(), &log)));
    std::vector<Ray> rays = log.rays();
    std::erase_if(rays, [](const Ray& ray) { return ray.origin.z > kNearestSurface; });
    return stayInPixel(rays, settings, 0);  // counted inside of the region
}

/// Whether the solution antialiases: each ray goes through a random place of its own pixel, which
/// is accepted. Rays with a wrong focal point may stay inside a large pixel, but not inside a small
/// one, so both sizes are tried.
bool antialiases(const Trial& trial) {
    const RenderSettings large = Trial::twoPixels();
    return stayInPixel(trial.rays(0), large, 0) && stayInPixel(trial.rays(1), large, 1) &&
           stayInFinePixel(0) && stayInFinePixel(RenderSettings{}.width - 1);
}

/// Complains if rays point away from the scene.
void judgeHeading(const std::vector<Ray>& rays, const std::string& asked) {
    const auto away = std::count_if(rays.begin(), rays.end(),
                                    [](const Ray& ray) { return !(ray.direction.z > 0.0); });
    if (away == 0) return;
    complain(asked, "rays that run from the lens to the focal point",
             std::to_string(away) + " of " + std::to_string(rays.size()) + " run the other way",
             "the difference is the wrong way round: direction = focal point minus lens point",
             kSection);
}

/// Complains if the rays do not meet in one point of the pinhole camera's ray.
void judgeMeeting(const Meeting& meeting, const Vector3& pinhole, const std::string& asked) {
    if (!meeting.isPoint()) {
        complain(asked, "rays that come together in one point",
                 meeting.clear()
                     ? "rays that pass the best point at up to " + inWords(meeting.farthest())
                     : "parallel rays",
                 "each ray goes from its lens point to the one focal point of the pixel: "
                 "direction = focal point minus lens point",
                 kSection);
        return;
    }
    const double off = pinhole.cross(meeting.point()).magnitude();
    if (off > 5e-3)
        complain(asked, "a focal point on the ray of the pinhole camera",
                 "a point " + inWords(off) + " beside it",
                 "the focal point is where camera.castRay(x, y) meets the focal plane", kSection);
}

void judgeDepth(const Vector3& point, double plane, const std::string& asked) {
    if (std::abs(point.z - plane) < 2e-3 * plane) return;
    const bool alongRay = std::abs(point.magnitude() - plane) < 2e-3 * plane;
    complain(asked, "a focal point with z = settings().dofFocalPlane = " + inWords(plane),
             "z = " + inWords(point.z),
             alongRay ? "dofFocalPlane is the z of a plane, not a length along the ray"
                      : "the rays are in focus at another depth",
             kSection);
}

TEST_F(DepthOfField, RaysOfAPixelMeetInTheFocalPlane) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const Camera camera{Trial::twoPixels()};
    for (const std::size_t pixel : {0U, 1U}) {
        const std::vector<Ray>& rays = trial().rays(pixel);
        if (rays.size() < 2) continue;  // another test reports it
        const Meeting meeting{rays};
        if (!meeting.clear() && LensPoints{trial()}.widest() < 1e-6)
            return;  // a pinhole: another test reports it
        const std::string asked = std::string("the rays of the ") +
                                  (pixel == 0 ? "left" : "right") +
                                  " of two pixels, from all renders";
        judgeHeading(rays, asked);
        if (HasFailure() || (!meeting.isPoint() && antialiases(trial()))) return;
        judgeMeeting(meeting, camera.castRay(static_cast<int>(pixel), 0).direction, asked);
        if (!HasFailure()) judgeDepth(meeting.point(), handout_.dofFocalPlane, asked);
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace raytracer::tests::lens

// The number, starts and aims of shadow rays.
#include <questions/RayGeometry.h>
#include <shadows/Room.h>
#include <shadows/SoftShadows.h>
#include <support/Complaint.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace raytracer::tests::shadows {
namespace {

TEST_F(SoftShadows, EachLightGetsEnoughShadowRays) {
    const auto withSecondLight = [](SceneDescription scene) {
        scene.pointLights.emplace_back(Vector3{-6.0, 3.0, 6.0}, ColourRGB{0.5, 0.6, 0.9}, 300.0);
        return scene;
    };
    if (lacksRays(Trial{withSecondLight(roomWithBall()), floorAt(1.4), 40}))
        GTEST_SKIP() << kUnseen;
    // In plain sight, since code may intersect one object by itself before it asks the scene.
    const SceneDescription scene = withSecondLight(emptyRoom());
    const Trial trial{scene, floorAt(1.4), 40};
    const auto wanted = static_cast<std::size_t>(handout_.shadowRayCount);
    std::vector<std::size_t> counts(2);
    for (const Ray& ray : trial.rays())
        ++counts[questions::nearestLight(scene.pointLights, ray.origin, ray.direction)];
    for (const std::size_t count : counts) {
        if (count >= 40 * wanted && trial.fewestRays() >= 2 * wanted) continue;
        complain("a point under two lights, 40 times",
                 std::to_string(wanted) + " rays to each light each time",
                 inWords(static_cast<double>(count) / 40.0) + " to one of them on average",
                 "the loop runs settings().shadowRayCount times for each light",
                 "Soft shadows (T2.1), step 1");
        return;
    }
}

/// Statistics of where the lines of shadow rays pass the light.
class Aims {
public:
    Aims(const std::vector<Ray>& rays, const Vector3& light, double radius) {
        std::vector<Vector3> feet;
        std::set<std::array<std::int64_t, 3>> cells;
        for (const Ray& ray : rays) {
            feet.push_back(questions::footFrom(light, ray) / radius);
            farthest_ = std::max(farthest_, feet.back().magnitude());
            mean_ += feet.back() / static_cast<double>(rays.size());
            cells.insert({std::llround(feet.back().x * 200.0), std::llround(feet.back().y * 200.0),
                          std::llround(feet.back().z * 200.0)});
        }
        const Vector3 first = rays.front().direction.cross(Vector3{0.3, 0.5, 0.8}).normalised();
        const Vector3 second = rays.front().direction.cross(first);
        double xx = 0.0;
        double yy = 0.0;
        double xy = 0.0;
        for (const Vector3& foot : feet) {
            xx += foot.dot(first) * foot.dot(first);
            yy += foot.dot(second) * foot.dot(second);
            xy += foot.dot(first) * foot.dot(second);
        }
        const double root = std::sqrt((xx - yy) * (xx - yy) + 4.0 * xy * xy);
        roundness_ = (xx + yy - root) / (xx + yy + root);
        arePattern_ = cells.size() < 200;  // 3000 random points share few of the cells
    }

    /// True for a few aim points that repeat.
    [[nodiscard]] bool arePattern() const { return arePattern_; }

    /// Largest distance of a line from the light's centre, and distance of the lines' mean, in
    /// radii of the light.
    [[nodiscard]] double farthest() const { return farthest_; }
    [[nodiscard]] double offCentre() const { return mean_.magnitude(); }
    /// 1: equal in all directions, 0: along a line.
    [[nodiscard]] double roundness() const { return roundness_; }

private:
    double farthest_ = 0.0;
    Vector3 mean_;
    double roundness_ = 1.0;
    bool arePattern_ = false;
};

void judgeAims(const Aims& aims, const std::string& asked) {
    const std::string section = "Soft shadows (T2.1), step 1";
    const std::string expected = "aim points in a ball of radius settings().lightSize";
    // Even for aim points that crowd in the middle, the chance that none of 3000 lines passes
    // beyond 0.9 radii is 1e-40, and the chance that their mean is off by 0.1 radii is 1e-20.
    if (aims.farthest() > 1.003)
        complain(asked, expected,
                 "lines that pass the centre at " + inWords(aims.farthest()) + " radii",
                 "a cube in place of a ball, a light that is too large, an offset of the direction "
                 "in place of the light's position, or a shadow ray that starts somewhere else",
                 section);
    else if (aims.arePattern())
        return;  // too few for other checks
    else if (aims.farthest() < 0.85)
        complain(asked, expected,
                 "no line farther from the centre than " + inWords(aims.farthest()) + " radii",
                 "the light is too small: is settings().lightSize its radius?", section);
    else if (aims.offCentre() > 0.12)
        complain(
            asked, expected,
            "a middle that lies " + inWords(aims.offCentre()) + " radii from the light's position",
            "random numbers from 0 to 1 where -1 to 1 was meant", section);
    else if (aims.roundness() < 0.2)
        complain(asked, expected, "aim points that lie in a plane or on a line",
                 "the three components need random numbers of their own", section);
}

TEST_F(SoftShadows, ShadowRaysAimAtAllOfTheLightAndNothingElse) {
    // Three perpendicular directions, since an offset of the aim points along the rays does not
    // show.
    for (const Vector3& towards :
         {Vector3{0.6, 0.8, 0.0}, {-0.48, 0.36, 0.8}, {-0.64, 0.48, -0.6}}) {
        SceneDescription scene = emptyRoom();
        const Vector3 point = floorAt(0.0);
        const Vector3 light = point + towards * 100.0;
        scene.pointLights = {{light, ColourRGB{1.0}, 1e5}};
        const Trial trial{scene, point, 300};
        if (trial.rays().empty()) GTEST_SKIP() << kUnseen;
        judgeAims({trial.rays(), light, handout_.lightSize},
                  "3000 shadow rays to a light 100 units away");
        if (HasFailure()) return;
    }
}

TEST_F(SoftShadows, ShadowRaysStartAtThePointItself) {
    const Vector3 point = floorAt(1.5);
    const Trial trial{emptyRoom(), point, 40};
    if (trial.rays().empty()) GTEST_SKIP() << kUnseen;
    double farthest = 0.0;
    for (const Ray& ray : trial.rays())
        farthest = std::max(farthest, (ray.origin - point).magnitude());
    if (farthest < 3e-3) return;
    complain("where the shadow rays start", "at P, lifted off the surface by kShadowBias",
             inWords(farthest) + " from P",
             "the light is what is spread out, not the point; the bias is 1e-4",
             "Soft shadows (T2.1), step 1");
}

TEST_F(SoftShadows, AimPointsAreDrawnAnewEachTime) {
    const Trial trial{emptyRoom(), floorAt(1.5), 40};
    if (lacksRays(trial)) GTEST_SKIP() << kUnseen;
    std::vector<Vector3> feet;
    for (const Ray& ray : trial.rays()) {
        const Vector3 foot = questions::footFrom(kLight, ray);
        const bool known = std::any_of(feet.begin(), feet.end(), [&](const Vector3& other) {
            return (foot - other).magnitude() < 1e-7;
        });
        if (!known) feet.push_back(foot);
    }
    if (feet.size() > static_cast<std::size_t>(handout_.shadowRayCount)) return;
    if (feet.size() > 4) return;  // one pattern for all points is accepted
    complain("all shadow rays of 40 calls", "many different aim points",
             std::to_string(feet.size()) + " in all",
             feet.size() == 1 ? "all rays aim at the light's centre"
                              : "draw a new random point for each ray",
             "Soft shadows (T2.1), step 1");
}

}  // namespace
}  // namespace raytracer::tests::shadows

// Public tests of task T2.1, Renderer::illuminate: soft shadows.
#include <questions/RayGeometry.h>
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <support/Complaint.h>
#include <support/RayLog.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace raytracer::tests {
namespace {

using questions::footFrom;

// A floor at y = -2, a ball above it, and a light above the ball. Colours differ in each channel,
// so that ambient, diffuse and specular light cannot be mistaken for each other.
const Vector3 kLight{0.3, 4.0, 9.0};
const Vector3 kBall{0.3, 1.0, 7.0};
const Vector3 kFoot{0.3, -2.0, 5.0};  // of the line through both
constexpr double kBallRadius = 0.7;
const Vector3 kUp{0.0, 1.0, 0.0};
const Vector3 kEye{0.0, 0.0, 0.0};
const ColourRGB kAmbient{0.11, 0.17, 0.23};

Material floorMaterial() {
    Material material;
    material.colour = {0.8, 0.5, 0.3};
    material.phongKD = 0.7;
    material.phongKS = 1.1;
    material.phongAlpha = 4.0;
    return material;
}

SceneDescription emptyRoom() {
    SceneDescription scene;
    scene.ambientLighting = kAmbient;
    scene.pointLights.emplace_back(kLight, ColourRGB{0.9, 0.7, 0.5}, 420.0);
    scene.planes.push_back({kFoot, kUp, floorMaterial()});
    return scene;
}

SceneDescription roomWithBall() {
    SceneDescription scene = emptyRoom();
    scene.spheres.push_back({kBall, kBallRadius, floorMaterial(), nullptr});
    return scene;
}

void complain(const std::string& asked, const std::string& expected, const std::string& got,
              const std::string& cause, const std::string& section) {
    ADD_FAILURE() << Complaint{"T2.1", asked, expected, got, cause, section};
}

std::string words(const ColourRGB& c) {
    return "(" + inWords(c.r) + ", " + inWords(c.g) + ", " + inWords(c.b) + ")";
}

bool isNear(const ColourRGB& a, const ColourRGB& b, double share) {
    const auto near = [share](double x, double y) {
        return std::abs(x - y) <= share * std::max(std::abs(x), std::abs(y)) + 1e-9;
    };
    return near(a.r, b.r) && near(a.g, b.g) && near(a.b, b.b);
}

/// A point of the floor so far to the right of the darkest one.
Vector3 floorAt(double right) {
    return kFoot + Vector3{right, 0.0, 0.0};
}

/// The point of the floor from where the light's centre stands `clear` outside of the ball's rim;
/// below 0: behind the ball.
Vector3 floorWhereLightIsClearBy(double clear) {
    double low = 0.0;
    double high = 20.0;
    for (int i = 0; i < 80; ++i) {
        const double right = 0.5 * (low + high);
        const Vector3 point = floorAt(right);
        const Vector3 toBall = kBall - point;
        const double rim = std::asin(kBallRadius / toBall.magnitude());
        const Vector3 toLight = kLight - point;
        const double apart =
            std::acos(std::clamp(toBall.normalised().dot(toLight.normalised()), -1.0, 1.0));
        (toLight.magnitude() * std::sin(apart - rim) < clear ? low : high) = right;
    }
    return floorAt(low);
}

ColourRGB ambientOnly() {
    return floorMaterial().colour * kAmbient;
}

questions::PhongTerms unshadowed(const SceneDescription& scene, std::size_t light,
                                 const Vector3& point) {
    const PointLight& lamp = scene.pointLights[light];
    const Vector3 path = lamp.position() - point;
    return questions::phongTerms(floorMaterial(), lamp, kUp, (kEye - point).normalised(),
                                 path.normalised(), path.magnitude());
}

/// What one solution does at one point of a scene, over and over.
class Trial {
public:
    Trial(SceneDescription description, const Vector3& point, int calls, int object = -1)
        : description_(std::move(description)), scene_(description_, &log_) {
        RenderSettings settings;
        settings.observer = &log_;
        const Renderer renderer{settings};
        const auto& objects = scene_.objects();
        const SceneObject& hit =
            object < 0 ? *objects.back() : *objects[static_cast<std::size_t>(object)];
        const Vector3 normal = hit.getNormalAt(point);
        for (int i = 0; i < calls; ++i) {
            seedRandom(1000U + static_cast<unsigned>(i));
            log_.clear();
            // Never quite the same point: a solution may seed a generator from it.
            const Vector3 moved = point + Vector3{1e-7 * i, 0.0, 3e-7 * i};
            const ColourRGB colour = renderer.illuminate(scene_, hit, moved, normal, kEye);
            colours_.push_back(colour);
            mean_ += colour / calls;
            fewestRays_ = std::min(fewestRays_, log_.rays().size());
            for (const Ray& ray : log_.rays())
                rays_.push_back(questions::seenFrom(moved, normal, ray));
        }
    }

    [[nodiscard]] const std::vector<ColourRGB>& colours() const { return colours_; }
    [[nodiscard]] const ColourRGB& mean() const { return mean_; }
    /// All rays that were seen, as cast from the point.
    [[nodiscard]] const std::vector<Ray>& rays() const { return rays_; }
    [[nodiscard]] std::size_t fewestRays() const { return fewestRays_; }

private:
    SceneDescription description_;
    RayLog log_;
    Scene scene_;
    std::vector<ColourRGB> colours_;
    ColourRGB mean_;
    std::vector<Ray> rays_;
    std::size_t fewestRays_ = std::numeric_limits<std::size_t>::max();
};

class SoftShadows : public ::testing::Test {
protected:
    void SetUp() override {
        static_cast<void>(Trial{emptyRoom(), floorAt(1.0), 1});
        if (isUnfinished("T2.1"))
            GTEST_SKIP()
                << "T2.1 is not attempted: the line unfinished(\"T2.1\", ...) still stands";
    }

    const RenderSettings handout_;
};

/// Mean share of the light that arrives: 0 in the dark, 1 where nothing is in the way.
double shareOf(const ColourRGB& colour, const Vector3& point) {
    const double full = unshadowed(roomWithBall(), 0, point).sum().g;
    return (colour.g - ambientOnly().g) / full;
}

TEST_F(SoftShadows, GiveAllTheLightWhereNothingIsInTheWay) {
    const Vector3 point = floorAt(1.5);
    const Trial trial{emptyRoom(), point, 200};
    const questions::PhongTerms terms = unshadowed(emptyRoom(), 0, point);
    const ColourRGB expected = ambientOnly() + terms.sum();
    // Phong for each sample differs from Phong for the light's centre by 1 % here.
    if (isNear(trial.mean(), expected, 0.04)) return;
    std::string cause =
        "the sum over the shadow rays must be divided by their number, and the "
        "share multiply diffuse and specular light once";
    if (isNear(trial.mean(), ambientOnly(), 0.02))
        cause =
            "every ray was taken for blocked: the comparison is the wrong way round, or the "
            "ray hits the surface that it starts from";
    complain("a point of the floor, nothing between it and the light", words(expected),
             words(trial.mean()) + " on average", cause, "Soft shadows (T2.1), step 3");
}

TEST_F(SoftShadows, LeaveOnlyTheAmbientLightInFullShadow) {
    const Vector3 point = floorAt(0.2);
    const Trial trial{roomWithBall(), point, 50};
    if (isNear(trial.mean(), ambientOnly(), 1e-6)) return;
    const questions::PhongTerms terms = unshadowed(roomWithBall(), 0, point);
    std::string cause = "a ray that hits the ball before the light must not count";
    if (isNear(trial.mean(), ambientOnly() + terms.specular, 0.02))
        cause = "the specular light is not scaled by the share of rays that arrive";
    else if (isNear(trial.mean(), ambientOnly() + terms.diffuse, 0.02))
        cause = "the diffuse light is not scaled by the share of rays that arrive";
    else if (trial.mean().r < ambientOnly().r)
        cause = "the ambient light comes from everywhere: it is never shadowed";
    else if (isNear(trial.mean(), ambientOnly() + terms.sum(), 0.04))
        cause = "lit and shadowed are exchanged, or the ball is never hit";
    complain("a point of the floor under the middle of the ball",
             words(ambientOnly()) + ", the ambient light", words(trial.mean()), cause,
             "Soft shadows (T2.1), step 3");
}

TEST_F(SoftShadows, GiveAShareOfTheLightAtTheShadowsEdge) {
    const Vector3 point = floorWhereLightIsClearBy(0.0);
    const Trial trial{roomWithBall(), point, 300};
    int between = 0;
    for (const ColourRGB& colour : trial.colours()) {
        const double share = shareOf(colour, point);
        if (share > 0.04 && share < 0.96) ++between;
    }
    const std::string asked = "a point from where the ball hides about half of the light";
    if (between < 150) {
        complain(asked, "shares like 0.4 or 0.6 of the light",
                 std::to_string(between) + " of 300 calls gave a share between none and all",
                 "each ray counts for itself: cast settings().shadowRayCount of them at different "
                 "points of the light, count those that arrive, and divide as double",
                 "Soft shadows (T2.1), steps 1 and 2");
        return;
    }
    const double share = shareOf(trial.mean(), point);
    if (share > 0.44 && share < 0.7) return;
    complain(asked, "about half of the light on average", inWords(share) + " of it",
             "the aim points must lie all around the light's centre, and "
             "the light grow in proportion to the share of rays that arrive",
             "Soft shadows (T2.1), steps 1 to 3");
}

TEST_F(SoftShadows, AreAsWideAsALightOfTheGivenRadius) {
    const double radius = handout_.lightSize;
    // How much stands out beyond the rim: where a ball, its surface, and points crowded in its
    // middle give from 3 to 25 of 100; nothing at all beyond the radius.
    struct Place {
        double clear;
        double least;
        double most;
    };
    for (const Place& place :
         {Place{-1.35 * radius, 0.0, 1e-9}, Place{-0.6 * radius, 0.01, 0.35},
          Place{0.6 * radius, 0.65, 0.995}, Place{1.35 * radius, 0.96, 1.04}}) {
        const Vector3 point = floorWhereLightIsClearBy(place.clear);
        const double share = shareOf(Trial{roomWithBall(), point, 300}.mean(), point);
        if (share >= place.least - 1e-9 && share <= place.most) continue;
        const bool hidden = place.clear < 0.0;
        const bool tooWide = hidden ? share > place.most : share < place.least;
        complain("a point from where the light's centre stands " +
                     inWords(std::abs(place.clear) / radius) + " radii " +
                     (hidden ? "behind" : "outside") + " the ball's rim",
                 "a share of the light from " + inWords(place.least) + " to " +
                     inWords(std::min(1.0, place.most)),
                 inWords(share),
                 tooWide ? "the light is too large: a point in a ball of radius "
                           "settings().lightSize is added to the light's position, not to the unit "
                           "direction towards it"
                         : "the light is too small: is settings().lightSize its radius?",
                 "Soft shadows (T2.1), step 1");
        return;
    }
}

TEST_F(SoftShadows, CastEnoughRaysForEachLight) {
    SceneDescription scene = roomWithBall();
    scene.pointLights.emplace_back(Vector3{-6.0, 3.0, 6.0}, ColourRGB{0.5, 0.6, 0.9}, 300.0);
    const Trial trial{scene, floorAt(1.4), 40};
    if (trial.rays().empty()) GTEST_SKIP() << "your code casts rays that the test cannot see";
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

/// Whether the rays' lines pass the light where they should.
class Aims {
public:
    Aims(const std::vector<Ray>& rays, const Vector3& light, double radius) {
        std::vector<Vector3> feet;
        for (const Ray& ray : rays) {
            feet.push_back(footFrom(light, ray) / radius);
            farthest_ = std::max(farthest_, feet.back().magnitude());
            mean_ += feet.back() / static_cast<double>(rays.size());
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
    }

    /// In radii of the light.
    [[nodiscard]] double farthest() const { return farthest_; }
    [[nodiscard]] double offCentre() const { return mean_.magnitude(); }
    /// 1: alike in all directions, 0: along a line.
    [[nodiscard]] double roundness() const { return roundness_; }

private:
    double farthest_ = 0.0;
    Vector3 mean_;
    double roundness_ = 1.0;
};

void judgeAims(const Aims& aims, const std::string& asked) {
    const std::string section = "Soft shadows (T2.1), step 1";
    const std::string expected = "aim points in a ball of radius settings().lightSize";
    // 3000 lines: of points crowded in the middle none passes beyond 0.9 radii with a chance of
    // 1e-40, and the mean strays by 0.1 radii with one of 1e-20.
    if (aims.farthest() > 1.003)
        complain(asked, expected,
                 "lines that pass the centre at " + inWords(aims.farthest()) + " radii",
                 "a cube in place of a ball, a light that is too large, an offset of the direction "
                 "in place of the light's position, or a shadow ray that starts somewhere else",
                 section);
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

TEST_F(SoftShadows, AimAtAllOfTheLightAndNothingElse) {
    // Three directions at right angles: what one cannot see, the others do.
    for (const Vector3& towards :
         {Vector3{0.6, 0.8, 0.0}, {-0.48, 0.36, 0.8}, {-0.64, 0.48, -0.6}}) {
        SceneDescription scene = emptyRoom();
        const Vector3 point = floorAt(0.0);
        const Vector3 light = point + towards * 100.0;
        scene.pointLights = {{light, ColourRGB{1.0}, 1e5}};
        const Trial trial{scene, point, 300};
        if (trial.rays().empty()) GTEST_SKIP() << "your code casts rays that the test cannot see";
        judgeAims({trial.rays(), light, handout_.lightSize},
                  "3000 shadow rays to a light 100 units away");
        if (HasFailure()) return;
    }
}

TEST_F(SoftShadows, StartAtThePointItself) {
    const Vector3 point = floorAt(1.5);
    const Trial trial{emptyRoom(), point, 40};
    if (trial.rays().empty()) GTEST_SKIP() << "your code casts rays that the test cannot see";
    double farthest = 0.0;
    for (const Ray& ray : trial.rays())
        farthest = std::max(farthest, (ray.origin - point).magnitude());
    if (farthest < 3e-3) return;
    complain("where the shadow rays start", "at P, lifted off the surface by kShadowBias",
             inWords(farthest) + " from P",
             "the light is what is spread out, not the point; the bias is 1e-4",
             "Soft shadows (T2.1), step 1");
}

TEST_F(SoftShadows, DrawFreshAimPointsEachTime) {
    const Trial trial{emptyRoom(), floorAt(1.5), 40};
    if (trial.rays().empty()) GTEST_SKIP() << "your code casts rays that the test cannot see";
    std::vector<Vector3> feet;
    for (const Ray& ray : trial.rays()) {
        const Vector3 foot = footFrom(kLight, ray);
        const bool known = std::ranges::any_of(
            feet, [&](const Vector3& other) { return (foot - other).magnitude() < 1e-7; });
        if (!known) feet.push_back(foot);
    }
    if (feet.size() > static_cast<std::size_t>(handout_.shadowRayCount)) return;
    if (feet.size() > 4) return;  // one pattern for all points is a matter of taste
    complain("all shadow rays of 40 calls", "many different aim points",
             std::to_string(feet.size()) + " in all",
             feet.size() == 1 ? "all rays aim at the light's centre"
                              : "draw a new random point for each ray",
             "Soft shadows (T2.1), step 1");
}

TEST_F(SoftShadows, AreNotCastByWhatStandsBehindTheLight) {
    SceneDescription scene = emptyRoom();
    const Vector3 point = floorAt(1.5);
    const Vector3 onwards = (kLight - point).normalised();
    scene.spheres.push_back({kLight + onwards * 2.5, 1.5, floorMaterial(), nullptr});
    const Trial trial{scene, point, 200};
    const ColourRGB expected = ambientOnly() + unshadowed(scene, 0, point).sum();
    if (isNear(trial.mean(), expected, 0.04)) return;
    complain("a point of the floor; a ball stands behind the light as seen from there",
             words(expected) + ", all of the light", words(trial.mean()) + " on average",
             "a hit counts only where it is nearer than the point on the light: compare the hit's "
             "distance with the length of the way there (directions of unit length!)",
             "Soft shadows (T2.1), step 1");
}

TEST_F(SoftShadows, AreCountedForEachLightByItself) {
    SceneDescription scene = roomWithBall();
    scene.pointLights.emplace_back(Vector3{-6.0, 3.0, 5.0}, ColourRGB{0.5, 0.6, 0.9}, 300.0);
    const Vector3 point = floorAt(0.2);
    const ColourRGB expected = ambientOnly() + unshadowed(scene, 1, point).sum();
    const Trial first{scene, point, 200};
    std::swap(scene.pointLights[0], scene.pointLights[1]);
    const Trial second{scene, point, 200};
    for (const ColourRGB& mean : {first.mean(), second.mean()}) {
        if (isNear(mean, expected, 0.04)) continue;
        complain("a point that the ball hides from one of two lights",
                 words(expected) + ", the ambient light and all of the other light",
                 words(mean) + " on average",
                 "the count of rays that arrive starts anew for each light, and ambient light is "
                 "added once",
                 "Soft shadows (T2.1), steps 2 and 3");
        return;
    }
}

TEST_F(SoftShadows, AreNotCastByASurfaceOnItself) {
    const Vector3 towards = (kLight - kBall).normalised();
    const Vector3 normal = (towards + Vector3{0.3, 0.0, 0.2}).normalised();
    const Vector3 point = kBall + normal * kBallRadius;
    const SceneDescription scene = roomWithBall();
    const Trial trial{scene, point, 200, 0};
    const Vector3 path = kLight - point;
    const ColourRGB expected =
        ambientOnly() + questions::phongTerms(floorMaterial(), scene.pointLights[0], normal,
                                              (kEye - point).normalised(), path.normalised(),
                                              path.magnitude())
                            .sum();
    if (isNear(trial.mean(), expected, 0.05)) return;
    complain("a point of the ball that looks at the light", words(expected) + ", all of the light",
             words(trial.mean()) + " on average",
             "the shadow ray must start a little above the surface: P + N * kShadowBias",
             "Soft shadows (T2.1), step 1");
}

}  // namespace
}  // namespace raytracer::tests

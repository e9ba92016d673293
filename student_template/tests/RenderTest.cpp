// Public tests of task T2.2, Renderer::render: depth of field.
#include <questions/RayGeometry.h>
#include <raytracer/base/Unfinished.h>
#include <raytracer/render/Renderer.h>
#include <support/Complaint.h>
#include <support/RayLog.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace raytracer::tests {
namespace {

constexpr int kRenders = 40;

void complain(const std::string& asked, const std::string& expected, const std::string& got,
              const std::string& cause, const std::string& section) {
    ADD_FAILURE() << Complaint{"T2.2", asked, expected, got, cause, section};
}

Material plain(const ColourRGB& colour) {
    Material material;
    material.colour = colour;
    material.reflectivity = 0.0;
    return material;
}

/// A wall of one colour. No light but the ambient one, so that nothing that `illuminate` does wrong
/// can be held against `render`.
SceneDescription wall() {
    SceneDescription scene;
    scene.planes.push_back({{0.0, 0.0, 10.0}, {0.0, 0.0, -1.0}, plain({0.3, 0.5, 0.7})});
    return scene;
}

/// Two large balls far behind the focal plane: each pixel's rays see partly the ball in front of
/// them and partly the wall. Left is red, right is green.
SceneDescription twoBalls() {
    SceneDescription scene = wall();
    scene.spheres.push_back({{-2.2, 0.0, 9.0}, 0.45, plain({0.9, 0.1, 0.1}), nullptr});
    scene.spheres.push_back({{2.2, 0.0, 9.0}, 0.45, plain({0.1, 0.9, 0.1}), nullptr});
    return scene;
}

/// Two pixels side by side, rendered many times.
class Trial {
public:
    Trial(const SceneDescription& description, int renders) : unwatched_(description) {
        const Scene scene{description, &log_};
        for (int i = 0; i < renders; ++i) {
            RenderSettings settings = twoPixels();
            settings.seed = 100U + static_cast<std::uint64_t>(i);
            settings.observer = &log_;
            log_.clear();
            const Image image = Renderer{settings}.render(scene);
            for (std::size_t pixel = 0; pixel < 2; ++pixel)
                colours_[pixel].push_back(image.at(static_cast<int>(pixel), 0));
            sortRays();
        }
    }

    static RenderSettings twoPixels() {
        RenderSettings settings;
        settings.width = 2;
        settings.height = 1;
        return settings;
    }

    /// Colours of the left pixel (0) or the right one (1), render by render.
    [[nodiscard]] const std::vector<ColourRGB>& colours(std::size_t pixel) const {
        return colours_[pixel];
    }
    /// Its camera rays, of all renders.
    [[nodiscard]] const std::vector<Ray>& rays(std::size_t pixel) const { return rays_[pixel]; }
    /// The fewest camera rays that one render cast for it.
    [[nodiscard]] std::size_t fewestRays() const { return fewest_; }
    [[nodiscard]] bool sawRays() const { return !rays_[0].empty() || !rays_[1].empty(); }
    [[nodiscard]] int mostBounces() const { return log_.mostBounces(); }

    /// Mean of what the pixel's rays meet.
    [[nodiscard]] ColourRGB meanOfRays(std::size_t pixel) const {
        ColourRGB sum;
        for (const Ray& ray : rays_[pixel]) {
            const auto hit = unwatched_.findClosestIntersection(ray);
            sum += hit ? hit->object->colour() : kBackgroundColour;
        }
        return sum / static_cast<double>(rays_[pixel].size());
    }

private:
    // Whatever starts before the first object comes from the camera. The pixels look to the left
    // and to the right by more than any lens point can turn a ray.
    void sortRays() {
        std::array<std::size_t, 2> counts{};
        for (const Ray& ray : log_.rays()) {
            if (ray.origin.z > 1.0) continue;
            const std::size_t pixel = ray.direction.x < 0.0 ? 0 : 1;
            rays_[pixel].push_back(ray);
            ++counts[pixel];
        }
        const std::size_t fewest = std::min(counts[0], counts[1]);
        fewest_ = started_ ? std::min(fewest_, fewest) : fewest;
        started_ = true;
    }

    Scene unwatched_;
    RayLog log_;
    std::array<std::vector<ColourRGB>, 2> colours_;
    std::array<std::vector<Ray>, 2> rays_;
    std::size_t fewest_ = 0;
    bool started_ = false;
};

const std::string kUnseen = "your code casts rays that the test cannot see";
const std::string kAsked = "a frame of 2 x 1 pixels, rendered 40 times";

class DepthOfField : public ::testing::Test {
protected:
    void SetUp() override {
        static_cast<void>(Trial{wall(), 1});
        if (isUnfinished("T2.2"))
            GTEST_SKIP()
                << "T2.2 is not attempted: the line unfinished(\"T2.2\", ...) still stands";
    }

    /// One series of renders is enough for all tests.
    static const Trial& trial() {
        static const Trial done{twoBalls(), kRenders};
        return done;
    }

    const RenderSettings handout_;
};

TEST_F(DepthOfField, KeepsTheColourOfAWallThatIsAlikeEverywhere) {
    const Trial trial{wall(), 3};
    const ColourRGB expected{0.3, 0.5, 0.7};
    for (const std::size_t pixel : {0U, 1U})
        for (const ColourRGB& got : trial.colours(pixel)) {
            if (std::abs(got.g - expected.g) < 1e-3) continue;
            const double factor = got.g / expected.g;
            complain("a wall of one colour in ambient light", "that colour",
                     inWords(factor) + " times that colour",
                     "the pixel gets the mean: the sum of all contributions, divided by their "
                     "number, once",
                     "Depth of field (T2.2), step 3");
            return;
        }
}

TEST_F(DepthOfField, CastsEnoughRaysThroughEachPixel) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const auto wanted = static_cast<std::size_t>(handout_.dofRayCount);
    if (trial().fewestRays() >= wanted) return;
    complain(kAsked, "at least " + std::to_string(wanted) + " camera rays for each pixel",
             std::to_string(trial().fewestRays()), "the loop runs settings().dofRayCount times",
             "Depth of field (T2.2), step 2");
}

/// Where the camera rays start, of both pixels together.
struct Lens {
    explicit Lens(const Trial& trial) {
        std::set<std::array<std::int64_t, 3>> keys;
        for (const std::size_t pixel : {0U, 1U})
            for (const Ray& ray : trial.rays(pixel)) {
                const Vector3& p = ray.origin;
                low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
                points.push_back(p);
                keys.insert(
                    {std::llround(p.x * 1e7), std::llround(p.y * 1e7), std::llround(p.z * 1e7)});
            }
        distinct = keys.size();
    }

    std::vector<Vector3> points;
    std::size_t distinct = 0;
    Vector3 low{1e9, 1e9, 1e9};
    Vector3 high{-1e9, -1e9, -1e9};

    [[nodiscard]] double widest() const { return std::max(high.x - low.x, high.y - low.y) / 2.0; }
    [[nodiscard]] double narrowest() const {
        return std::min(high.x - low.x, high.y - low.y) / 2.0;
    }
};

TEST_F(DepthOfField, StartsItsRaysAllOverALens) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const Lens lens{trial()};
    const auto wanted = static_cast<std::size_t>(handout_.dofRayCount);
    if (lens.distinct * 2 >= wanted) return;
    complain(kAsked + ": where the rays start", "many different points of the lens",
             std::to_string(lens.distinct) + " in all",
             lens.distinct == 1 ? "every ray starts at the eye: give each one an origin of its own"
                                : "draw a new lens point for each ray, not for each frame",
             "Depth of field (T2.2), step 2");
}

TEST_F(DepthOfField, DrawsNewLensPointsForEachRayOfAPixel) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const Trial once{twoBalls(), 1};
    const Lens lens{once};
    const auto wanted = static_cast<std::size_t>(handout_.dofRayCount);
    if (lens.distinct * 2 >= wanted) return;
    complain("one frame of 2 x 1 pixels: where the rays start",
             "many different points of the lens for each pixel",
             std::to_string(lens.distinct) + " in all",
             "the lens point must be drawn inside the innermost loop",
             "Depth of field (T2.2), step 2");
}

TEST_F(DepthOfField, HasASquareLensAroundTheEye) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const Lens lens{trial()};
    const double amount = handout_.dofAmount;
    // Cells' middles of a regular grid reach less far than random points.
    const double least = lens.distinct > 500 ? 0.96 : 0.75;
    const std::string expected = "a square in the plane z = 0, centred on the eye";
    const std::string section = "Depth of field (T2.2), step 2";
    const double off =
        std::max(std::abs(lens.low.x + lens.high.x), std::abs(lens.low.y + lens.high.y));
    const auto fits = [&](double half) {
        return lens.widest() <= 1.003 * half && lens.widest() >= least * half;
    };
    if (lens.high.z - lens.low.z > 1e-4 || std::abs(lens.high.z) > 1e-4)
        complain(kAsked + ": where the rays start", expected,
                 "z from " + inWords(lens.low.z) + " to " + inWords(lens.high.z),
                 "the lens is flat: only x and y are random", section);
    else if (off > 0.1 * lens.widest() + 1e-9)
        complain(kAsked + ": where the rays start", expected,
                 "x from " + inWords(lens.low.x) + " to " + inWords(lens.high.x) + ", y from " +
                     inWords(lens.low.y) + " to " + inWords(lens.high.y),
                 "random numbers from 0 to 1 where -1 to 1 was meant", section);
    else if (!fits(amount) && !fits(0.5 * amount))
        complain(kAsked + ": where the rays start",
                 "half a side of settings().dofAmount, or half of that (both readings are right)",
                 "half a side of " + inWords(lens.widest()), "scale by settings().dofAmount once",
                 section);
    else if (lens.narrowest() < 0.75 * lens.widest())
        complain(kAsked + ": where the rays start", expected,
                 "x from " + inWords(lens.low.x) + " to " + inWords(lens.high.x) + ", y from " +
                     inWords(lens.low.y) + " to " + inWords(lens.high.y),
                 "both coordinates are random", section);
}

TEST_F(DepthOfField, FillsTheSquareEvenly) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const Lens lens{trial()};
    if (!(lens.narrowest() > 1e-6)) return;  // another test says so
    double corners = 0.0;
    double inner = 0.0;
    double diagonal = 0.0;
    for (const Vector3& point : lens.points) {
        const double x = point.x / lens.widest();
        const double y = point.y / lens.widest();
        if (x * x + y * y > 1.0) corners += 1.0;
        if (std::max(std::abs(x), std::abs(y)) < 0.5) inner += 1.0;
        diagonal += 3.0 * x * y;
    }
    const double count = static_cast<double>(lens.points.size());
    // A square has 21 % of its points outside of the largest disc in it, 25 % in its inner quarter,
    // and x and y are independent. Among 50 points the shares stray by 0.06.
    const double slack = lens.distinct > 500 ? 0.06 : 0.2;
    std::string got;
    std::string cause = "x and y are uniform, each by itself, from -1 to 1";
    if (corners / count < 0.215 - slack) {
        got = percent(corners / count) + " of the points lie in the corners";
        cause = "the lens is a disc; a square was asked for";
    } else if (std::abs(inner / count - 0.25) > 1.5 * slack) {
        got = percent(inner / count) + " of the points lie in the inner quarter of the square";
    } else if (std::abs(diagonal / count) > 2.0 * slack) {
        got = "points along a diagonal";
        cause = "x and y need random numbers of their own";
    }
    if (!got.empty())
        complain(kAsked + ": where the rays start", "points evenly all over a square", got, cause,
                 "Depth of field (T2.2), step 2");
}

/// Where the rays of one pixel come together: the point with the least sum of squared distances
/// from their lines.
class Meeting {
public:
    explicit Meeting(const std::vector<Ray>& rays) {
        // Sum of (I - d d^T) p = sum of (I - d d^T) o
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

    /// False where the rays are parallel, or one and the same.
    [[nodiscard]] bool clear() const { return clear_; }
    [[nodiscard]] const Vector3& point() const { return point_; }
    /// Of all rays' lines from the point.
    [[nodiscard]] double farthest() const { return farthest_; }

private:
    bool clear_ = false;
    Vector3 point_;
    double farthest_ = 0.0;
};

TEST_F(DepthOfField, BringsThePixelsRaysTogetherInTheFocalPlane) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const Camera camera{Trial::twoPixels()};
    for (const std::size_t pixel : {0U, 1U}) {
        const std::vector<Ray>& rays = trial().rays(pixel);
        if (rays.size() < 2) continue;  // another test says so
        const Meeting meeting{rays};
        if (!meeting.clear() && Lens{trial()}.widest() < 1e-6) return;  // a pinhole, likewise
        const std::string asked = std::string("the rays of the ") +
                                  (pixel == 0 ? "left" : "right") +
                                  " of two pixels, from all renders";
        const std::string section = "Depth of field (T2.2), steps 1 and 2";
        if (!meeting.clear() || meeting.farthest() > 2e-3) {
            complain(asked, "rays that come together in one point",
                     meeting.clear()
                         ? "rays that pass the best point at up to " + inWords(meeting.farthest())
                         : "parallel rays",
                     "each ray goes from its lens point to the one focal point of the pixel: "
                     "direction = focal point minus lens point",
                     section);
            return;
        }
        const Vector3 pinhole = camera.castRay(static_cast<int>(pixel), 0).direction;
        const double off = pinhole.cross(meeting.point()).magnitude();
        if (off > 5e-3) {
            complain(asked, "a focal point on the ray of the pinhole camera",
                     "a point " + inWords(off) + " beside it",
                     "the focal point is where camera.castRay(x, y) meets the focal plane",
                     section);
            return;
        }
        const double plane = handout_.dofFocalPlane;
        if (std::abs(meeting.point().z - plane) < 2e-3 * plane) continue;
        const bool alongRay = std::abs(meeting.point().magnitude() - plane) < 2e-3 * plane;
        complain(asked, "a focal point with z = settings().dofFocalPlane = " + inWords(plane),
                 "z = " + inWords(meeting.point().z),
                 alongRay ? "dofFocalPlane is the z of a plane, not a length along the ray"
                          : "the rays are in focus at another depth",
                 section);
        return;
    }
}

TEST_F(DepthOfField, AveragesWhatItsRaysSee) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    if (trial().rays(0).empty() || trial().rays(1).empty()) return;  // another test says so
    for (const std::size_t pixel : {0U, 1U}) {
        ColourRGB mean;
        for (const ColourRGB& colour : trial().colours(pixel))
            mean += colour / kRenders;
        const ColourRGB expected = trial().meanOfRays(pixel);
        const double apart = std::max({std::abs(mean.r - expected.r), std::abs(mean.g - expected.g),
                                       std::abs(mean.b - expected.b)});
        if (apart < 0.02) continue;
        complain(kAsked + " in front of two balls and a wall",
                 "(" + inWords(expected.r) + ", " + inWords(expected.g) + ", " +
                     inWords(expected.b) + "), the mean of what the pixel's rays meet",
                 "(" + inWords(mean.r) + ", " + inWords(mean.g) + ", " + inWords(mean.b) + ")",
                 "sum the linear colours of all rays, divide by their number, and set that very "
                 "pixel",
                 "Depth of field (T2.2), step 3");
        return;
    }
}

TEST_F(DepthOfField, MixesColoursInEveryFrame) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const Lens lens{trial()};
    if (lens.widest() < 0.05) return;  // another test says so
    int pure = 0;
    for (const std::size_t pixel : {0U, 1U})
        for (const ColourRGB& colour : trial().colours(pixel)) {
            const double share = (0.7 - colour.b) / 0.6;  // of the ball
            if (share < 0.005 || share > 0.995) ++pure;
        }
    if (pure < kRenders) return;
    complain(kAsked + " at the rims of two balls", "mixtures of ball and wall",
             "one of the two in " + std::to_string(pure) + " of " + std::to_string(2 * kRenders) +
                 " pixels",
             "the pixel must get the mean of all rays, not the last one or the median",
             "Depth of field (T2.2), step 3");
}

TEST_F(DepthOfField, FollowsAsManyReflectionsAsAsked) {
    if (trial().mostBounces() < 0) GTEST_SKIP() << "your code does not call trace";
    const int wanted = handout_.bounces;
    if (trial().mostBounces() == wanted) return;
    complain("the last argument of trace",
             "settings().bounces, " + std::to_string(wanted) + " here",
             std::to_string(trial().mostBounces()),
             "each camera ray may be reflected as often as "
             "before",
             "Depth of field (T2.2), step 3");
}

}  // namespace
}  // namespace raytracer::tests

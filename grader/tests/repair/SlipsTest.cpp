// Edits that mend mistakes which the catalogue does not have.
#include <grader/base/WholeFile.h>
#include <grader/corpus/Entry.h>
#include <grader/tests/repair/FoundEdits.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace ticker::repair {
namespace {

constexpr const char* kStar = "tick1star";
constexpr const char* kTick = "tick1";

/// A mistake, and its edit.
struct Slip {
    const char* name;
    const char* exercise;
    const char* file;
    Reach reach;
    corpus::Edit wrong;  ///< of the reference solution
    corpus::Edit mend;   ///< of that
    const char* leftAlone = "";
};

std::string nameOfSlip(const testing::TestParamInfo<Slip>& slip) {
    std::string name = slip.param.name;
    std::ranges::replace(name, '-', '_');
    return name;
}

class EditsOfSlips : public testing::TestWithParam<Slip> {};

TEST_P(EditsOfSlips, HoldTheOneThatMendsIt) {
    const Slip& slip = GetParam();
    const Exercise& exercise = exerciseNamed(slip.exercise);
    const std::string reference =
        readWhole(std::filesystem::path{TICKER_SOURCE_DIR} / exercise.reference / slip.file);
    const std::string wrong = corpus::applyEdits(reference, {slip.wrong}, slip.name);
    const std::string right = tests::tokens(corpus::applyEdits(wrong, {slip.mend}, slip.name));
    const Candidates candidates =
        tests::found(slip.exercise, slip.file, wrong, slip.reach, slip.leftAlone);
    EXPECT_TRUE(std::ranges::any_of(candidates.atoms, [&](const Atom& atom) {
        const auto edited = withEdits(wrong, atom.edits);
        return edited && tests::tokens(*edited) == right;
    }));
}

constexpr const char* kRenderer = "Renderer.cpp";
constexpr const char* kFind =
    "const std::optional<RaycastHit> occluder = scene.findClosestIntersection(shadowRay);";
constexpr const char* kShade = "return occluder && occluder->distance < path.magnitude();";

INSTANTIATE_TEST_SUITE_P(
    Draws, EditsOfSlips,
    testing::Values(Slip{
        "one-number-for-both",
        kStar,
        kRenderer,
        Reach::simple,
        {"const Vector3 lensPoint{randomBetween(-settings().dofAmount, settings().dofAmount),",
         "const double a = randomBetween(-1.0, 1.0) * settings().dofAmount;\n"
         "const Vector3 lensPoint{a,"},
        {"lensPoint{a,", "lensPoint{randomBetween(-1.0, 1.0) * settings().dofAmount,"}}),
    nameOfSlip);
INSTANTIATE_TEST_SUITE_P(
    Formulas, EditsOfSlips,
    testing::Values(
        Slip{"another-shape-of-the-light",
             kStar,
             kRenderer,
             Reach::wide,
             {"light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;",
              "light.position() + Vector3{randomBetween(-1.0, 1.0), 0.0, 0.0};"},
             {"Vector3{randomBetween(-1.0, 1.0), 0.0, 0.0};",
              "Vector3::randomInsideUnitSphere() * settings().lightSize;"}},
        Slip{"plane-that-faces-the-camera",
             kTick,
             "Plane.cpp",
             Reach::wide,
             {"(point() - ray.origin).dot(normal()) / slope",
              "(point().z - ray.origin.z) / ray.direction.z"},
             {"(point().z - ray.origin.z) / ray.direction.z",
              "(point() - ray.origin).dot(normal()) / ray.direction.dot(normal())"}},
        Slip{"radius-not-squared",
             kTick,
             "Sphere.cpp",
             Reach::wide,
             {"fromCentre.dot(fromCentre) - radius() * radius()", "fromCentre.dot(fromCentre)"},
             {"c = fromCentre.dot(fromCentre)",
              "c = (ray.origin - centre()).dot(ray.origin - centre()) - radius() * radius()"}},
        Slip{"focal-point-of-its-own",
             kStar,
             kRenderer,
             Reach::wide,
             {"focalPoint =\n            pinholeRay.evaluateAt(settings().dofFocalPlane / "
              "pinholeRay.direction.z);",
              "focalPoint{pinholeRay.direction.x, pinholeRay.direction.y, 1.0};"},
             {"focalPoint{pinholeRay.direction.x, pinholeRay.direction.y, 1.0};",
              "focalPoint = pinholeRay.evaluateAt(settings().dofFocalPlane / "
              "pinholeRay.direction.z);"}}),
    nameOfSlip);
INSTANTIATE_TEST_SUITE_P(
    Conditions, EditsOfSlips,
    testing::Values(
        Slip{"only-sometimes",
             kStar,
             kRenderer,
             Reach::simple,
             {"++reached;", "if (P.x > 0.0) ++reached;"},
             {"if (P.x > 0.0) ++reached;", "++reached;"}},
        Slip{"flag",
             kStar,
             kRenderer,
             Reach::simple,
             {"int reached = 0;",
              "int reached = 0; const bool soft = O.z == 0.0; if (soft) "
              "reached = 0;"},
             {"soft = O.z == 0.0;", "soft = true;"}},
        Slip{"first-object-only",
             kTick,
             kRenderer,
             Reach::simple,
             {kFind,
              "for (const auto& o : scene.objects()) { const auto hit = "
              "o->intersectionWith(shadowRay); return hit.has_value(); }\n"
              "const std::optional<RaycastHit> occluder;"},
             {"return hit.has_value();", "if (hit.has_value()) return true;"}},
        Slip{"last-hit",
             kTick,
             kRenderer,
             Reach::wide,
             {kFind,
              "std::optional<RaycastHit> occluder; for (const auto& o : scene.objects()) { "
              "std::optional<RaycastHit> hit = o->intersectionWith(shadowRay); if (hit) "
              "occluder = hit; }"},
             {"if (hit)", "if ((hit && (!occluder || hit->distance < occluder->distance)))"}},
        Slip{"every-hit-counts",
             kTick,
             kRenderer,
             Reach::simple,
             {kShade,
              "int count = 0; for (const auto& o : scene.objects()) if "
              "(o->intersectionWith(shadowRay)) ++count; return count == 1 && occluder;"},
             {"++count;", "{ ++count; break; }"}},
        Slip{"rays-that-are-blocked",
             kStar,
             kRenderer,
             Reach::simple,
             {"if (!occluder || occluder->distance > towards.magnitude()) ++reached;",
              "if (occluder && occluder->distance <= towards.magnitude()) ++reached;"},
             {"if (occluder && occluder->distance <= towards.magnitude())",
              "if (!(occluder && occluder->distance <= towards.magnitude()))"}},
        Slip{"pass-over-the-picture",
             kStar,
             kRenderer,
             Reach::simple,
             {"return image;",
              "for (int x = 0; x < image.width(); ++x) image.set(x, 0, ColourRGB{});\n"
              "return image;"},
             {"for (int x = 0; x < image.width(); ++x) image.set(x, 0, ColourRGB{});", ""}},
        Slip{"another-picture",
             kStar,
             kRenderer,
             Reach::simple,
             {"return image;", "Image smooth = image; return smooth;"},
             {"return smooth;", "return image;"}},
        Slip{"a-line-of-the-stub-twice",
             kTick,
             kRenderer,
             Reach::simple,
             {"I * (object.phongKD() * std::max(0.0, N.dot(L)));",
              "I * (object.phongKD() * std::max(0.0, N.dot(L)));\nreturn colour;"},
             {"N.dot(L)));\nreturn colour;", "N.dot(L)));\ncontinue;"}},
        Slip{"first-of-all",
             kTick,
             kRenderer,
             Reach::wide,
             {"scene.findClosestIntersection(shadowRay)",
              "scene.objects().front()->intersectionWith(shadowRay)"},
             {"scene.objects().front()->intersectionWith(shadowRay)",
              "scene.findClosestIntersection(shadowRay)"}}),
    nameOfSlip);
INSTANTIATE_TEST_SUITE_P(
    Numbers, EditsOfSlips,
    testing::Values(
        Slip{"precedence",
             kTick,
             "Sphere.cpp",
             Reach::simple,
             {"(-b - root) / (2.0 * a)", "-b - root / (2.0 * a)"},
             {"-b - root / (2.0 * a)", "(-b - root) / (2.0 * a)"}},
        Slip{"fixed-alpha",
             kTick,
             kRenderer,
             Reach::wide,
             {"object.phongAlpha()", "10"},
             {"R.dot(V)), 10)", "R.dot(V)), object.phongAlpha())"},
             "isShadowed,trace,"},
        Slip{"normal-not-unit",
             kTick,
             "Sphere.cpp",
             Reach::simple,
             {"getNormalAt(location)", "location - centre()"},
             {"location - centre()}", "(location - centre()).normalised()}"}},
        Slip{"column-beside",
             kStar,
             "BumpySphere.cpp",
             Reach::wide,
             {"map.at(column, rowBelow)", "map.at(columnRight, rowBelow)"},
             {"map.at(columnRight, rowBelow)",
              "map.at((columnRight + map.width() - 1) % map.width(), rowBelow)"}},
        Slip{"along-the-ray",
             kStar,
             kRenderer,
             Reach::wide,
             {"pinholeRay.evaluateAt(settings().dofFocalPlane / pinholeRay.direction.z)",
              "pinholeRay.direction * settings().dofFocalPlane"},
             {"pinholeRay.direction * settings().dofFocalPlane",
              "pinholeRay.direction * (settings().dofFocalPlane / pinholeRay.direction.z)"},
             "illuminate,"},
        Slip{"beside-whole-numbers",
             kStar,
             "BumpySphere.cpp",
             Reach::simple,
             {"const Vector3 normal = Sphere::getNormalAt(position);",
              "const Vector3 normal = Sphere::getNormalAt(position);\n"
              "const Vector3 axis = normal.y < 0.9 ? Vector3{0, -1, 0} : Vector3{1, 0, 0};"},
             {"normal.y < 0.9", "normal.y < 1.0"}},
        Slip{"wide-pole",
             kStar,
             "BumpySphere.cpp",
             Reach::simple,
             {"const Vector3 normal = Sphere::getNormalAt(position);",
              "const Vector3 normal = Sphere::getNormalAt(position);\n"
              "constexpr double kPole = 0.97;\n"
              "if (std::abs(normal.y) > kPole) return normal;"},
             {"> kPole", "> 0.9999999"}},
        Slip{"coarse-zero",
             kTick,
             "Sphere.cpp",
             Reach::simple,
             {"const double a = D.dot(D);",
              "const double a = D.dot(D); if (a < 0.01) return std::nullopt;"},
             {"a < 0.01", "a < 1e-9"}},
        Slip{"modulo-by-mask",
             kStar,
             "BumpySphere.cpp",
             Reach::simple,
             {"(column + 1) % map.width()", "(column + 1) & (map.width() - 1)"},
             {"(column + 1) & (map.width() - 1)", "(column + 1) % map.width()"}},
        Slip{"number-in-one-of-two-calls",
             kStar,
             kRenderer,
             Reach::simple,
             {"ColourRGB sum;",
              "ColourRGB sum = trace(scene, pinholeRay, settings().bounces);\n"
              "sum += trace(scene, pinholeRay, 1);"},
             {"trace(scene, pinholeRay, 1)", "trace(scene, pinholeRay, settings().bounces)"}},
        Slip{"radius-in-an-int",
             kTick,
             "Sphere.cpp",
             Reach::simple,
             {"const double a = D.dot(D);", "const int r = radius(); const double a = D.dot(D);"},
             {"int r", "double r"}},
        Slip{"cut-colour",
             kTick,
             kRenderer,
             Reach::simple,
             {"return colour;",
              "return {std::min(colour.r, 1.0), std::min(colour.g, 1.0), "
              "std::min(colour.b, 1.0)};"},
             {"return {std::min(colour.r, 1.0), std::min(colour.g, 1.0), std::min(colour.b, "
              "1.0)};",
              "return colour;"}}),
    nameOfSlip);

INSTANTIATE_TEST_SUITE_P(
    Sums, EditsOfSlips,
    testing::Values(
        Slip{
            "one-count-for-all-lights",
            kStar,
            kRenderer,
            Reach::simple,
            {"for (const PointLight& light : scene.pointLights()) {",
             "int arrived = 0;\nfor (const PointLight& light : scene.pointLights()) {\n++arrived;"},
            {"++arrived;", "arrived = 0; ++arrived;"}},
        Slip{"begins-with-the-pinhole-ray",
             kStar,
             kRenderer,
             Reach::simple,
             {"ColourRGB sum;", "ColourRGB sum = trace(scene, pinholeRay, settings().bounces);"},
             {"ColourRGB sum = trace(scene, pinholeRay, settings().bounces);",
              "ColourRGB sum = ColourRGB{};"}},
        Slip{"one-sum-for-all-pixels",
             kStar,
             kRenderer,
             Reach::simple,
             {"forEachPixel(image, [&](int x, int y) {",
              "ColourRGB all;\nforEachPixel(image, [&](int x, int y) {\nall += ColourRGB{1.0};"},
             {"all += ColourRGB{1.0};", "all = {}; all += ColourRGB{1.0};"}},
        Slip{"all-signs",
             kStar,
             "BumpySphere.cpp",
             Reach::simple,
             {"normal + Bu * normal.cross(Pv) - Bv * normal.cross(Pu)",
              "normal - Bu * normal.cross(Pv) + Bv * normal.cross(Pu)"},
             {"normal - Bu * normal.cross(Pv) + Bv * normal.cross(Pu)",
              "normal + Bu * normal.cross(Pv) - Bv * normal.cross(Pu)"}},
        Slip{"ambient-in-the-product",
             kStar,
             kRenderer,
             Reach::simple,
             {"colour += (diffuse + specular) *", "colour = (colour + diffuse + specular) *"},
             {"(colour + diffuse + specular) *", "colour + (diffuse + specular) *"},
             "render,"},
        Slip{"two-axes",
             kTick,
             "Sphere.cpp",
             Reach::simple,
             {"fromCentre.dot(fromCentre)",
              "fromCentre.x * fromCentre.x + fromCentre.y * fromCentre.y"},
             {"fromCentre.y * fromCentre.y",
              "fromCentre.y * fromCentre.y + fromCentre.z * fromCentre.z"}},
        Slip{"shares-as-numbers",
             kTick,
             kRenderer,
             Reach::wide,
             {"direct * (1.0 - share) + trace(scene, reflected, bouncesLeft - 1) * share",
              "direct * 0.6 + trace(scene, reflected, bouncesLeft - 1) * 0.4"},
             {"direct * 0.6 + trace(scene, reflected, bouncesLeft - 1) * 0.4",
              "direct * (1.0 - share) + trace(scene, reflected, bouncesLeft - 1) * share"},
             "illuminate,isShadowed,"},
        Slip{
            "shares-as-numbers-of-an-object",
            kTick,
            kRenderer,
            Reach::wide,
            {"const double share = object.reflectivity();\n"
             "    if (bouncesLeft == 0 || share == 0.0) return direct;\n"
             "    const Vector3 R = (-ray.direction).reflectIn(N);\n"
             "    const Ray reflected{P + N * kShadowBias, R};\n"
             "    return direct * (1.0 - share) + trace(scene, reflected, bouncesLeft - 1) * share",
             "if (bouncesLeft == 0 || object.reflectivity() == 0.0) return direct;\n"
             "    const Ray reflected{P + N * kShadowBias, (-ray.direction).reflectIn(N)};\n"
             "    return direct * 0.6 + trace(scene, reflected, bouncesLeft - 1) * 0.4"},
            {"direct * 0.6 + trace(scene, reflected, bouncesLeft - 1) * 0.4",
             "direct * (1.0 - object.reflectivity()) + trace(scene, reflected, bouncesLeft - 1) * "
             "object.reflectivity()"},
            "illuminate,isShadowed,"},
        Slip{"whole-random-number",
             kStar,
             kRenderer,
             Reach::simple,
             {"const Vector3 lensPoint{randomBetween(-settings().dofAmount, settings().dofAmount),",
              "const double a = 2 * (std::rand() / RAND_MAX) - 1;\n"
              "const Vector3 lensPoint{a,"},
             {"2 * (std::rand() / RAND_MAX) - 1",
              "2 * (static_cast<double>(std::rand()) / RAND_MAX) - 1"},
             "illuminate,"},
        Slip{"arguments-of-a-lambda",
             kStar,
             "BumpySphere.cpp",
             Reach::simple,
             {"const double Bu = map.at(columnRight, row) -",
              "const auto at = [&](int x, int y) { return map.at(x, y); };\n"
              "const double Bu = at(row, columnRight) -"},
             {"at(row, columnRight)", "at(columnRight, row)"}}),
    nameOfSlip);
constexpr const char* kRoots =
    "const double near = (-b - root) / (2.0 * a);\n"
    "    const double far = (-b + root) / (2.0 * a);\n"
    "    const double distance = near > 0.0 ? near : far;";
constexpr const char* kNearer = "near > 0.0 ? near : far";
constexpr const char* kSphere = "Sphere.cpp";
INSTANTIATE_TEST_SUITE_P(
    Roots, EditsOfSlips,
    testing::Values(Slip{"second-root-not-used",
                         kTick,
                         kSphere,
                         Reach::simple,
                         {kNearer, "near"},
                         {"distance = near;", "distance = near > 0.0 ? near : far;"}},
                    Slip{"smaller-root",
                         kTick,
                         kSphere,
                         Reach::simple,
                         {kNearer, "std::min(near, far)"},
                         {"std::min(near, far)", kNearer}},
                    Slip{"second-root-missing",
                         kTick,
                         kSphere,
                         Reach::simple,
                         {kRoots, "double distance = (-b - std::sqrt(discriminant)) / (2.0 * a);"},
                         {"(-b - std::sqrt(discriminant)) / (2.0 * a);",
                          "(-b - std::sqrt(discriminant)) / (2.0 * a) > 0.0 ? "
                          "(-b - std::sqrt(discriminant)) / (2.0 * a) : "
                          "(-b + std::sqrt(discriminant)) / (2.0 * a);"}},
                    Slip{"first-of-sorted-roots",
                         kTick,
                         kSphere,
                         Reach::simple,
                         {kRoots,
                          "double roots[] = {(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)};\n"
                          "    const double distance = roots[0];"},
                         {"distance = roots[0];",
                          "distance = roots[0] > 0.0 ? roots[0] : roots[1];"}}),
    nameOfSlip);

}  // namespace
}  // namespace ticker::repair

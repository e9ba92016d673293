// Which edits are found, without asking or judging: one of them turns each of these mistakes back
// into the reference solution.
#include <grader/base/WholeFile.h>
#include <grader/corpus/Entry.h>
#include <grader/repair/Candidates.h>
#include <grader/repair/candidates/Tokens.h>
#include <grader/sandbox/SandboxPolicy.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace ticker::repair {
namespace {

struct Case {
    const char* exercise;
    const char* name;
    Reach reach;
    const char* leftAlone = "";  ///< functions that hold no mistake
};

// The name is what GoogleTest prints.
void PrintTo(const Case& mistake, std::ostream* out) {
    *out << mistake.name;
}

corpus::Entry mistakeOf(const Case& wanted) {
    for (corpus::Entry& entry :
         corpus::readEntries(TICKER_SOURCE_DIR, {"mistakes"}, exerciseNamed(wanted.exercise)))
        if (entry.name == wanted.name) return entry;
    throw std::runtime_error(std::string{"no mistake "} + wanted.name);
}

/// Without blanks and comments.
std::string tokens(const std::string& text) {
    std::string all;
    for (const candidates::Range& token : candidates::tokensOf(text))
        all += text.substr(token.begin, token.size()) + " ";
    return all;
}

Candidates found(const Case& mistake, const std::string& file, const std::string& text) {
    const auto candidates = findCandidates(
        build::Kit::besideProgram(exerciseNamed(mistake.exercise)), sandbox::Sandbox::best(),
        sandbox::defaultPolicy().compile, file, text, mistake.reach, mistake.leftAlone);
    if (!candidates) throw std::runtime_error("cannot be parsed");
    return *candidates;
}

class EditsOfMistakes : public testing::TestWithParam<Case> {};

TEST_P(EditsOfMistakes, HoldTheOneThatMendsIt) {
    corpus::Entry entry = mistakeOf(GetParam());
    const std::string file = entry.file();
    const std::string wrong = corpus::textsOf(entry).at(file);
    entry.edits = {{file, {}}};
    const std::string right = tokens(corpus::textsOf(entry).at(file));

    const Candidates candidates = found(GetParam(), file, wrong);
    EXPECT_TRUE(std::ranges::any_of(candidates.atoms, [&](const Atom& atom) {
        const auto edited = withEdits(wrong, atom.edits);
        return !atom.isApart && edited && tokens(*edited) == right;
    }));
}

constexpr const char* kStarred = "tick1star";
constexpr const char* kMain = "tick1";

INSTANTIATE_TEST_SUITE_P(Jumps, EditsOfMistakes,
                         testing::Values(Case{kMain, "returns-early", Reach::simple},
                                         Case{kMain, "ambient-shaded", Reach::simple},
                                         Case{kMain, "loop-ends", Reach::simple}));
INSTANTIATE_TEST_SUITE_P(Roots, EditsOfMistakes,
                         testing::Values(Case{kMain, "far-root", Reach::wide},
                                         Case{kMain, "inside-no-hit", Reach::wide},
                                         Case{kMain, "behind-absolute", Reach::wide},
                                         Case{kMain, "root-not-taken", Reach::wide},
                                         Case{kMain, "radius-not-squared", Reach::wide}));
INSTANTIATE_TEST_SUITE_P(CallsOfOneArgument, EditsOfMistakes,
                         testing::Values(Case{kMain, "location-is-point", Reach::wide},
                                         Case{kMain, "no-falloff", Reach::wide},
                                         Case{kMain, "intensity-alone", Reach::wide},
                                         Case{kMain, "normal-of-ray", Reach::wide}));
INSTANTIATE_TEST_SUITE_P(
    Steps, EditsOfMistakes,
    testing::Values(Case{kMain, "starts-at-origin", Reach::wide, "illuminate,isShadowed,"},
                    Case{kMain, "one-bounce-only", Reach::wide, "illuminate,isShadowed,"}));
INSTANTIATE_TEST_SUITE_P(Angles, EditsOfMistakes,
                         testing::Values(Case{kStarred, "atan-without-quadrant", Reach::simple},
                                         Case{kStarred, "rows-by-height", Reach::wide}));
INSTANTIATE_TEST_SUITE_P(Terms, EditsOfMistakes,
                         testing::Values(Case{kMain, "nearest-point", Reach::wide},
                                         Case{kMain, "radius-left-out", Reach::wide},
                                         Case{kMain, "along-normal", Reach::wide}));
INSTANTIATE_TEST_SUITE_P(
    Blends, EditsOfMistakes,
    testing::Values(Case{kMain, "direct-lost", Reach::wide, "illuminate,isShadowed,"},
                    Case{kMain, "direct-whole", Reach::wide, "illuminate,isShadowed,"},
                    Case{kMain, "seen-from-camera", Reach::wide, "illuminate,isShadowed,"}));

/// A mistake that the catalogue does not have, and its edit.
struct Slip {
    const char* name;
    const char* exercise;
    const char* file;
    Reach reach;
    corpus::Edit wrong;  ///< of the reference solution
    corpus::Edit mend;   ///< of that
    const char* leftAlone = "";
};

void PrintTo(const Slip& slip, std::ostream* out) {
    *out << slip.name;
}

class EditsOfSlips : public testing::TestWithParam<Slip> {};

TEST_P(EditsOfSlips, HoldTheOneThatMendsIt) {
    const Slip& slip = GetParam();
    const Exercise& exercise = exerciseNamed(slip.exercise);
    const std::string reference =
        readWhole(std::filesystem::path{TICKER_SOURCE_DIR} / exercise.reference / slip.file);
    const std::string wrong = corpus::applyEdits(reference, {slip.wrong}, slip.name);
    const std::string right = tokens(corpus::applyEdits(wrong, {slip.mend}, slip.name));
    const Candidates candidates =
        found({slip.exercise, slip.name, slip.reach, slip.leftAlone}, slip.file, wrong);
    EXPECT_TRUE(std::ranges::any_of(candidates.atoms, [&](const Atom& atom) {
        const auto edited = withEdits(wrong, atom.edits);
        return edited && tokens(*edited) == right;
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
        kStarred,
        kRenderer,
        Reach::simple,
        {"const Vector3 lensPoint{randomBetween(-settings().dofAmount, settings().dofAmount),",
         "const double a = randomBetween(-1.0, 1.0) * settings().dofAmount;\n"
         "const Vector3 lensPoint{a,"},
        {"lensPoint{a,", "lensPoint{randomBetween(-1.0, 1.0) * settings().dofAmount,"}}));
INSTANTIATE_TEST_SUITE_P(
    Conditions, EditsOfSlips,
    testing::Values(
        Slip{"only-sometimes",
             kStarred,
             kRenderer,
             Reach::simple,
             {"++reached;", "if (P.x > 0.0) ++reached;"},
             {"if (P.x > 0.0) ++reached;", "++reached;"}},
        Slip{"flag",
             kStarred,
             kRenderer,
             Reach::simple,
             {"int reached = 0;",
              "int reached = 0; const bool soft = O.z == 0.0; if (soft) "
              "reached = 0;"},
             {"soft = O.z == 0.0;", "soft = true;"}},
        Slip{"first-object-only",
             kMain,
             kRenderer,
             Reach::simple,
             {kFind,
              "for (const auto& o : scene.objects()) { const auto hit = "
              "o->intersectionWith(shadowRay); return hit.has_value(); }\n"
              "const std::optional<RaycastHit> occluder;"},
             {"return hit.has_value();", "if (hit.has_value()) return true;"}},
        Slip{"last-hit",
             kMain,
             kRenderer,
             Reach::wide,
             {kFind,
              "std::optional<RaycastHit> occluder; for (const auto& o : scene.objects()) { "
              "std::optional<RaycastHit> hit = o->intersectionWith(shadowRay); if (hit) "
              "occluder = hit; }"},
             {"if (hit)", "if ((hit && (!occluder || hit->distance < occluder->distance)))"}},
        Slip{"every-hit-counts",
             kMain,
             kRenderer,
             Reach::simple,
             {kShade,
              "int count = 0; for (const auto& o : scene.objects()) if "
              "(o->intersectionWith(shadowRay)) ++count; return count == 1 && occluder;"},
             {"++count;", "{ ++count; break; }"}},
        Slip{"first-of-all",
             kMain,
             kRenderer,
             Reach::wide,
             {"scene.findClosestIntersection(shadowRay)",
              "scene.objects().front()->intersectionWith(shadowRay)"},
             {"scene.objects().front()->intersectionWith(shadowRay)",
              "scene.findClosestIntersection(shadowRay)"}}));
INSTANTIATE_TEST_SUITE_P(
    Numbers, EditsOfSlips,
    testing::Values(
        Slip{"precedence",
             kMain,
             "Sphere.cpp",
             Reach::simple,
             {"(-b - root) / (2.0 * a)", "-b - root / (2.0 * a)"},
             {"-b - root / (2.0 * a)", "(-b - root) / (2.0 * a)"}},
        Slip{"fixed-alpha",
             kMain,
             kRenderer,
             Reach::wide,
             {"object.phongAlpha()", "10"},
             {"R.dot(V)), 10)", "R.dot(V)), object.phongAlpha())"},
             "isShadowed,trace,"},
        Slip{"normal-not-unit",
             kMain,
             "Sphere.cpp",
             Reach::simple,
             {"getNormalAt(location)", "location - centre()"},
             {"location - centre()}", "(location - centre()).normalised()}"}},
        Slip{"beside-whole-numbers",
             kStarred,
             "BumpySphere.cpp",
             Reach::simple,
             {"const Vector3 normal = Sphere::getNormalAt(position);",
              "const Vector3 normal = Sphere::getNormalAt(position);\n"
              "const Vector3 axis = normal.y < 0.9 ? Vector3{0, -1, 0} : Vector3{1, 0, 0};"},
             {"normal.y < 0.9", "normal.y < 1.0"}},
        Slip{"radius-in-an-int",
             kMain,
             "Sphere.cpp",
             Reach::simple,
             {"const double a = D.dot(D);", "const int r = radius(); const double a = D.dot(D);"},
             {"int r", "double r"}},
        Slip{"cut-colour",
             kMain,
             kRenderer,
             Reach::simple,
             {"return colour;",
              "return {std::min(colour.r, 1.0), std::min(colour.g, 1.0), "
              "std::min(colour.b, 1.0)};"},
             {"return {std::min(colour.r, 1.0), std::min(colour.g, 1.0), std::min(colour.b, "
              "1.0)};",
              "return colour;"}}));

}  // namespace
}  // namespace ticker::repair

// Which edits are found, without asking or judging: one of them turns each of these mistakes back
// into the reference solution.
#include <grader/base/WholeFile.h>
#include <grader/build/Build.h>
#include <grader/corpus/Entry.h>
#include <grader/tests/repair/FoundEdits.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/RunCommand.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace ticker::repair {
namespace {

struct Case {
    const char* exercise;
    const char* name;
    Reach reach;
    const char* leftAlone = "";  ///< functions that hold no mistake
};

std::string nameOfCase(const testing::TestParamInfo<Case>& mistake) {
    std::string name = mistake.param.name;
    std::ranges::replace(name, '-', '_');
    return name;
}

corpus::Entry mistakeOf(const Case& wanted) {
    for (corpus::Entry& entry :
         corpus::readEntries(TICKER_SOURCE_DIR, {"mistakes"}, exerciseNamed(wanted.exercise)))
        if (entry.name == wanted.name) return entry;
    throw std::runtime_error(std::string{"no mistake "} + wanted.name);
}

class EditsOfMistakes : public testing::TestWithParam<Case> {};

TEST_P(EditsOfMistakes, HoldTheOneThatMendsIt) {
    corpus::Entry entry = mistakeOf(GetParam());
    const std::string file = entry.file();
    const std::string wrong = corpus::textsOf(entry).at(file);
    entry.edits = {{file, {}}};
    const std::string right = tests::tokens(corpus::textsOf(entry).at(file));

    const Case& mistake = GetParam();
    const Candidates candidates =
        tests::found(mistake.exercise, file, wrong, mistake.reach, mistake.leftAlone);
    EXPECT_TRUE(std::ranges::any_of(candidates.atoms, [&](const Atom& atom) {
        const auto edited = withEdits(wrong, atom.edits);
        return !atom.isApart && edited && tests::tokens(*edited) == right;
    }));
}

constexpr const char* kStarred = "tick1star";
constexpr const char* kMain = "tick1";

INSTANTIATE_TEST_SUITE_P(Jumps, EditsOfMistakes,
                         testing::Values(Case{kMain, "returns-early", Reach::simple},
                                         Case{kMain, "ambient-shaded", Reach::simple},
                                         Case{kMain, "loop-ends", Reach::simple}),
                         nameOfCase);
INSTANTIATE_TEST_SUITE_P(Roots, EditsOfMistakes,
                         testing::Values(Case{kMain, "far-root", Reach::wide},
                                         Case{kMain, "inside-no-hit", Reach::wide},
                                         Case{kMain, "behind-absolute", Reach::wide},
                                         Case{kMain, "root-not-taken", Reach::wide},
                                         Case{kMain, "radius-not-squared", Reach::wide}),
                         nameOfCase);
INSTANTIATE_TEST_SUITE_P(CallsOfOneArgument, EditsOfMistakes,
                         testing::Values(Case{kMain, "location-is-point", Reach::wide},
                                         Case{kMain, "no-falloff", Reach::wide},
                                         Case{kMain, "intensity-alone", Reach::wide},
                                         Case{kMain, "normal-of-ray", Reach::wide}),
                         nameOfCase);
INSTANTIATE_TEST_SUITE_P(
    Steps, EditsOfMistakes,
    testing::Values(Case{kMain, "starts-at-origin", Reach::wide, "illuminate,isShadowed,"},
                    Case{kMain, "one-bounce-only", Reach::wide, "illuminate,isShadowed,"}),
    nameOfCase);
INSTANTIATE_TEST_SUITE_P(Angles, EditsOfMistakes,
                         testing::Values(Case{kStarred, "atan-without-quadrant", Reach::simple},
                                         Case{kStarred, "rows-by-height", Reach::wide}),
                         nameOfCase);
INSTANTIATE_TEST_SUITE_P(Terms, EditsOfMistakes,
                         testing::Values(Case{kMain, "nearest-point", Reach::wide},
                                         Case{kMain, "radius-left-out", Reach::wide},
                                         Case{kMain, "along-normal", Reach::wide}),
                         nameOfCase);
INSTANTIATE_TEST_SUITE_P(
    Blends, EditsOfMistakes,
    testing::Values(Case{kMain, "direct-lost", Reach::wide, "illuminate,isShadowed,"},
                    Case{kMain, "direct-whole", Reach::wide, "illuminate,isShadowed,"},
                    Case{kMain, "seen-from-camera", Reach::wide, "illuminate,isShadowed,"}),
    nameOfCase);

/// How many edits of the reference's T1 with another end give a text that holds these words.
std::size_t editsThatGive(const std::string& end, const std::string& words,
                          Reach reach = Reach::simple) {
    std::string text = tests::readFile("reference_solution/exercise/BumpySphere.cpp");
    const std::string last = "    return (normal + Bu";
    text.replace(text.find(last), text.find(";\n", text.find(last)) + 1 - text.find(last), end);
    const Candidates candidates = tests::found(kStarred, "BumpySphere.cpp", text, reach, "");
    return static_cast<std::size_t>(std::ranges::count_if(candidates.atoms, [&](const Atom& atom) {
        return withEdits(text, atom.edits).value_or("").find(words) != std::string::npos;
    }));
}

TEST(SimpleEdits, LeaveAStatementOutWhereALessOneWouldAssignAVariableToItself) {
    const std::string turned =
        "Vector3 bumped = normal + Bu * Pu;\n"
        "    if (bumped.dot(position) > 0.0) bumped = -bumped;\n    return bumped;";
    EXPECT_EQ(editsThatGive(turned, "bumped = bumped"), 0U);
    EXPECT_GT(editsThatGive(turned, "Bu * Pu;\n    \n    return"), 0U);
}

TEST(SimpleEdits, KeepTheFractionsOfBothSlopesTogether) {
    const std::string cut =
        "const int slopeU = Bu;\n    const int slopeV = Bv;\n"
        "    return normal + slopeU * Pu + slopeV * Pv;";
    EXPECT_GT(editsThatGive(cut, "const double slopeU = Bu;\n    const double slopeV = Bv;"), 0U);
}

TEST(SimpleEdits, KeepBothSidesOfOneOfBothTogether) {
    EXPECT_GT(editsThatGive("if (u < 0.0 || v < 0.0) return normal;\n    return Pu;",
                            "if ((u < 0.0) != (v < 0.0)) return"),
              0U);
}

TEST(SimpleEdits, CompareNoConstantWithAConstant) {
    const std::string limited =
        "constexpr double kLow = 0.0;\n    const double kHigh = 9.0;\n"
        "    if (v > kHigh) return normal * kLow;\n    return Pu;";
    EXPECT_EQ(editsThatGive(limited, "kLow > kHigh"), 0U);
    EXPECT_GT(editsThatGive(limited, "u > kHigh"), 0U);
}

TEST(SimpleEdits, ReplaceBothFactorsOfASquareTogether) {
    EXPECT_GT(editsThatGive("return Pu * (u * u);", "Pu * (v * v)"), 0U);
}

TEST(WideEdits, PutInAnotherDivisorAnotherPointAndTheWholeTurn) {
    EXPECT_GT(editsThatGive("return Pu / v;", "Pu / normal.z", Reach::wide), 0U);
    EXPECT_GT(editsThatGive("return Pu.normalised().normalised();", "return Pv;", Reach::wide), 0U);
    EXPECT_GT(editsThatGive("const double w = std::abs(longitude) / (2.0 * std::numbers::pi);\n"
                            "    return Pu * w;",
                            "w = longitude / (2.0 * std::numbers::pi) + 0.5;", Reach::wide),
              0U);
}

// As it is where Clang's own headers are not installed.
TEST(PrecompiledHeader, IsNotMadeOfHeadersThatCannotBeFound) {
    const tests::TemporaryFolder folder;
    folder.write("Framework.h", "#include <nowhere.h>\n");
    const tests::CommandResult made =
        tests::runCommand("cd '" + folder.path().string() +
                          "' && " TICKER_BINARY_DIR
                          "/bin/ticker-candidates --precompile Framework.h made -xc++-header");
    EXPECT_EQ(made.status, 1);
    EXPECT_NE(made.output.find("'nowhere.h' file not found"), std::string::npos) << made.output;
}

// Each whole number in braces is a narrowing, and the compiler may print only so much.
TEST(WideEdits, AreCompiledWhereThousandsOfThemNarrowNumbers) {
    const build::Kit kit = build::Kit::besideProgram();
    const std::string reference = readWhole(std::filesystem::path{TICKER_SOURCE_DIR} /
                                            "reference_solution/exercise/Renderer.cpp");
    const std::string source = corpus::applyEdits(
        reference,
        {{"const Vector3 lensPoint{randomBetween(-settings().dofAmount, settings().dofAmount),\n"
          "                                    randomBetween(-settings().dofAmount, "
          "settings().dofAmount),\n                                    0.0};",
          "const double x = settings().dofAmount * randomBetween(-1.0, 1.0);\n"
          "const double y = settings().dofAmount * randomBetween(-1.0, 1.0);\n"
          "const Vector3 lensPoint = pinholeRay.origin + Vector3{x, y, 0.0};"}},
        "test");
    const Candidates found =
        tests::found("tick1star", "Renderer.cpp", source, Reach::wide, "illuminate");
    const build::BuildResult built =
        build::buildProgram(kit, sandbox::Sandbox::best(), sandbox::defaultPolicy().compile,
                            "Renderer.cpp", found.program, build::Purpose::switched);
    EXPECT_TRUE(built.program) << built.diagnostics.substr(0, 300);
}

// A campaign goes through the exercises, whose headers differ.
TEST(PrecompiledHeader, IsMadeForEachKitThatWasMoved) {
    const tests::TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms{0755});
    for (const auto& [exercise, file] :
         {std::pair{kStarred, "BumpySphere.cpp"}, std::pair{kMain, "Sphere.cpp"}}) {
        const auto moved = folder.path() / exercise;
        std::filesystem::copy(build::Kit::besideProgram(exerciseNamed(exercise)).folder(), moved,
                              std::filesystem::copy_options::recursive);
        const build::Kit kit = build::Kit::at(moved);
        const auto candidates =
            findCandidates(kit, sandbox::Sandbox::best(), sandbox::defaultPolicy().compile, file,
                           kit.templateSource(file), {});
        EXPECT_FALSE(candidates.program.empty()) << exercise;
    }
}

// A kit that was moved needs headers that are precompiled anew, which the next job reads.
TEST(PrecompiledHeader, CanBeReadByEveryJobWhateverTheUmaskOfRootIs) {
    if (geteuid() != 0) GTEST_SKIP() << "only the jobs of root have another uid";
    const tests::TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms{0755});
    std::filesystem::copy(build::Kit::besideProgram().folder(), folder.path() / "kit",
                          std::filesystem::copy_options::recursive);
    const build::Kit kit = build::Kit::at(folder.path() / "kit");
    const mode_t before = umask(0077);
    const auto candidates =
        findCandidates(kit, sandbox::Sandbox::best(), sandbox::defaultPolicy().compile,
                       "BumpySphere.cpp", kit.templateSource("BumpySphere.cpp"), {});
    umask(before);
    EXPECT_FALSE(candidates.program.empty());
}

}  // namespace
}  // namespace ticker::repair

#include <grader/pipeline/RenderSubmission.h>
#include <grader/tests/pipeline/TestGrader.h>
#include <grader/tests/support/Files.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace ticker::pipeline {
namespace {

// No disk has that much room for what a job may write.
constexpr std::uint64_t kMoreThanAnyDisk = std::uint64_t{1} << 50U;

using Said = std::pair<raytracer::ExitCode, std::string>;

/// The exit status and the words of rendering a BumpySphere.cpp.
Said sayingOf(const std::string& source, const Grader& grader) {
    intake::Submission work;
    work.name = "somebody";
    work.parts["BumpySphere.cpp"] = source;
    raytracer::RenderSettings settings;
    settings.width = 16;
    settings.height = 12;
    try {
        static_cast<void>(renderSubmission(work, grader, grader.scenes.at(0).scene, settings));
    } catch (const raytracer::Error& error) {
        return {error.exitCode(), error.what()};
    }
    return {raytracer::ExitCode::success, ""};
}

/// A grader at one of the levels that look for room on the disk.
std::optional<Grader> graderOnADisk() {
    for (const sandbox::Level level : {sandbox::Level::ownUser, sandbox::Level::sameUser}) {
        try {
            Grader grader = tests::testGraderWithScenes();
            grader.sandbox = sandbox::Sandbox::at(level);
            return grader;
        } catch (const raytracer::Error&) {
            continue;  // not on this machine
        }
    }
    return std::nullopt;
}

std::string reference() {
    return tests::readFile("reference_solution/exercise/BumpySphere.cpp");
}

TEST(RenderSubmission, ThatCannotBeCompiledForOurReasonsIsNoBadInput) {
    std::optional<Grader> grader = graderOnADisk();
    if (!grader) GTEST_SKIP() << "neither level B nor level C here";
    grader->policy.compile.fileSizeBytes = kMoreThanAnyDisk;
    const auto [code, words] = sayingOf(reference(), *grader);
    EXPECT_EQ(code, raytracer::ExitCode::notGradable) << words;
    EXPECT_NE(words.find("MB free"), std::string::npos) << words;
}

TEST(RenderSubmission, ThatDoesNotCompileIsBadInput) {
    const auto [code, words] = sayingOf("int x = ;", tests::testGraderWithScenes());
    EXPECT_EQ(code, raytracer::ExitCode::badInput);
    EXPECT_EQ(words, "BumpySphere.cpp: does not compile; ticker check shows why");
}

TEST(RenderSubmission, ThatReplacesTheFrameworkIsToldSo) {
    const auto [code, words] =
        sayingOf(reference() + "\nint main() { return 0; }\n", tests::testGraderWithScenes());
    EXPECT_EQ(code, raytracer::ExitCode::badInput);
    EXPECT_NE(words.find("belongs to the framework"), std::string::npos) << words;
}

}  // namespace
}  // namespace ticker::pipeline

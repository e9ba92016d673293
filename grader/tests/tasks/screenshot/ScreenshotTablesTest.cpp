#include <grader/build/Kit.h>
#include <grader/lab/selftest/ScreenshotTables.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace ticker::selftest {
namespace {

// A tenth of `./tick selftest --screenshots`. An honest picture fails with a chance below 3e-7.
TEST(ScreenshotTables, FindNothingInHonestPicturesAndNameTheOthers) {
    const std::filesystem::path root{TICKER_SOURCE_DIR};
    const std::vector<pipeline::SpecScene> scenes =
        pipeline::readSpecScenes(root / "scenes", root / "assets");
    const build::Kit kit = build::Kit::besideProgram();
    const sandbox::Sandbox sandbox = sandbox::Sandbox::best();
    ScreenshotRun run;
    run.fraction = 0.1;
    const RightSource reference{"reference", "BumpySphere.cpp",
                                tests::readFile("reference_solution/exercise/BumpySphere.cpp")};
    const ScreenshotSelfTest result = runScreenshotTables({scenes, kit, sandbox, {reference}}, run);
    EXPECT_TRUE(result.passed()) << result.table();
    int judged = 0;
    for (const ScreenshotRow& row : result.honest)
        judged += row.judged;
    EXPECT_GE(judged, 25);
}

}  // namespace
}  // namespace ticker::selftest

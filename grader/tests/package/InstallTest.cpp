#include <grader/tests/support/TemporaryFolder.h>

#include "CleanRoot.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace ticker {
namespace {

namespace fs = std::filesystem;

TEST(Install, TheInstalledTickerGradesWhereNoCheckoutIs) {
    const tests::TemporaryFolder folder;
    const fs::path prefix = folder.path() / "prefix";
    const fs::path work = folder.path() / "work";
    fs::create_directory(work);
    const tests::RootRun installed = tests::runHere(
        CMAKE_PROGRAM " --install " TICKER_BINARY_DIR " --prefix " + prefix.string());
    ASSERT_EQ(installed.status, 0) << installed.errors;
    fs::copy(TICKER_SOURCE_DIR "/grader/corpus/samples/notAwarded/bump-inverted-u", work / "ann");

    tests::CleanRoot root;
    root.bindReadOnly(prefix, "/opt/ticker").bind(work, "/desk").withSystemLibraries();
    const tests::RootRun graded =
        root.run("/opt/ticker/bin/ticker grade /desk/ann -o /desk/out --seed 7");
    EXPECT_EQ(graded.status, 0) << graded.errors;
    const auto result = nlohmann::json::parse(tests::textOf(work / "out/ann/result.json"));
    EXPECT_EQ(result.at("verdict"), "notAwarded");
    EXPECT_EQ(result.at("tasks").at(0).at("findings").at(0).at("id"), "bump.inverted-u");
    EXPECT_NE(result.at("sandboxLevel"), "none");

    const tests::RootRun rendered = root.run(
        "/opt/ticker/bin/ticker render /opt/ticker/share/ticker/scenes/bump-mapping.xml "
        "-o /desk/a.png -r 32x24 --seed 1");
    EXPECT_EQ(rendered.status, 0) << rendered.errors;
    EXPECT_TRUE(fs::exists(work / "a.png"));

    const tests::RootRun calibrated = root.run("/opt/ticker/bin/ticker calibrate --check");
    EXPECT_EQ(calibrated.status, 2) << calibrated.errors;
    EXPECT_NE(calibrated.errors.find("is in ticker-lab: ./tick calibrate"), std::string::npos)
        << calibrated.errors;

    const tests::RootRun packed =
        root.run("/opt/ticker/bin/ticker package student -o /desk/new/kit.zip");
    EXPECT_EQ(packed.status, 0) << packed.errors;
    EXPECT_TRUE(fs::exists(work / "new/kit.zip"));
}

}  // namespace
}  // namespace ticker

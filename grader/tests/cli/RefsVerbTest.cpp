#include <grader/tests/support/TemporaryFolder.h>

#include "RunningTicker.h"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

// The list of scenes is a pipe: ticker reads it after it has begun to watch for Ctrl-C, and goes on
// once the test closes it.
TEST(RefsVerb, AnInterruptedCheckHasNotPassed) {
    const tests::TemporaryFolder folder;
    const fs::path root{TICKER_SOURCE_DIR};
    fs::copy(root / "scenes/bump-mapping.xml", folder.path());
    const fs::path list = folder.path() / "references.json";
    ASSERT_EQ(mkfifo(list.c_str(), 0600), 0);
    RunningTicker ticker{{"refs", "--check", "--scenes", folder.path().string(), "--folder",
                          (root / "assets/references").string()},
                         (folder.path() / "errors").string()};
    {
        std::ofstream pipe{list};
        ticker.send(SIGINT);
        pipe << R"({"references": [
            {"scene": "bump-mapping", "pinhole": true, "width": 320, "height": 240}]})";
    }
    EXPECT_EQ(ticker.wait(), 130);
}

}  // namespace
}  // namespace ticker::cli

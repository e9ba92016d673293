#include "FakeKit.h"

#include <student_template/framework/app/view/Workshop.h>

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <string>
#include <thread>
#include <utility>

namespace raytracer::view {
namespace {

using Json = nlohmann::json;

Workshop::Listener noListener() {
    return {[] {}, [] {}, [] {}};
}

/// Waits until the commands of a script have begun that never end, and looks until the workshop,
/// which has no patience, has stopped them. @return What this entry of the board then says.
Json stoppedIn(const FakeKit& kit, const std::string& name, Workshop::Listener listener) {
    Board board;
    Workshop workshop{kit.home(), board, std::move(listener), std::chrono::milliseconds{0}};
    while (!std::filesystem::exists(kit.folder() / "begun"))
        std::this_thread::yield();
    const std::set<std::string> unfinished{"", "building", "built", "running"};
    Json entry = Json::object();
    while (unfinished.contains(entry.value("state", ""))) {
        workshop.look();
        entry = Json::parse(board.newsAfter(0)).value(name, Json::object());
        std::this_thread::yield();
    }
    return entry;
}

std::string endlessIn(const FakeKit& kit) {
    return "touch '" + (kit.folder() / "begun").string() + "'; exec tail -f /dev/null";
}

TEST(WorkshopPatience, CallsABuildThatIsStoppedNoErrorOfTheCompiler) {
    FakeKit kit;
    kit.script("cmake", endlessIn(kit));
    int unchanged = 0;
    const Json build = stoppedIn(kit, "build", {[] {}, [] {}, [&] { ++unchanged; }});
    EXPECT_EQ(build["state"], "stopped");
    EXPECT_EQ(build["after"], "2 minutes");
    EXPECT_EQ(unchanged, 1);
}

TEST(WorkshopPatience, SaysThatTheBuildOfTheTestsIsStopped) {
    FakeKit kit;
    kit.script("cmake", "case $4 in tests) " + endlessIn(kit) + ";; esac");
    EXPECT_EQ(stoppedIn(kit, "tests", noListener())["state"], "stopped");
}

TEST(WorkshopPatience, SaysThatTestsWithoutAnEndAreStopped) {
    FakeKit kit;
    kit.script("tests", endlessIn(kit));
    const Json tests = stoppedIn(kit, "tests", noListener());
    EXPECT_EQ(tests["state"], "failed");
    const std::string words = " was stopped after 2 minutes: look for a loop without end";
    EXPECT_EQ(tests["title"], "T1" + words);
    EXPECT_EQ(tests["summary"], "T1" + words + "\nT2.1" + words + "\n");
}

}  // namespace
}  // namespace raytracer::view

#include "FakeKit.h"

#include <student_template/framework/app/view/Lines.h>
#include <student_template/framework/app/view/View.h>
#include <student_template/framework/app/view/process/Process.h>

#include <gtest/gtest.h>
#include <httplib.h>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

namespace raytracer::view {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

std::string refusalOf(const std::vector<std::string>& arguments) {
    try {
        static_cast<void>(run(parseOptions(arguments)));
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

/// A viewer of a kit, in a process of its own.
class Viewer {
public:
    /// @param arguments  As a shell reads them.
    Viewer(const FakeKit& kit, const std::string& arguments)
        : process_{{"/bin/sh", "-c",
                    "echo $$; export " + std::string{kKitVariable} + "='" + kit.folder().string() +
                        "'; exec '" + thisProgram() + "' --view " + arguments},
                   Process::Errors::withItsOutput} {}

    [[nodiscard]] const std::string& address() const { return address_; }
    [[nodiscard]] std::string nextLine() { return lines_.next().value_or(""); }

    /// @return The status of the answer to the page's request, -1 without one.
    [[nodiscard]] int statusOfThePage() const {
        const httplib::Result result = get("");
        return result ? result->status : -1;
    }
    [[nodiscard]] std::string firstScene() const {
        const httplib::Result result = get("news?after=0");
        return result ? Json::parse(result->body)["started"].value("scene", "") : "";
    }
    /// @return Its exit status.
    [[nodiscard]] int end(int signal) {
        ::kill(number_, signal);
        return process_.wait();
    }

private:
    [[nodiscard]] httplib::Result get(const std::string& rest) const {
        const std::size_t path = address_.find('/', std::string{"http://"}.size());
        return httplib::Client{address_.substr(0, path)}.Get(address_.substr(path) + rest);
    }

    Process process_;
    LineReader lines_{[this](char* bytes, std::size_t size) { return process_.read(bytes, size); }};
    pid_t number_ = std::stoi(nextLine());
    std::string address_ = nextLine();
};

TEST(View, RefusesOptionsThatItWouldDrop) {
    const std::vector<std::vector<std::string>> others{
        {"-o", "a.png"},        {"--region", "0,0,4,4"}, {"--trace", "1,1"}, {"--normals"},
        {"--compare", "b.png"}, {"--linear", "a.pfm"},   {"--preview"}};
    for (std::vector<std::string> arguments : others) {
        const std::string name = arguments[0];
        arguments.insert(arguments.begin(), {"--view", "no-such-scene.xml"});
        EXPECT_EQ(refusalOf(arguments), name + ": --view has no use for it; leave one of them out");
    }
    // This one gets as far as reading the scene.
    const std::string missing = refusalOf({"--view", "no-such-scene.xml", "--threads", "2", "-q"});
    EXPECT_NE(missing.find("no-such-scene.xml"), std::string::npos) << missing;
}

TEST(View, AsksForASceneWhereThereIsNone) {
    EXPECT_EQ(refusalOf({"--view"}), "no scene found; name one: --view SCENE");
}

void writeScene(const FakeKit& kit, const std::string& name, const std::string& comment = "") {
    kit.write("scenes/" + name, "<!-- " + comment + " -->\n" + kBallOverFloor);
}

TEST(View, ServesThePageUntilItIsAskedToEnd) {
    const FakeKit kit;
    writeScene(kit, "room.xml");
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        Viewer viewer{kit, "-q"};
        EXPECT_EQ(viewer.statusOfThePage(), 200);
        EXPECT_EQ(viewer.end(signal), 0);
        EXPECT_EQ(viewer.statusOfThePage(), -1);
        EXPECT_EQ(viewer.nextLine(), "");
    }
}

TEST(View, TellsHowToGoOnWhereNoBrowserOpens) {
    const FakeKit kit;
    writeScene(kit, "room.xml");
    Viewer viewer{kit, ""};
    EXPECT_EQ(viewer.nextLine(),
              "Where no browser opens, open this address in yours; Ctrl-C ends the viewer.");
    EXPECT_EQ(viewer.end(SIGTERM), 0);
}

TEST(View, BeginsWithTheSceneOfTheOptionThatIsWorkedOn) {
    const FakeKit kit;
    writeScene(kit, "room.xml");
    writeScene(kit, "a-toy.xml");
    writeScene(kit, "bumps.xml", "screenshot.png, of a <bumpy-sphere/>");
    writeScene(kit, "soft.xml", "screenshot.png");
    const auto begins = [&](const char* bumpy, const char* renderer, int hoursBetween) {
        const fs::path first = kit.write("exercise/BumpySphere.cpp", bumpy);
        const fs::path second = kit.write("exercise/Renderer.cpp", renderer);
        fs::last_write_time(second, fs::last_write_time(first) + std::chrono::hours{hoursBetween});
        return Viewer{kit, "-q"}.firstScene();
    };
    constexpr const char* kUntouched = "unfinished(\"T\");";
    EXPECT_EQ(begins("int begun;", kUntouched, 1), "bumps.xml");
    EXPECT_EQ(begins(kUntouched, "int begun;", -1), "soft.xml");
    // Both, or none: the file that was saved last decides.
    EXPECT_EQ(begins("int begun;", "int begun;", -1), "bumps.xml");
    EXPECT_EQ(begins("int begun;", "int begun;", 1), "soft.xml");
    EXPECT_EQ(begins(kUntouched, kUntouched, 1), "soft.xml");
}

}  // namespace
}  // namespace raytracer::view

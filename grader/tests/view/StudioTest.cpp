#include "FakeKit.h"

#include <raytracer/base/Error.h>
#include <student_template/framework/app/view/Studio.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace raytracer::view {
namespace {

using Json = nlohmann::json;

Options optionsOf(const FakeKit& kit, const std::string& scene,
                  std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"--view", kit.write("scenes/" + scene, "<scene/>").string()});
    return parseOptions(more);
}

std::string askedOf(Studio& studio) {
    return studio.pixel("1", "2").payload;
}

TEST(Studio, HandsAssetsAndThreadsToTheWorker) {
    FakeKit kit;
    Studio studio{kit.home(), optionsOf(kit, "room.xml", {"--assets", "maps", "--threads", "3"})};
    EXPECT_NE(askedOf(studio).find("\t--assets\tmaps\t--threads\t3"), std::string::npos)
        << askedOf(studio);
}

TEST(Studio, KnowsTheSceneThatItWasStartedWithWhateverItsNameEndsIn) {
    FakeKit kit;
    Studio studio{kit.home(), optionsOf(kit, "Room.XML")};
    EXPECT_NO_THROW(studio.change({{"bounces", "1"}}));
    EXPECT_NE(askedOf(studio).find("Room.XML\t"), std::string::npos);
    const Json news = Json::parse(studio.board().newsAfter(0));
    EXPECT_EQ(news["scenes"], (std::vector<std::string>{"Room.XML", "room.xml"}));
}

TEST(Studio, HasNoLensWhereTheExerciseHasNone) {
    FakeKit kit;
    kit.home().hasLens = false;
    Studio studio{kit.home(), optionsOf(kit, "room.xml", {"--aperture", "0.3"})};
    EXPECT_NE(askedOf(studio).find("\t--aperture\t0\t"), std::string::npos);
    const Json news = Json::parse(studio.board().newsAfter(0));
    EXPECT_EQ(news["hasLens"], false);
    EXPECT_EQ(news["started"]["aperture"], "0");
}

TEST(Studio, TellsEveryPageTheSettingsOfTheStart) {
    FakeKit kit;
    Studio studio{kit.home(), optionsOf(kit, "room.xml", {"--bounces", "5"})};
    studio.change({{"bounces", "1"}});
    const Json news = Json::parse(studio.board().newsAfter(0));
    EXPECT_EQ(news["picture"]["settings"]["bounces"], "1");
    EXPECT_EQ(news["started"]["bounces"], "5");
}

std::string refusalBy(Studio& studio, const std::string& setting, const std::string& value) {
    try {
        studio.change({{"seed", "9"}, {setting, value}});
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(Studio, RefusesAChangeAsAWhole) {
    FakeKit kit;
    Studio studio{kit.home(), optionsOf(kit, "room.xml", {"--seed", "4"})};
    EXPECT_EQ(refusalBy(studio, "colour", "1"), "there is no setting colour");
    EXPECT_EQ(refusalBy(studio, "size", "20x20\t--threads"), "size: one value is expected");
    EXPECT_EQ(refusalBy(studio, "scene", "../room.xml"), "there is no scene \"../room.xml\"");
    EXPECT_NE(refusalBy(studio, "size", "0x20").find("--resolution"), std::string::npos);
    EXPECT_NE(askedOf(studio).find("\t--seed\t4\t"), std::string::npos);
    EXPECT_EQ(Json::parse(studio.board().newsAfter(0))["picture"]["number"], 1);
}

TEST(Studio, ShowsThePictureOfASolution) {
    FakeKit kit{rightSolution()};
    const Options options =
        optionsOf(kit, "room.xml", {"--resolution", "48x32", "--dof-rays", "1"});
    kit.write("scenes/room.xml", kBallOverFloor);
    Studio studio{kit.home(), options};
    Json last;
    const Json all = waitFor(studio.board(), [&](const Json& news) {
        if (!news["pieces"].empty()) last = news["pieces"].back();
        return last.is_object() && last["at"]["last"] == 1;
    });
    ASSERT_FALSE(all.is_null());
    EXPECT_EQ(last["at"]["width"], 48);
    EXPECT_EQ(last["at"]["height"], 32);
    EXPECT_EQ(last["at"]["stage"], "");
    EXPECT_EQ(last["rgb"].get<std::string>().size(), std::size_t{48} * 32 * 3 / 3 * 4);
    EXPECT_EQ(all["trouble"], "");
    EXPECT_TRUE(studio.pixel("1", "2").isGood);
    EXPECT_EQ(studio.pinhole().payload.size(), std::size_t{48} * 32 * 3);
}

/// A command that prints a part of picture 1 as a worker does: the number of its bytes, and these.
std::string printPart(const std::string& bytes) {
    return "printf 'part 1 %s\\n%s' " + std::to_string(bytes.size()) + " '" + bytes + "'\n";
}

TEST(Studio, LeavesOutAPartWithoutItsPlace) {
    const std::string place = "3 4 640 480 160 120 0 1.5 1 of 4 rays\n";
    FakeKit kit{"read -r line\n" + printPart("0 0 1 1\nrgb") + printPart("no place") +
                printPart("0 0 640 480 160 120 0 0 1 of 4 rays") + printPart(place + "rgb") +
                "exec tail -f /dev/null"};
    Studio studio{kit.home(), optionsOf(kit, "room.xml")};
    const Json all =
        waitFor(studio.board(), [](const Json& news) { return !news["pieces"].empty(); });
    ASSERT_EQ(all["pieces"].size(), 1U);
    EXPECT_EQ(all["pieces"][0]["rgb"], "cmdi");  // base64 of "rgb"
    EXPECT_EQ(all["pieces"][0]["at"],
              Json::parse(R"({"x": 3, "y": 4, "width": 640, "height": 480, "across": 160,
                  "down": 120, "last": 0, "left": 1.5, "stage": "1 of 4 rays"})"));
}

TEST(Studio, TellsOfASolutionThatCrashes) {
    FakeKit kit{"read -r line; kill -SEGV $$"};
    Studio studio{kit.home(), optionsOf(kit, "room.xml")};
    const Json all = waitFor(studio.board(), [](const Json& news) {
        return news.value("trouble", "").find("Your code crashed (signal 11).") == 0;
    });
    EXPECT_FALSE(all.is_null());
}

TEST(Studio, RendersAgainWithANewProgram) {
    FakeKit kit;
    kit.script("cmake", "touch -d 2001-01-01 '" + kit.home().program.string() + "'");
    Studio studio{kit.home(), optionsOf(kit, "room.xml")};
    const Json all =
        waitFor(studio.board(), [](const Json& news) { return news["picture"]["build"] == 1; });
    ASSERT_FALSE(all.is_null());
    EXPECT_EQ(all["picture"]["number"], 2);
}

/// From now on the kit's compiler refuses every file, with the text of Renderer.cpp as its error.
void refuseAllFiles(const FakeKit& kit) {
    kit.script("cmake", "cat '" + (kit.home().exercise / "Renderer.cpp").string() + "'; exit 1");
}

/// Saves a file and waits until the compiler has refused it.
void saveAndSeeRefused(const FakeKit& kit, Studio& studio, const std::string& text) {
    kit.write("exercise/Renderer.cpp", text);
    EXPECT_FALSE(waitFor(studio.board(), [&](const Json& news) {
                     return news.contains("build") && news["build"].value("all", "") == text;
                 }).is_null());
}

TEST(Studio, GoesOnWithAPictureThatASaveInterrupted) {
    FakeKit kit{"exec tail -f /dev/null"};
    refuseAllFiles(kit);
    Studio studio{kit.home(), optionsOf(kit, "room.xml")};
    saveAndSeeRefused(kit, studio, "first");
    saveAndSeeRefused(kit, studio, "and then");
    EXPECT_FALSE(waitFor(studio.board(), [](const Json& news) {
                     return news["picture"]["number"] > 1;
                 }).is_null());
}

TEST(Studio, RendersNoWholePictureAgainAfterASaveThatDoesNotCompile) {
    FakeKit kit{"read -r line\n" + printPart("0 0 1 1 1 1 1 0 \nrgb") + "exec tail -f /dev/null"};
    refuseAllFiles(kit);
    Studio studio{kit.home(), optionsOf(kit, "room.xml")};
    EXPECT_FALSE(waitFor(studio.board(), [](const Json& news) {
                     return !news["pieces"].empty();
                 }).is_null());
    saveAndSeeRefused(kit, studio, "first");
    saveAndSeeRefused(kit, studio, "and then");
    saveAndSeeRefused(kit, studio, "and again");  // the one before is all over
    EXPECT_EQ(Json::parse(studio.board().newsAfter(0))["picture"]["number"], 1);
}

}  // namespace
}  // namespace raytracer::view

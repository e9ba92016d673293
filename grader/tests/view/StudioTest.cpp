#include "FakeKit.h"

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

TEST(Studio, TellsEveryPageTheSettingsOfTheStart) {
    FakeKit kit;
    Studio studio{kit.home(), optionsOf(kit, "room.xml", {"--bounces", "5"})};
    studio.change({{"bounces", "1"}});
    const Json news = Json::parse(studio.board().newsAfter(0));
    EXPECT_EQ(news["picture"]["settings"]["bounces"], "1");
    EXPECT_EQ(news["started"]["bounces"], "5");
}

}  // namespace
}  // namespace raytracer::view

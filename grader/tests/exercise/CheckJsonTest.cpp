#include <grader/package/CheckJson.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace ticker::package {
namespace {

using nlohmann::json;

std::string checkJsonOf(const Exercise& exercise) {
    return tests::readFile((exercise.overlay.empty() ? "student_template" : exercise.overlay) +
                           "/check.json");
}

TEST(CheckJson, IsLeftAsItIsWhereItHasEveryTask) {
    const Exercise& exercise = defaultExercise();
    json options = json::array();
    for (const OptionEntry& option : exercise.options)
        options.push_back({{"tasks", option.tasks}});
    const std::string text = json{{"options", options}}.dump();
    EXPECT_EQ(withEveryTask(text, exercise), text);
}

TEST(CheckJson, GetsAnOptionOfWhichItHasNoTask) {
    Exercise exercise = defaultExercise();
    exercise.tasks.push_back({"T9", "Fog", "Toy.cpp", "transmittance", {}});
    exercise.options.push_back({"fog", {"T9"}});
    const std::string before = checkJsonOf(exercise);
    const json made = json::parse(withEveryTask(before, exercise));
    EXPECT_EQ(made.at("options").back(),
              (json{{"name", "fog"}, {"file", "exercise/Toy.cpp"}, {"tasks", {"T9"}}}));
    EXPECT_EQ(made.at("tasks"), json::parse(before).at("tasks"));
}

TEST(CheckJson, GetsATaskOfAnOptionThatItHas) {
    Exercise exercise = defaultExercise();
    OptionEntry& option = exercise.options.back();
    exercise.tasks.push_back({"T9", "Fog", "Toy.cpp", "transmittance", {}});
    option.tasks.emplace_back("T9");
    const json made = json::parse(withEveryTask(checkJsonOf(exercise), exercise));
    EXPECT_EQ(made.at("options").size(), exercise.options.size());
    EXPECT_EQ(made.at("options").back().at("tasks"), json(option.tasks));
}

}  // namespace
}  // namespace ticker::package

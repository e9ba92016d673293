#include <grader/base/JsonValue.h>
#include <grader/base/WholeFile.h>
#include <grader/exercise/Exercise.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ticker {
namespace {

std::string textOf(const JsonValue& value) {
    std::string text = value.text();
    if (text.empty()) value.expect("a string that is not empty");
    return text;
}

int sizeOf(const JsonValue& value) {
    const double number = value.number();
    if (number < 1.0 || number > 1e4 || std::floor(number) != number)
        value.expect("a whole number from 1 to 10000");
    return static_cast<int>(number);
}

template <class Read>
auto listOf(const JsonValue& value, const Read& read) {
    if (!value.isArray()) value.expect("an array");
    std::vector<decltype(read(value))> items;
    for (const JsonValue& item : value.items())
        items.push_back(read(item));
    return items;
}

Formula readFormula(const JsonValue& value) {
    value.allowOnly({"type", "of", "text"});
    Formula formula{textOf(value.at("type")), "", textOf(value.at("text"))};
    if (value.has("of")) formula.of = textOf(value.at("of"));
    return formula;
}

TaskEntry readTask(const JsonValue& value) {
    value.allowOnly({"id", "title", "file", "function", "symbols", "formulas"});
    TaskEntry task{
        textOf(value.at("id")),       textOf(value.at("title")),           textOf(value.at("file")),
        textOf(value.at("function")), listOf(value.at("symbols"), textOf), {}};
    if (value.has("formulas")) task.formulas = listOf(value.at("formulas"), readFormula);
    return task;
}

OptionEntry readOption(const JsonValue& value, const Exercise& exercise) {
    value.allowOnly({"name", "tasks"});
    return {textOf(value.at("name")), listOf(value.at("tasks"), [&](const JsonValue& task) {
                if (exercise.task(task.text()) == nullptr) task.expect("the id of a task");
                return task.text();
            })};
}

SceneEntry readSceneEntry(const JsonValue& value, const Exercise& exercise) {
    value.allowOnly({"name", "file", "width", "height", "isRandom", "isHandedIn"});
    SceneEntry scene{textOf(value.at("name")),    textOf(value.at("file")),
                     sizeOf(value.at("width")),   sizeOf(value.at("height")),
                     value.at("isRandom").flag(), value.at("isHandedIn").flag()};
    if (std::ranges::find(exercise.tasks, scene.file, &TaskEntry::file) == exercise.tasks.end())
        value.at("file").expect("the file of a task");
    return scene;
}

void expectUniqueIds(const JsonValue& tasks, const Exercise& exercise) {
    if (exercise.tasks.empty()) tasks.expect("at least one task");
    std::set<std::string_view> taken{kScreenshotTask};
    for (const TaskEntry& task : exercise.tasks)
        if (!taken.insert(task.id).second)
            tasks.refuse(fmt::format("more than one task has the id \"{}\"", task.id));
}

}  // namespace

Exercise parseExercise(const std::string& file, const std::string& text) {
    const JsonValue top = JsonValue::parse(text, file);
    top.allowOnly({"name", "title", "handout", "template", "reference", "rubric", "corpus", "tasks",
                   "options", "scenes", "frameworkFiles", "overlay", "leftOut", "companions"});
    Exercise exercise;
    exercise.name = textOf(top.at("name"));
    exercise.title = textOf(top.at("title"));
    exercise.handout = textOf(top.at("handout"));
    exercise.stubs = textOf(top.at("template"));
    exercise.reference = textOf(top.at("reference"));
    exercise.rubric = textOf(top.at("rubric"));
    exercise.corpus = textOf(top.at("corpus"));
    exercise.tasks = listOf(top.at("tasks"), readTask);
    expectUniqueIds(top.at("tasks"), exercise);
    exercise.options = listOf(
        top.at("options"), [&](const JsonValue& option) { return readOption(option, exercise); });
    exercise.scenes = listOf(
        top.at("scenes"), [&](const JsonValue& scene) { return readSceneEntry(scene, exercise); });
    exercise.frameworkFiles = listOf(top.at("frameworkFiles"), textOf);
    if (top.has("overlay")) exercise.overlay = textOf(top.at("overlay"));
    if (top.has("leftOut")) exercise.leftOut = textOf(top.at("leftOut"));
    return exercise;
}

Exercise readExercise(const std::filesystem::path& file) {
    return parseExercise(file.string(), readWhole(file, "cannot be read; expected an exercise"));
}

}  // namespace ticker

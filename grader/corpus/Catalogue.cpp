#include <grader/corpus/Catalogue.h>

#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace ticker::mistakes {
namespace {

using nlohmann::json;
using raytracer::InputError;

constexpr std::array<std::pair<std::string_view, TaskState>, 5> kStates{{
    {"passed", TaskState::passed},
    {"failed", TaskState::failed},
    {"notAttempted", TaskState::notAttempted},
    {"blocked", TaskState::blocked},
    {"notGraded", TaskState::notGraded},
}};

/// Reads the members of one object and refuses those that nobody asked for.
class Members {
public:
    Members(const json& object, std::string path, std::string where)
        : object_(object), path_(std::move(path)), where_(std::move(where)) {
        if (!object_.is_object()) fail("must be an object");
    }

    [[nodiscard]] const json& required(const std::string& name) {
        known_.insert(name);
        if (!object_.contains(name)) fail(fmt::format("needs \"{}\"", name));
        return object_.at(name);
    }

    [[nodiscard]] std::string string(const std::string& name) {
        const json& value = required(name);
        if (!value.is_string()) fail(fmt::format("\"{}\" must be a string", name));
        return value.get<std::string>();
    }

    /// False where it is not there.
    [[nodiscard]] bool flag(const std::string& name) {
        if (!object_.contains(name)) return false;
        const json& value = required(name);
        if (!value.is_boolean()) fail(fmt::format("\"{}\" must be true or false", name));
        return value.get<bool>();
    }

    /// A string, or an array of lines.
    [[nodiscard]] std::string text(const std::string& name) {
        const json& value = required(name);
        if (value.is_string()) return value.get<std::string>();
        const bool lines = value.is_array() && !value.empty() &&
                           std::all_of(value.begin(), value.end(),
                                       [](const json& line) { return line.is_string(); });
        if (!lines) fail(fmt::format("\"{}\" must be a string or an array of lines", name));
        return fmt::format("{}", fmt::join(value.get<std::vector<std::string>>(), "\n"));
    }

    void finish() const {
        for (const auto& [name, value] : object_.items())
            if (known_.count(name) == 0) fail(fmt::format("does not know \"{}\"", name));
    }

    [[noreturn]] void fail(const std::string& message) const {
        throw InputError(path_, 0, where_ + " " + message);
    }

private:
    const json& object_;
    std::string path_;
    std::string where_;
    std::set<std::string> known_;
};

json parse(const std::string& text, const std::string& path) {
    try {
        return json::parse(text);
    } catch (const json::parse_error& error) {
        const auto end =
            text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        const auto line = 1 + std::count(text.begin(), end, '\n');
        throw InputError(path, static_cast<int>(line), "is not JSON");
    }
}

Expectation readExpectation(const json& object, const std::string& path) {
    Members members(object, path, "\"expect\"");
    const std::string state = members.string("state");
    const std::string finding = members.string("finding");
    const bool needsReview = members.flag("needsReview");
    members.finish();
    const auto* known = std::find_if(kStates.begin(), kStates.end(),
                                     [&](const auto& entry) { return entry.first == state; });
    if (known == kStates.end()) members.fail(fmt::format("has the unknown state \"{}\"", state));
    return {known->second, finding, needsReview};
}

std::vector<Edit> readEdits(const json& array, const std::string& path) {
    if (!array.is_array() || array.empty())
        throw InputError(path, 0, "\"edits\" must be an array with at least one edit");
    std::vector<Edit> edits;
    for (const json& object : array) {
        Members members(object, path, fmt::format("\"edits\"[{}]", edits.size()));
        Edit edit{members.text("find"), members.text("replace")};
        members.finish();
        if (edit.find.empty()) members.fail("has nothing to find");
        edits.push_back(std::move(edit));
    }
    return edits;
}

Mistake readMistake(const std::filesystem::path& file) {
    const std::string path = file.string();
    const json document = parse(readWhole(file, "cannot be opened"), path);
    Members members(document, path, "the mistake");
    Mistake mistake;
    mistake.path = path;
    mistake.id = members.string("id");
    mistake.task = members.string("task");
    mistake.file = members.string("file");
    mistake.title = members.string("title");
    mistake.edits = readEdits(members.required("edits"), path);
    mistake.expect = readExpectation(members.required("expect"), path);
    members.finish();
    if (mistake.id != file.stem().string()) members.fail("must have its file's name as \"id\"");
    if (mistake.task != file.parent_path().filename().string())
        members.fail("must have its folder's name as \"task\"");
    return mistake;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

}  // namespace

std::vector<Mistake> readCatalogue(const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder))
        throw InputError(folder.string(), 0, "is no folder with a catalogue of mistakes");
    std::vector<Mistake> mistakes;
    for (const char* kind : {"accepted", "mistakes"}) {
        if (!std::filesystem::is_directory(folder / kind)) continue;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / kind))
            if (entry.is_regular_file() && entry.path().extension() == ".json")
                mistakes.push_back(readMistake(entry.path()));
    }
    std::sort(mistakes.begin(), mistakes.end(), [](const Mistake& a, const Mistake& b) {
        return std::pair(a.task, a.id) < std::pair(b.task, b.id);
    });
    return mistakes;
}

std::string makeMistake(const Mistake& mistake, const std::string& reference) {
    std::string text = reference;
    for (std::size_t i = 0; i < mistake.edits.size(); ++i) {
        const Edit& edit = mistake.edits[i];
        const std::size_t found = count(text, edit.find);
        if (found != 1)
            throw InputError(mistake.path, 0,
                             fmt::format("\"edits\"[{}]: its \"find\" must stand once in {} but "
                                         "stands there {} times: {}",
                                         i, mistake.file, found, edit.find));
        text.replace(text.find(edit.find), edit.find.size(), edit.replace);
    }
    return text;
}

}  // namespace ticker::mistakes

#include <grader/base/WholeFile.h>
#include <grader/corpus/Entry.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>

#include <algorithm>

namespace ticker::corpus {
namespace {

namespace fs = std::filesystem;

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

}  // namespace

bool Expectation::allows(std::string_view state) const {
    return std::find(states.begin(), states.end(), state) != states.end();
}

std::string Expectation::finding() const {
    return findings && !findings->empty() ? findings->front() : "";
}

bool Expectation::names(std::string_view finding) const {
    return findings && std::find(findings->begin(), findings->end(), finding) != findings->end();
}

bool Expectation::isMet(std::string_view state, std::string_view firstFinding) const {
    const bool isNamed =
        !findings || (findings->empty() ? firstFinding.empty() : names(firstFinding));
    return allows(state) && isNamed;
}

const std::string& Entry::task() const {
    const auto own = tasks.find(group);
    return own == tasks.end() ? tasks.begin()->first : own->first;
}

std::string Entry::file() const {
    if (!edits.empty()) return edits.begin()->first;
    return files.empty() ? "" : files.front().filename().string();
}

std::string applyEdits(std::string text, const std::vector<Edit>& edits, const std::string& path) {
    for (std::size_t i = 0; i < edits.size(); ++i) {
        const Edit& edit = edits[i];
        const std::size_t found = count(text, edit.find);
        if (found != 1)
            throw raytracer::InputError(
                path, 0,
                fmt::format("\"edits\"[{}]: its \"find\" must stand once in the text but stands "
                            "there {} times: {}",
                            i, found, edit.find));
        text.replace(text.find(edit.find), edit.find.size(), edit.replace);
    }
    return text;
}

std::map<std::string, std::string> textsOf(const Entry& entry) {
    std::map<std::string, std::string> texts;
    for (const fs::path& file : entry.files)
        texts[file.filename().string()] = readWhole(file);
    for (const auto& [name, edits] : entry.edits)
        texts[name] = applyEdits(readWhole(entry.base / name), edits, entry.path);
    return texts;
}

}  // namespace ticker::corpus

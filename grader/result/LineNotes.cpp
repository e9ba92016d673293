#include <grader/result/Decision.h>

#include <nlohmann/json.hpp>

namespace ticker {
namespace {

std::string textIn(const nlohmann::ordered_json& note, const char* key) {
    const auto found = note.find(key);
    return found != note.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

std::string notesText(const std::vector<LineNote>& notes) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const LineNote& note : notes)
        all.push_back(
            {{"code", note.code}, {"file", note.file}, {"line", note.line}, {"text", note.text}});
    return all.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::vector<LineNote> readNotes(std::string_view text) {
    const nlohmann::ordered_json all = nlohmann::ordered_json::parse(text, nullptr, false);
    std::vector<LineNote> notes;
    if (!all.is_array()) return notes;
    for (const nlohmann::ordered_json& one : all) {
        if (!one.is_object() || !one.contains("line") || !one["line"].is_number_integer()) continue;
        LineNote note{textIn(one, "file"), one["line"].get<int>(), textIn(one, "code"),
                      textIn(one, "text")};
        if (!note.file.empty() && note.line > 0 && !note.text.empty())
            notes.push_back(std::move(note));
    }
    return notes;
}

}  // namespace ticker

#include <grader/base/Trimmed.h>
#include <grader/result/ProvenLine.h>

#include <nlohmann/json.hpp>

#include <set>

namespace ticker {

std::vector<ProvenLine> provenLines(const SubmissionResult& result) {
    std::vector<ProvenLine> lines;
    std::set<std::string> done;
    for (const Repair& repair : result.repairs.value_or(std::vector<Repair>{})) {
        if (!repair.proven || !repair.next.empty() || !done.insert(repair.task).second) continue;
        for (const RepairEdit& edit : repair.edits)
            lines.push_back({repair.task, repair.file, edit.line, std::string{trimmed(edit.from)},
                             std::string{trimmed(edit.to)}});
    }
    return lines;
}

std::string provenText(const std::vector<ProvenLine>& lines) {
    if (lines.empty()) return {};
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const ProvenLine& one : lines)
        list.push_back({{"file", one.file},
                        {"from", one.from},
                        {"line", one.line},
                        {"task", one.task},
                        {"to", one.to}});
    return list.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::vector<ProvenLine> readProven(std::string_view text) {
    const nlohmann::ordered_json list = nlohmann::ordered_json::parse(text, nullptr, false);
    std::vector<ProvenLine> lines;
    if (!list.is_array()) return lines;
    for (const nlohmann::ordered_json& one : list) {
        if (!one.is_object()) continue;
        const auto textIn = [&](const char* name) {
            return one.contains(name) && one[name].is_string() ? one[name].get<std::string>() : "";
        };
        const bool hasLine = one.contains("line") && one["line"].is_number_integer();
        lines.push_back({textIn("task"), textIn("file"), hasLine ? one["line"].get<int>() : 0,
                         textIn("from"), textIn("to")});
    }
    return lines;
}

}  // namespace ticker

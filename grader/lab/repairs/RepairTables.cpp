#include <grader/lab/repairs/RepairTables.h>

#include <grader/base/JsonValue.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ticker::lab {
namespace {

/// Figures of the rows that a line of the table stands for.
struct Sum {
    std::size_t tried = 0;
    std::size_t repaired = 0;
    std::size_t rightLine = 0;
    std::vector<double> cpuMs;

    void add(const RepairRow& row) {
        ++tried;
        repaired += row.isRepaired ? 1 : 0;
        rightLine += row.isRightLine ? 1 : 0;
        cpuMs.push_back(row.cpuMs);
    }
    [[nodiscard]] double quantile(double share) const {
        if (cpuMs.empty()) return 0.0;
        std::vector<double> sorted = cpuMs;
        std::ranges::sort(sorted);
        const auto last = static_cast<double>(sorted.size() - 1);
        return sorted[static_cast<std::size_t>(std::lround(share * last))];
    }
};

std::string counted(std::size_t part, std::size_t whole) {
    if (whole == 0) return "-";
    return fmt::format("{} of {}, {:.1f} %", part, whole,
                       100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

/// Which line of the table a row belongs to.
std::string groupOf(const RepairRow& row, const SeveralMistakes& several) {
    if (row.isOneEdit) return "mistakes of one edit";
    if (row.collection.ends_with("mistakes")) return "other mistakes";
    return several.contains(nameOf(row)) ? "unseen and samples, several mistakes"
                                         : "unseen and samples, a single mistake";
}

std::string ratesOf(const std::vector<RepairRow>& rows, const SeveralMistakes& several) {
    std::map<std::pair<std::string, std::string>, Sum> sums;
    for (const RepairRow& row : rows) {
        const std::string group = groupOf(row, several);
        sums[{group, row.task}].add(row);
        sums[{group, "all"}].add(row);
    }
    std::string text =
        "| submissions | task | tried | repaired | in the edited line | CPU, median | CPU, 90 % |\n"
        "|---|---|---|---|---|---|---|\n";
    for (const auto& [key, sum] : sums) {
        const bool knowsLine = key.first.starts_with("mistakes");
        text += fmt::format("| {} | {} | {} | {} | {} | {:.1f} s | {:.1f} s |\n", key.first,
                            key.second, sum.tried, counted(sum.repaired, sum.tried),
                            knowsLine ? counted(sum.rightLine, sum.repaired) : "not known",
                            sum.quantile(0.5) / 1000.0, sum.quantile(0.9) / 1000.0);
    }
    return text;
}

const char* outcomeOf(const RepairRow& row) {
    return row.isRepaired ? "repaired" : row.wasCutOff ? "cut off" : "nothing";
}

std::string missesOf(const std::vector<RepairRow>& rows) {
    std::string text = "| task | mistake | what came | CPU |\n|---|---|---|---|\n";
    for (const RepairRow& row : rows)
        if (row.isOneEdit && !row.isRightLine)
            text +=
                fmt::format("| {} | {} | {} | {:.1f} s |\n", row.task, row.name,
                            row.isRepaired ? "another line" : outcomeOf(row), row.cpuMs / 1000.0);
    return text;
}

std::string unrepairedOf(const std::vector<RepairRow>& rows, const SeveralMistakes& several) {
    std::string text = "| submission | task | what came | CPU |\n|---|---|---|---|\n";
    for (const RepairRow& row : rows) {
        const bool isListed = row.collection.ends_with("mistakes") || several.contains(nameOf(row));
        if (!isListed && !row.isRepaired)
            text += fmt::format("| {}/{} | {} | {} | {:.1f} s |\n", row.collection, row.name,
                                row.task, outcomeOf(row), row.cpuMs / 1000.0);
    }
    return text;
}

std::string severalOf(const std::vector<RepairRow>& rows, const SeveralMistakes& several) {
    std::string text =
        "| submission | task | what came | why no single mistake |\n|---|---|---|---|\n";
    for (const RepairRow& row : rows)
        if (const auto why = several.find(nameOf(row)); why != several.end())
            text += fmt::format("| {}/{} | {} | {} | {} |\n", row.collection, row.name, row.task,
                                outcomeOf(row), why->second);
    return text;
}

}  // namespace

std::string nameOf(const RepairRow& row) {
    return row.collection + "/" + row.task + "/" + row.name;
}

std::string jsonOf(const RepairRow& row) {
    return nlohmann::json{{"collection", row.collection},
                          {"task", row.task},
                          {"name", row.name},
                          {"isOneEdit", row.isOneEdit},
                          {"isRepaired", row.isRepaired},
                          {"isRightLine", row.isRightLine},
                          {"wasCutOff", row.wasCutOff},
                          {"cpuMs", row.cpuMs},
                          {"parseMs", row.parseMs},
                          {"compileMs", row.compileMs},
                          {"askMs", row.askMs},
                          {"proveMs", row.proveMs},
                          {"tried", row.tried},
                          {"edit", row.edit}}
        .dump();
}

RepairRow rowOf(const std::string& json) {
    const JsonValue value = JsonValue::parse(json, "a row of repairs");
    RepairRow row;
    row.collection = value.at("collection").text();
    row.task = value.at("task").text();
    row.name = value.at("name").text();
    row.isOneEdit = value.at("isOneEdit").flag();
    row.isRepaired = value.at("isRepaired").flag();
    row.isRightLine = value.at("isRightLine").flag();
    row.wasCutOff = value.at("wasCutOff").flag();
    row.cpuMs = value.at("cpuMs").number();
    row.parseMs = value.at("parseMs").number();
    row.compileMs = value.at("compileMs").number();
    row.askMs = value.at("askMs").number();
    row.proveMs = value.at("proveMs").number();
    row.tried = static_cast<std::size_t>(value.at("tried").number());
    row.edit = value.at("edit").text();
    return row;
}

std::string lineOf(const RepairRow& row) {
    const char* repaired = row.isRepaired ? "repaired" : row.wasCutOff ? "cut off" : "-";
    return fmt::format(
        "{:9} {:5} {:36} {:8} {:8} {:10} {:5} tried {:5.1f} s (parse {:.1f}, "
        "compile {:.1f}, ask {:.1f}, prove {:.1f})  {}",
        row.collection, row.task, row.name, row.isOneEdit ? "one edit" : "", repaired,
        row.isRightLine ? "right line" : "", row.tried, row.cpuMs / 1000.0, row.parseMs / 1000.0,
        row.compileMs / 1000.0, row.askMs / 1000.0, row.proveMs / 1000.0, row.edit);
}

std::string tablesOf(const std::vector<RepairRow>& rows, const SeveralMistakes& several) {
    return ratesOf(rows, several) +
           "\n## Mistakes of one edit that are not explained in their line\n" + missesOf(rows) +
           "\n## Unseen submissions and samples with a single mistake and no repair\n" +
           unrepairedOf(rows, several) +
           "\n## Unseen submissions and samples with several mistakes\n" + severalOf(rows, several);
}

std::string withTables(const std::string& document, const std::string& tables) {
    const std::string opening = "<!-- repairs: tables -->\n";
    const std::string closing = "<!-- end -->\n";
    const std::size_t mark = document.find(opening);
    const std::size_t end =
        mark == std::string::npos ? mark : document.find(closing, mark + opening.size());
    if (end == std::string::npos) return document + "\n" + opening + tables + closing;
    return document.substr(0, mark + opening.size()) + tables + document.substr(end);
}

}  // namespace ticker::lab

#include <grader/lab/repairs/RepairTables.h>

#include <grader/base/JsonValue.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
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
        std::vector<double> sorted = cpuMs;
        std::ranges::sort(sorted);
        const auto last = static_cast<double>(sorted.size() - 1);
        return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(share * last + 0.5)];
    }
};

std::string percent(std::size_t part, std::size_t whole) {
    if (whole == 0) return "-";
    return fmt::format("{:.0f} %", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
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

std::string tableOf(const std::vector<RepairRow>& rows) {
    std::map<std::pair<std::string, std::string>, Sum> sums;
    for (const RepairRow& row : rows) {
        sums[{row.collection, row.task}].add(row);
        if (!row.isOneEdit) continue;
        sums[{"mistakes of one edit", row.task}].add(row);
        sums[{"mistakes of one edit", "all"}].add(row);
    }
    std::string text =
        "| submissions | task | tried | repaired | in the edited line | CPU, median | CPU, 90 % |\n"
        "|---|---|---|---|---|---|---|\n";
    for (const auto& [key, sum] : sums) {
        const bool knowsLine = key.first.find("mistakes") != std::string::npos;
        text += fmt::format("| {} | {} | {} | {} | {} | {:.1f} s | {:.1f} s |\n", key.first,
                            key.second, sum.tried, percent(sum.repaired, sum.tried),
                            knowsLine ? percent(sum.rightLine, sum.repaired) : "not known",
                            sum.quantile(0.5) / 1000.0, sum.quantile(0.9) / 1000.0);
    }
    return text;
}

std::string missesOf(const std::vector<RepairRow>& rows) {
    std::string text = "| task | mistake | what came | CPU |\n|---|---|---|---|\n";
    for (const RepairRow& row : rows) {
        if (!row.isOneEdit || row.isRightLine) continue;
        const char* came = row.isRepaired ? "another line" : row.wasCutOff ? "cut off" : "nothing";
        text += fmt::format("| {} | {} | {} | {:.1f} s |\n", row.task, row.name, came,
                            row.cpuMs / 1000.0);
    }
    return text;
}

std::string documentOf(const std::vector<RepairRow>& rows) {
    return "# Repairs: measured rates\n"
           "Made by `ticker-lab repairs --write docs/repairs.md`. Each wrong submission of the "
           "corpus that fails one\ntask is graded and explained. *Mistakes of one edit* replace at "
           "most eight tokens in one line of the reference.\nA repair counts only if it is proven; "
           "the line is that of the simplest one. CPU is all of the explanation:\nparsing, "
           "compiling, asking, judging, proving.\n\n" +
           tableOf(rows) + "\n## Mistakes of one edit that are not explained in their line\n" +
           missesOf(rows);
}

}  // namespace ticker::lab

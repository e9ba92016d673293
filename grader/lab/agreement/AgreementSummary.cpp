#include <grader/lab/agreement/OracleAgreement.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ticker::calibrate {
namespace {

// Limit of |z| for means and variances: with 75 000 comparisons of normal variables, the
// probability of any false alarm is below 1e-3.
constexpr double kLargestZ = 5.8;
// Largest share of the pixels of bumpy scenes that may be off at an edge: see kEdge in
// OracleAgreement.cpp.
constexpr double kEdgeShare = 0.01;

/// All units of one reading.
struct Row {
    int units = 0;
    int comparisons = 0;
    double largestZ = 0.0;
    double sumZ2 = 0.0;
    double varianceZ = 0.0;
    int pixels = 0;
    int off = 0;
    double largest = 0.0;

    void add(const nlohmann::json& record) {
        ++units;
        if (record.contains("off")) {
            pixels += record.at("pixels").get<int>();
            off += record.at("off").get<int>();
            largest = std::max(largest, record.at("largest").get<double>());
            return;
        }
        const int tiles = record.at("tiles").get<int>();
        comparisons += tiles;
        sumZ2 += tiles * record.at("meanZ2").get<double>();
        largestZ = std::max(largestZ, record.at("largestZ").get<double>());
        varianceZ = std::max(varianceZ, record.at("varianceZ").get<double>());
    }

    [[nodiscard]] bool agrees() const {
        return largestZ < kLargestZ && varianceZ < kLargestZ && off <= kEdgeShare * pixels;
    }
};

}  // namespace

// Other instruction sets change a z by a few hundredths in single precision, and move rays at an
// edge.
bool OracleAgreement::agrees(const std::string& before, const std::string& now) const {
    constexpr double kOfZ = 0.1;
    constexpr int kAtEdges = 5;
    const nlohmann::json then = nlohmann::json::parse(before);
    const nlohmann::json again = nlohmann::json::parse(now);
    const auto near = [&](const char* name, double most) {
        return std::abs(then.value(name, 0.0) - again.value(name, 0.0)) <= most;
    };
    return then.at("reading") == again.at("reading") && then.at("scene") == again.at("scene") &&
           near("largestZ", kOfZ) && near("varianceZ", kOfZ) && near("off", kAtEdges);
}

Summary OracleAgreement::summarise(const std::vector<std::string>& records) const {
    std::vector<std::pair<std::string, Row>> rows;
    for (const AgreementCase& wanted : plan_.cases)
        rows.emplace_back(wanted.name, Row{});
    for (const std::string& text : records) {
        const auto record = nlohmann::json::parse(text);
        const auto row = std::ranges::find(rows, record.at("reading").get<std::string>(),
                                           &std::pair<std::string, Row>::first);
        if (row != rows.end()) row->second.add(record);
    }
    std::string noisy =
        "| reading | scenes x rounds | tile means | largest z | mean z^2 | largest z of a variance "
        "|\n|---|---|---|---|---|---|\n";
    std::string exact =
        "| bump reading | scenes | pixels | at an edge | largest difference elsewhere |\n"
        "|---|---|---|---|---|\n";
    Summary summary;
    for (const auto& [name, row] : rows) {
        if (row.units == 0) continue;
        summary.asExpected = summary.asExpected && row.agrees();
        if (row.pixels > 0)
            exact += fmt::format("| {} | {} | {} | {} | {:.1e} |\n", name, row.units, row.pixels,
                                 row.off, row.largest);
        else
            noisy += fmt::format("| {} | {} | {} | {:.2f} | {:.3f} | {:.2f} |\n", name, row.units,
                                 row.comparisons, row.largestZ, row.sumZ2 / row.comparisons,
                                 row.varianceZ);
    }
    summary.text = noisy + "\n" + exact;
    return summary;
}

}  // namespace ticker::calibrate

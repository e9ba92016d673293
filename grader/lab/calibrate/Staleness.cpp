#include <grader/lab/calibrate/Staleness.h>

#include <fmt/format.h>

#include <cstddef>
#include <map>
#include <set>

namespace ticker::calibrate {
namespace {

constexpr const char* kNeverRun = "";
constexpr const char* kUnknownCode = "the record does not say what";

/// Units that are stale for the same reason.
struct Stale {
    std::size_t units = 0;
    double cpuMs = 0.0;
    std::set<std::string> tasks;
    std::set<std::string> entries;  // named if only the entries' own text has changed
};

std::string joined(const std::set<std::string>& names) {
    constexpr std::size_t kMost = 5;
    std::string text;
    std::size_t count = 0;
    for (const std::string& name : names) {
        if (count == kMost) return text + fmt::format(" and {} more", names.size() - kMost);
        text += (count++ == 0 ? "" : ", ") + name;
    }
    return text;
}

// The parts that differ, for a message.
std::string reasonFor(const Stamp& then, const Stamp& today, const Parts& parts) {
    std::set<std::string> changed;
    for (const auto& [part, digest] : today) {
        const auto before = then.find(part);
        if (before != then.end() && before->second == digest) continue;
        changed.insert(part == kOwnPart ? std::string{"the entry itself"} : parts.placeOf(part));
    }
    return then.empty() ? kUnknownCode : joined(changed);
}

std::string minutes(double ms) {
    constexpr double kMinute = 60e3;
    return ms == 0.0      ? "an unknown time"
           : ms < kMinute ? fmt::format("{:.0f} s of CPU", ms / 1e3)
                          : fmt::format("{:.1f} minutes of CPU", ms / kMinute);
}

std::string lineOf(const Campaign& campaign, const std::string& reason, const Stale& stale) {
    const std::string what = stale.tasks.empty() ? "" : fmt::format(" of {}", joined(stale.tasks));
    const std::string which = reason == "the entry itself" || reason == kNeverRun
                                  ? fmt::format(" ({})", joined(stale.entries))
                                  : "";
    return fmt::format(
        "{}: {} of {} units{}{} {}; repeat them with ./tick calibrate --only {}, {} and compiling",
        campaign.name(), stale.units, campaign.units(), what, which,
        reason == kNeverRun ? "were never run" : "are of other code, changed: " + reason,
        campaign.name(), minutes(stale.cpuMs));
}

double meanCpuMs(const Record& record) {
    double sum = 0.0;
    for (const std::string& found : record.all())
        sum += cpuMsOf(found);
    return record.size() == 0 ? 0.0 : sum / static_cast<double>(record.size());
}

}  // namespace

std::vector<std::string> stalenessOf(const Campaign& campaign, const Record& record,
                                     const std::vector<Stamp>& stamps, const Parts& parts) {
    std::map<std::string, Stale> byReason;
    const double mean = meanCpuMs(record);
    for (std::size_t unit = 0; unit < campaign.units(); ++unit) {
        if (record.isCurrent(unit, stamps.at(unit))) continue;
        const bool known = record.has(unit);
        Stale& stale =
            byReason[known ? reasonFor(record.stampOf(unit), stamps[unit], parts) : kNeverRun];
        ++stale.units;
        stale.cpuMs += known ? cpuMsOf(record.at(unit)) : mean;
        const Campaign::Basis basis = campaign.basisOf(unit);
        stale.tasks.insert(basis.measured.begin(), basis.measured.end());
        stale.entries.insert(basis.entry);
    }
    std::vector<std::string> lines;
    for (const auto& [reason, stale] : byReason)
        lines.push_back(lineOf(campaign, reason, stale));
    return lines;
}

}  // namespace ticker::calibrate

#include <grader/lab/calibrate/RunCampaign.h>

#include <grader/base/Workers.h>

#include <fmt/core.h>
#include <algorithm>
#include <mutex>

namespace ticker::calibrate {

std::vector<Stamp> stampsOf(const Campaign& campaign, const Parts& parts) {
    std::vector<Stamp> stamps;
    for (std::size_t unit = 0; unit < campaign.units(); ++unit) {
        const Campaign::Basis basis = campaign.basisOf(unit);
        Stamp& stamp = stamps.emplace_back();
        for (const std::string& measured : basis.measured)
            stamp.merge(parts.stampOf(measured));
        if (!basis.text.empty()) stamp.emplace(kOwnPart, shortDigest(basis.text));
    }
    return stamps;
}

std::size_t currentUnits(const Record& record, const std::vector<Stamp>& stamps) {
    std::size_t current = 0;
    for (std::size_t unit = 0; unit < stamps.size(); ++unit)
        if (record.isCurrent(unit, stamps[unit])) ++current;
    return current;
}

void runCampaign(Campaign& campaign, Record& record, const std::vector<Stamp>& stamps, int jobs,
                 const OnUnit& onUnit, std::string_view part) {
    std::vector<std::size_t> missing;
    for (std::size_t unit = 0; unit < campaign.units(); ++unit)
        if (!record.isCurrent(unit, stamps.at(unit)) &&
            campaign.unitName(unit).find(part) != std::string::npos)
            missing.push_back(unit);
    std::size_t done = currentUnits(record, stamps);
    std::mutex mutex;
    onWorkers(jobs, missing.size(), [&](std::size_t i) {
        const std::size_t unit = missing[i];
        const std::string found = campaign.run(unit);
        const std::lock_guard lock{mutex};
        record.add(unit, found, stamps[unit]);
        if (onUnit) onUnit(++done, campaign.units());
    });
}

std::vector<std::string> checkCampaign(Campaign& campaign, const Record& record, int jobs) {
    std::vector<std::string> differences;
    std::mutex mutex;
    const std::vector<std::size_t> units = campaign.checkUnits();
    onWorkers(jobs, units.size(), [&](std::size_t i) {
        const std::size_t unit = units[i];
        const std::string before = record.at(unit);
        const std::string now = campaign.run(unit);
        if (!before.empty() && campaign.agrees(before, now)) return;
        const std::lock_guard lock{mutex};
        differences.push_back(fmt::format("{}, {}: {} was recorded, {} came now", campaign.name(),
                                          campaign.unitName(unit),
                                          before.empty() ? "nothing" : before, now));
    });
    std::sort(differences.begin(), differences.end());
    return differences;
}

}  // namespace ticker::calibrate

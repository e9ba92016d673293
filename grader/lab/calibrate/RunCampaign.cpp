#include <grader/lab/calibrate/RunCampaign.h>

#include <grader/base/Workers.h>

#include <fmt/core.h>
#include <algorithm>
#include <mutex>

namespace ticker::calibrate {
void runCampaign(Campaign& campaign, Record& record, int jobs, const OnUnit& onUnit) {
    std::vector<std::size_t> missing;
    for (std::size_t unit = 0; unit < campaign.units(); ++unit)
        if (!record.has(unit)) missing.push_back(unit);
    std::mutex mutex;
    onWorkers(jobs, missing.size(), [&](std::size_t i) {
        const std::size_t unit = missing[i];
        const std::string found = campaign.run(unit);
        const std::lock_guard lock{mutex};
        record.add(unit, found);
        if (onUnit) onUnit(record.size(), campaign.units());
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

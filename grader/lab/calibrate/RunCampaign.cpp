#include <grader/lab/calibrate/RunCampaign.h>

#include <fmt/core.h>
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace ticker::calibrate {
namespace {

void onThreads(int jobs, const std::vector<std::size_t>& units,
               const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> stop{false};
    std::mutex mutex;
    std::exception_ptr error;
    const auto loop = [&] {
        for (std::size_t i = next++; i < units.size() && !stop; i = next++) {
            try {
                work(units[i]);
            } catch (...) {
                const std::lock_guard lock{mutex};
                if (!error) error = std::current_exception();
                stop = true;
            }
        }
    };
    {
        std::vector<std::jthread> helpers;
        for (int i = 1; i < jobs; ++i)
            helpers.emplace_back(loop);
        loop();
    }
    if (error) std::rethrow_exception(error);
}

}  // namespace

void runCampaign(Campaign& campaign, Record& record, int jobs, const OnUnit& onUnit) {
    std::vector<std::size_t> missing;
    for (std::size_t unit = 0; unit < campaign.units(); ++unit)
        if (!record.has(unit)) missing.push_back(unit);
    std::mutex mutex;
    onThreads(jobs, missing, [&](std::size_t unit) {
        const std::string found = campaign.run(unit);
        const std::lock_guard lock{mutex};
        record.add(unit, found);
        if (onUnit) onUnit(record.size(), campaign.units());
    });
}

std::vector<std::string> checkCampaign(Campaign& campaign, const Record& record, int jobs) {
    std::vector<std::string> differences;
    std::mutex mutex;
    onThreads(jobs, campaign.checkUnits(), [&](std::size_t unit) {
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

#ifndef TICKER_TESTS_CALIBRATE_COUNTINGCAMPAIGN_H
#define TICKER_TESTS_CALIBRATE_COUNTINGCAMPAIGN_H

#include <grader/lab/calibrate/Campaign.h>

#include <atomic>

namespace ticker::calibrate {

/// Counts its runs.
class CountingCampaign final : public Campaign {
public:
    explicit CountingCampaign(std::size_t units) : units_(units) {}

    [[nodiscard]] std::string name() const override { return "counting"; }
    [[nodiscard]] std::size_t units() const override { return units_; }
    [[nodiscard]] std::string unitName(std::size_t unit) const override {
        return "number " + std::to_string(firstUnit + unit);
    }
    [[nodiscard]] Basis basisOf(std::size_t unit) const override {
        return {measured.empty() ? std::vector<std::string>{}
                                 : std::vector{measured.at(unit % measured.size())},
                "entry " + std::to_string(unit), text};
    }
    [[nodiscard]] std::vector<std::size_t> checkUnits() const override { return {0, 2}; }
    [[nodiscard]] std::string run(std::size_t unit) override {
        ++runs;
        return "{\"cpu\":" + std::to_string(runs) +
               ",\"square\":" + std::to_string(unit * unit + offset) + "}";
    }
    [[nodiscard]] Summary summarise(const std::vector<std::string>& records) const override {
        return {std::to_string(records.size()), true};
    }

    std::atomic<int> runs{0};
    std::size_t offset = 0;
    std::size_t firstUnit = 0;
    std::vector<std::string> measured;  // one for each unit, in turn
    std::string text;                   // of each unit's entry

private:
    std::size_t units_;
};

}  // namespace ticker::calibrate

#endif

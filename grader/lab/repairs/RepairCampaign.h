#ifndef TICKER_LAB_REPAIRS_REPAIRCAMPAIGN_H
#define TICKER_LAB_REPAIRS_REPAIRCAMPAIGN_H

#include <grader/corpus/Entry.h>
#include <grader/lab/calibrate/Campaign.h>
#include <grader/lab/repairs/RepairTables.h>
#include <grader/pipeline/Grade.h>

#include <cstdint>
#include <string>
#include <vector>

namespace ticker::lab {

/// Which wrong submissions are tried: all conditions at once.
struct RepairChoice {
    std::string task;                ///< only those that fail this one; empty: any
    std::vector<std::string> cases;  ///< only those of these names; empty: all
    bool ofOneEdit = false;          ///< only mistakes of one edit
    double fraction = 1.0;           ///< every so many of them
};

/// A unit grades one wrong submission of an exercise's corpus and looks for edits that mend it.
class RepairCampaign final : public calibrate::Campaign {
public:
    /// @param grader  Must outlive this object.
    RepairCampaign(const pipeline::Grader& grader, const std::vector<corpus::Entry>& entries,
                   const RepairChoice& choice, std::uint64_t seed);

    [[nodiscard]] std::string name() const override;
    [[nodiscard]] std::size_t units() const override { return units_.size(); }
    [[nodiscard]] std::string unitName(std::size_t unit) const override;
    [[nodiscard]] std::vector<std::size_t> checkUnits() const override { return {}; }
    [[nodiscard]] std::string run(std::size_t unit) override;
    [[nodiscard]] calibrate::Summary summarise(
        const std::vector<std::string>& records) const override;

private:
    struct Unit {
        corpus::Entry entry;
        std::string task;  ///< that it fails
    };

    const pipeline::Grader& grader_;
    pipeline::Grader judge_;  ///< the same without pictures, which no failure needs
    std::uint64_t seed_;
    std::vector<Unit> units_;
};

}  // namespace ticker::lab

#endif

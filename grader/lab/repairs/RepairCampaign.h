#ifndef TICKER_LAB_REPAIRS_REPAIRCAMPAIGN_H
#define TICKER_LAB_REPAIRS_REPAIRCAMPAIGN_H

#include <grader/corpus/Entry.h>
#include <grader/lab/repairs/RepairTables.h>
#include <grader/pipeline/Grade.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ticker::lab {

/// Which wrong submissions are tried: those that meet all conditions.
struct RepairChoice {
    std::vector<std::string> collections{"mistakes", "unseen", "samples"};
    std::string task;                ///< only those that fail this one; empty: any
    std::vector<std::string> cases;  ///< only those of these names; empty: all
    bool ofOneEdit = false;          ///< of the catalogue's mistakes only those of one edit
    double fraction = 1.0;           ///< share of them, evenly picked; at least one
};

/// The wrong submissions of an exercise's corpus that fail one task.
class RepairCampaign {
public:
    /// @param grader  Must outlive this object.
    RepairCampaign(const pipeline::Grader& grader, const std::vector<corpus::Entry>& entries,
                   const RepairChoice& choice, std::uint64_t seed);

    [[nodiscard]] std::size_t size() const { return units_.size(); }
    /// Name of a unit, unique over all exercises; the same as that of its row.
    [[nodiscard]] std::string nameOf(std::size_t unit) const;
    /// Grades the submission of a unit and looks for edits that mend it.
    [[nodiscard]] RepairRow run(std::size_t unit) const;

private:
    struct Unit {
        corpus::Entry entry;
        std::string task;  ///< the one that the entry fails
    };

    const pipeline::Grader& grader_;
    pipeline::Grader judge_;  ///< the same without scenes to render, which no failure needs
    std::uint64_t seed_;
    std::vector<Unit> units_;
};

}  // namespace ticker::lab

#endif

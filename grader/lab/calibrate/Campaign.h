#ifndef TICKER_CALIBRATE_CAMPAIGN_H
#define TICKER_CALIBRATE_CAMPAIGN_H

#include <cstddef>
#include <string>
#include <vector>

namespace ticker::calibrate {

/// What the records of a campaign say together.
struct Summary {
    std::string text;        ///< Markdown: tables, counts, confidence bounds
    bool asExpected = true;  ///< false: something came out that must not
};

/// A question about the grader that is answered by repeating: so many units of work, each
/// independent of the others, each worth one line of the record.
class Campaign {
public:
    Campaign() = default;
    virtual ~Campaign() = default;
    Campaign(const Campaign&) = delete;
    Campaign& operator=(const Campaign&) = delete;

    /// One word; names the record's file and the heading in docs/calibration.md.
    [[nodiscard]] virtual std::string name() const = 0;

    [[nodiscard]] virtual std::size_t units() const = 0;

    /// What the record knows the unit by: unique, and the same when subjects are added or removed.
    [[nodiscard]] virtual std::string unitName(std::size_t unit) const = 0;

    /// The few units that `--check` repeats: some seconds of CPU in all.
    [[nodiscard]] virtual std::vector<std::size_t> checkUnits() const = 0;

    /// Does one unit; several threads call it at once, neighbouring units are asked for together.
    /// @return  A JSON object as text, without line breaks. Doing a unit again gives one that
    ///          `agrees`; a member "cpu" may hold anything.
    /// @throws raytracer::Error where the unit could not be done.
    [[nodiscard]] virtual std::string run(std::size_t unit) = 0;

    /// Whether a unit that was done again came out as it was recorded: all but "cpu" is equal.
    /// Campaigns whose numbers differ between processors in their last digits allow for that.
    [[nodiscard]] virtual bool agrees(const std::string& before, const std::string& now) const;

    /// @param records  What `run` gave, in the order of the units; some may be missing.
    [[nodiscard]] virtual Summary summarise(const std::vector<std::string>& records) const = 0;
};

}  // namespace ticker::calibrate

#endif

#ifndef TICKER_CALIBRATE_CAMPAIGN_H
#define TICKER_CALIBRATE_CAMPAIGN_H

#include <cstddef>
#include <string>
#include <vector>

namespace ticker::calibrate {

/// Summary of a campaign's records.
struct Summary {
    std::string text;        ///< Markdown: tables, counts, confidence bounds
    bool asExpected = true;  ///< false: an unacceptable result occurred
};

/// A measurement of the grader by repetition: independent units of work, each with one line of the
/// record.
class Campaign {
public:
    Campaign() = default;
    virtual ~Campaign() = default;
    Campaign(const Campaign&) = delete;
    Campaign& operator=(const Campaign&) = delete;

    /// One word: the name of the record's file and the heading in docs/calibration.md.
    [[nodiscard]] virtual std::string name() const = 0;

    [[nodiscard]] virtual std::size_t units() const = 0;

    /// Key of the unit in the record: unique, and unchanged when subjects are added or removed.
    [[nodiscard]] virtual std::string unitName(std::size_t unit) const = 0;

    /// What a unit's result depends on.
    struct Basis {
        std::vector<std::string> measured;  ///< names that `Parts` knows
        std::string entry;                  ///< name of what is measured, for messages
        std::string text;                   ///< that this unit alone depends on; may be empty
    };
    [[nodiscard]] virtual Basis basisOf(std::size_t unit) const = 0;

    /// The few units that `--check` repeats: some seconds of CPU in all.
    [[nodiscard]] virtual std::vector<std::size_t> checkUnits() const = 0;

    /// Runs one unit. Several threads call it at once; neighbouring units are requested together.
    /// @return  A JSON object as text, without line breaks. A repeated unit gives one that
    ///          `agrees`. The member "cpu", which may differ, is the CPU time of submission and
    ///          judgement together, without compiling: a number of milliseconds, or an object with
    ///          the number of decisions for each time.
    /// @throws raytracer::Error if the unit could not be run.
    [[nodiscard]] virtual std::string run(std::size_t unit) = 0;

    /// Whether a repeated unit agrees with its record: everything but "cpu" is equal. Campaigns
    /// whose numbers depend on the processor allow for differences in the last digits.
    [[nodiscard]] virtual bool agrees(const std::string& before, const std::string& now) const;

    /// @param records  Results of `run` in the order of the units; some may be missing.
    [[nodiscard]] virtual Summary summarise(const std::vector<std::string>& records) const = 0;
};

/// The CPU time of a result of `Campaign::run`, milliseconds; 0 where it names none.
[[nodiscard]] double cpuMsOf(const std::string& found);

}  // namespace ticker::calibrate

#endif

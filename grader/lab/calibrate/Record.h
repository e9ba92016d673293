#ifndef TICKER_CALIBRATE_RECORD_H
#define TICKER_CALIBRATE_RECORD_H

#include <grader/lab/calibrate/Campaign.h>
#include <grader/lab/calibrate/Parts.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ticker::calibrate {

/// The finished units of one campaign on disk, `FOLDER/<name>.jsonl`: a first line that names the
/// campaign, then one line for each unit in the order of finishing, with the code that it belongs
/// to. Lines are only added, and the last line of a unit counts; a last line that was cut short by
/// a kill is not read, and goes with the next `add`. Units are identified by name; units that the
/// campaign no longer has are ignored.
class Record {
public:
    /// Reads the existing record, and writes nothing. The first `add` creates the folder and the
    /// file if necessary.
    /// @throws raytracer::InputError if the file belongs to another campaign, or a line of it
    ///         cannot be read.
    Record(const std::filesystem::path& folder, const Campaign& campaign);

    /// Writes one line. Several threads may call it.
    void add(std::size_t unit, const std::string& found, const Stamp& stamp = {});
    /// Takes over, in memory, units of another record: those that belong to the code of the stamps,
    /// and those that this record lacks. Units of this record that belong to that code stay.
    /// @param stamps  One for each unit of the campaign.
    void adopt(const Record& other, const std::vector<Stamp>& stamps);

    [[nodiscard]] bool has(std::size_t unit) const { return found_.contains(unit); }
    /// Empty if the unit is not finished.
    [[nodiscard]] std::string at(std::size_t unit) const;
    /// The stamp of the code that a unit was measured with; empty if the unit is not finished, or
    /// is older than stamps.
    [[nodiscard]] Stamp stampOf(std::size_t unit) const;
    /// Whether the unit is finished, and was measured with the code of this stamp.
    [[nodiscard]] bool isCurrent(std::size_t unit, const Stamp& stamp) const;
    [[nodiscard]] std::size_t size() const { return found_.size(); }
    /// In the order of the units.
    [[nodiscard]] std::vector<std::string> all() const;

    /// Writes everything to another folder, sorted by unit; an earlier file that is not
    /// the same is replaced whole.
    void copyTo(const std::filesystem::path& folder) const;

private:
    struct Line {
        std::string found;
        Stamp stamp;
    };
    [[nodiscard]] std::string header() const;
    [[nodiscard]] std::string lineOf(std::size_t unit, const Line& line) const;
    void read();
    /// The name of the unit, and what was found.
    [[nodiscard]] std::pair<std::string, Line> readLine(const std::string& text, int number) const;

    std::filesystem::path file_;
    std::string name_;
    std::vector<std::string> unitNames_;
    std::map<std::size_t, Line> found_;
    std::optional<std::size_t> wholeBytes_;  // of the file, if its last line was cut short
    std::mutex mutex_;
};

}  // namespace ticker::calibrate

#endif

#ifndef TICKER_CALIBRATE_RECORD_H
#define TICKER_CALIBRATE_RECORD_H

#include <grader/lab/calibrate/Campaign.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace ticker::calibrate {

/// The finished units of one campaign on disk, `FOLDER/<name>.jsonl`: a first line that names the
/// campaign, then one line for each unit in the order of finishing. Lines are only added; a line
/// that was cut short by a kill is dropped when the file is opened again. Units are identified by
/// name; units that the campaign no longer has are ignored.
class Record {
public:
    /// Reads the existing record. The first `add` creates the folder and the file if necessary.
    /// @throws raytracer::InputError if the file belongs to another campaign, or cannot be read.
    Record(const std::filesystem::path& folder, const Campaign& campaign);

    /// Writes one line; threads may call it at once.
    void add(std::size_t unit, const std::string& found);

    [[nodiscard]] bool has(std::size_t unit) const { return found_.contains(unit); }
    /// Empty if the unit is not finished.
    [[nodiscard]] std::string at(std::size_t unit) const;
    [[nodiscard]] std::size_t size() const { return found_.size(); }
    /// In the order of the units.
    [[nodiscard]] std::vector<std::string> all() const;

    /// Writes everything to another folder, sorted by unit.
    void copyTo(const std::filesystem::path& folder) const;

private:
    [[nodiscard]] std::string header() const;
    [[nodiscard]] std::string lineOf(std::size_t unit, const std::string& found) const;
    void read();

    std::filesystem::path file_;
    std::string name_;
    std::vector<std::string> unitNames_;
    std::map<std::size_t, std::string> found_;
    std::mutex mutex_;
};

}  // namespace ticker::calibrate

#endif

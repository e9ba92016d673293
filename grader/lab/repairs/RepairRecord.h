#ifndef TICKER_LAB_REPAIRS_REPAIRRECORD_H
#define TICKER_LAB_REPAIRS_REPAIRRECORD_H

#include <grader/lab/repairs/RepairTables.h>

#include <filesystem>
#include <map>
#include <string>

namespace ticker::lab {

/// Finished rows on disk, a line each, so that a run can be stopped and continued. A line that was
/// cut short is dropped. A row does not contain the version of the tool, so that a new tool needs a
/// new file.
class RepairRecord {
public:
    /// @throws raytracer::InputError if the file cannot be read.
    explicit RepairRecord(std::filesystem::path file);

    /// Null if this submission was not tried yet.
    [[nodiscard]] const RepairRow* find(const std::string& name) const;
    /// @throws raytracer::InputError if the file cannot be written.
    void add(const RepairRow& row);

private:
    std::filesystem::path file_;
    std::map<std::string, RepairRow> rows_;
};

}  // namespace ticker::lab

#endif

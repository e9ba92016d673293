#ifndef TICKER_REPORT_MOODLECOLUMNS_H
#define TICKER_REPORT_MOODLECOLUMNS_H

#include <grader/report/platforms/CsvFile.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ticker::report {

/// Column numbers of Moodle's grading worksheet. Moodle recognises columns by their English names.
struct MoodleColumns {
    std::size_t id = 0;
    std::size_t grade = 0;
    std::size_t gradedAt = 0;
    std::optional<std::size_t> feedback;
    std::optional<std::size_t> maximum;
    std::optional<std::size_t> scale;
    std::optional<std::size_t> mayChange;
    std::optional<std::size_t> group;
};

/// @param name  The worksheet's file name, for messages.
/// @throws raytracer::InputError with the name of a missing column.
[[nodiscard]] MoodleColumns moodleColumns(const CsvFile& file, const std::string& name);

/// Refuses a worksheet that a spreadsheet program has saved: Moodle does not accept it.
/// @throws raytracer::InputError with the format to use instead.
void refuseIfResaved(std::string_view worksheet, const std::string& name);

/// A line about dates that Moodle will not read; empty if all dates are in English.
[[nodiscard]] std::string dateWarning(const CsvFile& file, const MoodleColumns& columns);

}  // namespace ticker::report

#endif

#include <grader/report/platforms/MoodleColumns.h>

#include <grader/base/Utf8.h>
#include <grader/report/Escape.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace ticker::report {
namespace {

constexpr const char* kGradedAt = "Last modified (grade)";

std::optional<std::size_t> columnOf(const CsvFile& file, std::string_view header) {
    for (std::size_t i = 0; i < file.columns(); ++i)
        if (lowerCase(file.value(0, i)) == lowerCase(std::string{header})) return i;
    return std::nullopt;
}

bool isEnglishDate(const std::string& text) {
    static constexpr std::array kDays{"Monday", "Tuesday",  "Wednesday", "Thursday",
                                      "Friday", "Saturday", "Sunday"};
    return std::ranges::any_of(kDays, [&](const char* day) { return text.starts_with(day); });
}

}  // namespace

MoodleColumns moodleColumns(const CsvFile& file, const std::string& name) {
    // Moodle requires all three columns, even if we do not use them.
    for (const char* needed : {"Identifier", "Grade", kGradedAt})
        if (!columnOf(file, needed))
            throw raytracer::InputError(
                name, 1,
                fmt::format("no column \"{}\"; expected Moodle's grading worksheet as downloaded, "
                            "in English",
                            needed));
    return {.id = *columnOf(file, "Identifier"),
            .grade = *columnOf(file, "Grade"),
            .gradedAt = *columnOf(file, kGradedAt),
            .feedback = columnOf(file, "Feedback comments"),
            .maximum = columnOf(file, "Maximum grade"),
            .scale = columnOf(file, "Scale"),
            .mayChange = columnOf(file, "Grade can be changed"),
            .group = columnOf(file, "Group")};
}

void refuseIfResaved(std::string_view worksheet, const std::string& name) {
    const std::string_view header = worksheet.substr(0, worksheet.find('\n'));
    const bool isUtf16 = header.starts_with("\xFF\xFE") || header.starts_with("\xFE\xFF");
    const bool hasOtherSeparators = header.find(',') == std::string_view::npos &&
                                    header.find_first_of(";\t") != std::string_view::npos;
    if (isUtf16 || hasOtherSeparators)
        throw raytracer::InputError(
            name, 1,
            fmt::format("{}: it was saved by another program, such as Excel; hand in the worksheet "
                        "as Moodle's download, untouched, with the comma as separator",
                        isUtf16 ? "UTF-16 text" : "no comma in the first line"));
}

std::string dateWarning(const CsvFile& file, const MoodleColumns& columns) {
    for (std::size_t row = 1; row < file.rows(); ++row) {
        const std::string& date = file.value(row, columns.gradedAt);
        if (!date.empty() && date != "-" && !isEnglishDate(date))
            return fmt::format(
                "row {}: \"{}\" is no date in English, and Moodle skips such rows: switch Moodle "
                "to English for download and upload",
                row + 1, escapeLine(date));
    }
    return "";
}

}  // namespace ticker::report

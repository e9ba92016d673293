#ifndef TICKER_TESTS_SUPPORT_MOODLEIMPORT_H
#define TICKER_TESTS_SUPPORT_MOODLEIMPORT_H

#include <grader/tests/support/MoodleExport.h>

#include <ctime>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::tests {

/// Moodle's record of one participant of an assignment.
struct MoodleRecord {
    std::string grade = {};               ///< empty: none yet; a number, or a word of the scale
    std::time_t gradedAt = 0;             ///< of the grade
    std::string feedback = {};            ///< comments, HTML
    bool locked = false;                  ///< in the gradebook
    std::vector<std::string> files = {};  ///< feedback files, by path
};

/// An assignment in Moodle, which writes worksheets and reads them back: after
/// mod/assign/feedback/offline (importgradeslib.php, locallib.php) and feedback/file
/// (importziplib.php) of Moodle 4.
class MoodleAssignment {
public:
    double maximum = 100.0;
    std::vector<std::string> scale = {};  ///< not empty: grades are these words
    bool blind = false;
    bool teams = false;
    bool byteOrderMark = true;
    bool dropsZeros = false;      ///< the newest code (0bd8f1fd, "multiple marking"): 0 is no grade
    bool wantsFiveParts = false;  ///< before 4.1.10: a folder of feedback ends in an underscore
    std::map<int, MoodleRecord> records = {};  ///< by participant

    /// The worksheet as downloaded. In a team assignment each of `students` is a person and `group`
    /// is the team.
    [[nodiscard]] std::string worksheet(const std::vector<MoodleStudent>& students) const;

    /// Outcome of a row of an uploaded worksheet.
    enum class Row { taken, sameGrade, noGrade, stale, locked, outOfRange, unknownPerson };

    /// Reads a worksheet. @return  One entry for each row, by the value of Identifier.
    /// @throws std::runtime_error if Moodle would refuse the whole file.
    std::map<std::string, Row> upload(std::string_view csv, std::time_t now);

    /// Reads one file of a feedback zip. @return  False if Moodle finds no participant for it.
    bool uploadFeedback(const std::string& path);
};

/// The records of a CSV file, read as PHP's fgetcsv does.
[[nodiscard]] std::vector<std::vector<std::string>> readLikePhp(std::string_view csv);

/// A moment of the past in the format of worksheets.
[[nodiscard]] std::string moodleDate(std::time_t when);

}  // namespace ticker::tests

#endif

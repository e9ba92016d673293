#ifndef TICKER_REPORT_MOODLEWORKSHEET_H
#define TICKER_REPORT_MOODLEWORKSHEET_H

#include <grader/report/student/StudentView.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::report {

/// The words of an assignment's scale, exactly as in Moodle.
struct ScaleWords {
    std::string notAwarded;
    std::string awarded;
};

/// A file for a zip.
struct NamedText {
    std::string path;
    std::string text;
};

/// A participant of the worksheet whose submission was graded.
struct MoodleParticipant {
    std::string id;  ///< the digits of "Participant 123"
    std::size_t view = 0;
};

/// Result of filling in a worksheet.
struct MoodleGrades {
    std::string worksheet;  ///< for upload
    std::vector<MoodleParticipant> graded;
    std::vector<std::string> remarks;  ///< unchanged rows with the reason; one line each
    /// Problems that Moodle may have with the sheet; one line each.
    std::vector<std::string> warnings;
};

/// Fills in Moodle's grading worksheet: grade and feedback of submissions whose tick is awarded or
/// not awarded; all other bytes stay. A row is found by the id at the end of a submission's name
/// ("Ann Lee_123"), a team's row by the name in the column Group. A grade is the score's share of
/// the row's maximum, or a word of the scale. Rows that need review, were not graded, are locked or
/// fit several submissions stay unchanged, with a remark. A warning explains how to avoid a loss of
/// rows in Moodle.
/// @param name  The worksheet's file name, for messages.
/// @throws raytracer::InputError if a column is missing, or if a scale is used and `scale` is
///         empty.
[[nodiscard]] MoodleGrades fillMoodleWorksheet(std::string_view worksheet, const std::string& name,
                                               const std::vector<StudentView>& views,
                                               const std::optional<ScaleWords>& scale);

/// The files of Moodle's feedback zip: each participant's page, with the name that Moodle expects.
/// @param pages  One for each view.
[[nodiscard]] std::vector<NamedText> moodleFeedbackFiles(
    const std::vector<MoodleParticipant>& graded, const std::vector<StudentView>& views,
    const std::vector<std::string>& pages);

}  // namespace ticker::report

#endif

#ifndef TICKER_REPORT_MOODLEWORKSHEET_H
#define TICKER_REPORT_MOODLEWORKSHEET_H

#include <grader/report/StudentView.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::report {

/// The words of an assignment that is graded by a scale, exactly as Moodle has them.
struct ScaleWords {
    std::string notAwarded;
    std::string awarded;
};

/// A file to be put into a zip.
struct NamedText {
    std::string path;
    std::string text;
};

/// Somebody of the worksheet whose submission was graded.
struct MoodleParticipant {
    std::string id;  ///< the digits of "Participant 123"
    std::size_t view = 0;
};

/// What became of a worksheet.
struct MoodleGrades {
    std::string worksheet;  ///< to be uploaded
    std::vector<MoodleParticipant> graded;
    std::vector<std::string> remarks;   ///< whose row was left as it is, and why; one line each
    std::vector<std::string> warnings;  ///< what Moodle may do with the sheet; one line each
};

/// Fills in Moodle's grading worksheet: Grade and Feedback comments of those whose tick is awarded
/// or not, nothing else; every other byte stays. Rows are found by the id at the end of a
/// submission's name ("Ann Lee_123"), a team's by its name in the column Group. A grade is the
/// share of the row's maximum, or a word of the scale. What needs a person, was not graded, or is
/// locked stays as it is, with a remark. Where a Moodle would lose rows, a warning says how to keep
/// them.
/// @param name  The worksheet's file name, for messages.
/// @throws raytracer::InputError where a column is missing, or a scale is used and `scale` is
/// empty.
[[nodiscard]] MoodleGrades fillMoodleWorksheet(std::string_view worksheet, const std::string& name,
                                               const std::vector<StudentView>& views,
                                               const std::optional<ScaleWords>& scale);

/// The files of Moodle's feedback zip: each participant's page, under the name by which Moodle
/// finds the participant.
/// @param pages  One for each view.
[[nodiscard]] std::vector<NamedText> moodleFeedbackFiles(
    const std::vector<MoodleParticipant>& graded, const std::vector<StudentView>& views,
    const std::vector<std::string>& pages);

}  // namespace ticker::report

#endif

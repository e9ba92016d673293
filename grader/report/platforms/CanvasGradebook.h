#ifndef TICKER_REPORT_CANVASGRADEBOOK_H
#define TICKER_REPORT_CANVASGRADEBOOK_H

#include <grader/report/student/StudentView.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::report {

/// Result of filling in a gradebook.
struct CanvasGrades {
    std::string gradebook;             ///< for Canvas's import
    std::vector<std::size_t> graded;   ///< views that have a row and a score
    std::vector<std::string> remarks;  ///< unchanged rows with the reason; one line each
};

/// Fills in one assignment's column of the gradebook as Canvas exported it; all other bytes stay,
/// such as the row "Points Possible", which gives the maximum. A row is found by its column ID, the
/// id at the end of a submission's name ("leeann_4711"). Cells of submissions that need review,
/// were not graded, are excused ("EX") or share an id stay unchanged, with a remark: the import
/// changes nothing where a cell is as before.
/// @param name        The file's name, for messages.
/// @param assignment  "Tick 1", "Tick 1 (815)" or "815"; empty if there is only one.
/// @throws raytracer::InputError if a column is missing or several fit.
[[nodiscard]] CanvasGrades fillCanvasGradebook(std::string_view gradebook, const std::string& name,
                                               std::string_view assignment,
                                               const std::vector<StudentView>& views);

/// A student's source file with what the student may read as a comment at its top: Canvas shows a
/// comment's file under the name of the file that was handed in.
[[nodiscard]] std::string commentedSource(const StudentView& view, std::string_view source);

}  // namespace ticker::report

#endif

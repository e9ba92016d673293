#include <grader/report/platforms/CanvasGradebook.h>

#include <grader/base/Trimmed.h>
#include <grader/report/Escape.h>
#include <grader/report/platforms/CsvFile.h>
#include <grader/report/platforms/SubmissionId.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <set>

namespace ticker::report {
namespace {

constexpr std::string_view kPointsRow = "Points Possible";

/// "815" of "Tick 1 (815)"; empty for columns that are no assignment's.
std::string_view assignmentId(std::string_view header) {
    const std::size_t open = header.rfind(" (");
    if (open == std::string_view::npos || !header.ends_with(')')) return {};
    const std::string_view id = header.substr(open + 2, header.size() - open - 3);
    const bool isNumber =
        !id.empty() && id.find_first_not_of("0123456789") == std::string_view::npos;
    return isNumber ? id : std::string_view{};
}

bool fits(std::string_view header, std::string_view assignment) {
    const std::string_view id = assignmentId(header);
    if (id.empty()) return false;
    return assignment.empty() || header == assignment || id == assignment ||
           trimmed(header.substr(0, header.rfind(" ("))) == assignment;
}

std::size_t columnOf(const CsvFile& file, const std::string& name, std::string_view header) {
    for (std::size_t i = 0; i < file.columns(); ++i)
        if (trimmed(file.value(0, i)) == header) return i;
    throw raytracer::InputError(
        name, 1,
        fmt::format("no column \"{}\"; expected the gradebook as Canvas exports it", header));
}

std::size_t assignmentColumn(const CsvFile& file, const std::string& name,
                             std::string_view assignment) {
    std::vector<std::size_t> found;
    std::string known;
    for (std::size_t i = 0; i < file.columns(); ++i) {
        const std::string header = file.value(0, i);
        if (fits(header, assignment)) found.push_back(i);
        if (!assignmentId(header).empty()) known += (known.empty() ? "" : ", ") + header;
    }
    if (found.size() == 1) return found.front();
    throw raytracer::InputError(
        name, 1,
        fmt::format("{} columns fit --assignment \"{}\"; expected one of: {}", found.size(),
                    escapeLine(std::string{assignment}), escapeLine(known)));
}

class Gradebook {
public:
    Gradebook(CsvFile file, const std::string& name, std::string_view assignment)
        : file_(std::move(file)),
          student_(columnOf(file_, name, "Student")),
          id_(columnOf(file_, name, "ID")),
          grade_(assignmentColumn(file_, name, assignment)) {
        for (std::size_t row = 1; row < file_.rows(); ++row)
            if (trimmed(file_.value(row, student_)) == kPointsRow)
                points_ = raytracer::parseNumber(trimmed(file_.value(row, grade_)));
    }

    CanvasGrades fill(const std::vector<StudentView>& views) {
        const auto byId = viewsById(views);
        std::set<std::size_t> used;
        for (std::size_t row = 1; row < file_.rows(); ++row) {
            const auto found = byId.find(std::string{trimmed(file_.value(row, id_))});
            if (found == byId.end()) continue;
            used.insert(found->second.begin(), found->second.end());
            if (found->second.size() == 1)
                grade(row, found->second.front(), views[found->second.front()].result());
            else
                for (const std::size_t view : found->second)
                    remark(views[view].result(), kSharedId);
        }
        for (std::size_t i = 0; i < views.size(); ++i)
            if (!used.contains(i)) remark(views[i].result(), "no row of the gradebook fits");
        grades_.gradebook = file_.text();
        return std::move(grades_);
    }

private:
    void remark(const SubmissionResult& result, std::string_view why) {
        grades_.remarks.push_back(fmt::format("{}: {}", escapeLine(result.submission), why));
    }

    void grade(std::size_t row, std::size_t view, const SubmissionResult& result) {
        if (result.verdict == Verdict::needsReview)
            return remark(result, "left as it is, a person has to decide");
        if (result.verdict == Verdict::notGraded)
            return remark(result, "left as it is, it was not graded");
        if (trimmed(file_.value(row, grade_)) == "EX")
            return remark(result, "left as it is, Canvas has it as excused");
        const double share = result.maxScore > 0.0 ? result.score / result.maxScore : 0.0;
        file_.set(row, grade_, fmt::format("{:.2f}", share * points_.value_or(result.maxScore)));
        grades_.graded.push_back(view);
    }

    CsvFile file_;
    std::size_t student_;
    std::size_t id_;
    std::size_t grade_;
    std::optional<double> points_;  ///< empty: the gradebook does not say
    CanvasGrades grades_;
};

}  // namespace

CanvasGrades fillCanvasGradebook(std::string_view gradebook, const std::string& name,
                                 std::string_view assignment,
                                 const std::vector<StudentView>& views) {
    return Gradebook{CsvFile{gradebook, name}, name, assignment}.fill(views);
}

std::string commentedSource(const StudentView& view, std::string_view source) {
    std::string text = wholeText(view);
    for (std::size_t end = text.find("*/"); end != std::string::npos; end = text.find("*/", end))
        text.insert(end + 1, " ");
    return "/*\n" + text + (text.ends_with('\n') ? "" : "\n") + "*/\n" + std::string{source};
}

}  // namespace ticker::report

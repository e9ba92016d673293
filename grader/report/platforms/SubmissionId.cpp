#include <grader/report/platforms/SubmissionId.h>

#include <cstddef>

namespace ticker::report {

std::string digitsAtEnd(std::string_view text) {
    const std::size_t last = text.find_last_not_of("0123456789");
    return std::string{last == std::string_view::npos ? text : text.substr(last + 1)};
}

std::string idOf(std::string_view submission) {
    const std::string digits = digitsAtEnd(submission);
    const std::size_t mark = submission.size() - digits.size();
    return !digits.empty() && mark > 0 && submission[mark - 1] == '_' ? digits : "";
}

}  // namespace ticker::report

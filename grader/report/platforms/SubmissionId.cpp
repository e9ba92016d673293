#include <grader/report/platforms/SubmissionId.h>

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

std::map<std::string, std::vector<std::size_t>> viewsById(const std::vector<StudentView>& views) {
    std::map<std::string, std::vector<std::size_t>> byId;
    for (std::size_t i = 0; i < views.size(); ++i)
        if (const std::string id = idOf(views[i].result().submission); !id.empty())
            byId[id].push_back(i);
    return byId;
}

}  // namespace ticker::report

#include <grader/intake/Submission.h>

namespace ticker::intake {

const std::optional<std::string>& Submission::part(std::string_view which) const {
    static const std::optional<std::string> kMissing;
    const auto found = parts.find(which);
    return found == parts.end() ? kMissing : found->second;
}

const Finding* Submission::refusalOf(std::string_view which) const {
    for (const IntakeFinding& entry : findings)
        if (entry.finding.severity == Severity::fail && (!entry.part || *entry.part == which))
            return &entry.finding;
    return nullptr;
}

}  // namespace ticker::intake

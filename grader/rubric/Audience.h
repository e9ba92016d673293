#ifndef TICKER_RUBRIC_AUDIENCE_H
#define TICKER_RUBRIC_AUDIENCE_H

#include <grader/result/SubmissionResult.h>

#include <filesystem>
#include <map>
#include <string>

namespace ticker::rubric {

/// How much of a finding somebody sees.
enum class Detail {
    hidden,   ///< nothing
    message,  ///< what was expected and what was seen
    hint      ///< also where to look, and what the handout says
};

/// What one kind of reader sees of a result, as data; see audiences.json.
struct Audience {
    bool verdict = true;                      ///< whether the task's outcome is summed up
    std::map<Severity, Detail> bySeverity;    ///< one entry for each severity
    std::map<std::string, Detail> byFinding;  ///< finding id -> detail, where it differs
};

/// Reads one audience of a policy file.
/// @throws raytracer::InputError naming the file, the member and what was expected.
[[nodiscard]] Audience readAudience(const std::filesystem::path& file, const std::string& name);

/// The result as the audience sees it: findings, hints and the evidence behind them are left out as
/// the policy says. States stay as they are.
[[nodiscard]] SubmissionResult shownTo(const Audience& audience, SubmissionResult result);

}  // namespace ticker::rubric

#endif

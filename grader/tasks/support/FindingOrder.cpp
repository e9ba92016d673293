#include <grader/tasks/support/FindingOrder.h>

#include <algorithm>
#include <utility>

namespace ticker::tasks {
namespace {

using Order = std::span<const FindingText* const>;

std::size_t rankOf(const Finding& finding, Order order) {
    const auto at =
        std::ranges::find_if(order, [&](const FindingText* text) { return is(finding, *text); });
    return static_cast<std::size_t>(at - order.begin());
}

}  // namespace

Finding distributedFinding(const FindingText& text, Severity severity, std::string seen) {
    Finding finding;
    finding.id = text.id;
    finding.severity = severity;
    finding.message = std::move(seen);
    finding.hint = text.hint;
    finding.section = text.section;
    return finding;
}

bool hasFailure(const std::vector<Finding>& findings) {
    return std::ranges::find(findings, Severity::fail, &Finding::severity) != findings.end();
}

std::vector<Finding> mostImportantFirst(std::vector<Finding> findings, Order order) {
    std::stable_sort(findings.begin(), findings.end(), [&](const Finding& a, const Finding& b) {
        if (a.severity != b.severity) return a.severity < b.severity;
        return rankOf(a, order) < rankOf(b, order);
    });
    std::vector<Finding> kept;
    std::string others;
    for (Finding& finding : findings) {
        const bool failed = !kept.empty() && kept.front().severity == Severity::fail;
        if (failed && finding.severity == Severity::fail) {
            if (others.find(finding.id) == std::string::npos)
                others += (others.empty() ? "" : ", ") + finding.id;
        } else {
            kept.push_back(std::move(finding));
        }
    }
    if (!others.empty()) kept.front().evidence.emplace_back("alsoSeen", others);
    return kept;
}

TaskJudgement judgementOf(std::vector<Finding> findings, std::span<const FindingText* const> order,
                          bool needsReview) {
    TaskJudgement judgement;
    judgement.findings = mostImportantFirst(std::move(findings), order);
    const bool failed = hasFailure(judgement.findings);
    judgement.state = failed ? TaskState::failed : TaskState::passed;
    judgement.needsReview = needsReview && !failed;
    return judgement;
}

Finding unseenRays(const FindingText& text, const std::string& what) {
    Finding finding = distributedFinding(
        text, Severity::note, what + ": what it computes is judged by its results alone.");
    return finding;
}

}  // namespace ticker::tasks

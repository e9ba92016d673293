#ifndef TICKER_TASKS_SUPPORT_CHECKS_H
#define TICKER_TASKS_SUPPORT_CHECKS_H

#include <grader/tasks/support/FindingOrder.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ticker::tasks {

/// States that one finding is only the consequence of another: if the check found `found` (null:
/// any finding), `hidden` is left out (null: all checks after it in the list are skipped).
struct Hides {
    const FindingText* found = nullptr;
    const FindingText* hidden = nullptr;
};

/// A check looks at one property and returns a finding if it is wrong. Its function identifies it.
/// @tparam Seen  What the answers show; a check may store there what later checks need.
template <class Seen>
struct Check {
    using Run = std::optional<Finding> (*)(Seen&);
    /// States that `check` returned `finding` (null: any finding).
    struct Found {
        Run check;
        const FindingText* finding = nullptr;
    };

    Run run;
    std::vector<Found> after = {};  ///< skipped if one of these was found before
    bool ifNothingFails = false;    ///< skipped if an earlier check failed
    std::vector<Hides> hides = {};
};

[[nodiscard]] inline bool fits(const FindingText* text, const Finding& finding) {
    return text == nullptr || is(finding, *text);
}

/// Runs the checks in the order of their list.
/// @return  Their findings, without those that are hidden.
template <class Seen>
[[nodiscard]] std::vector<Finding> runChecks(std::span<const Check<Seen>> checks, Seen& seen) {
    std::vector<std::pair<const Check<Seen>*, Finding>> found;
    const auto wasFound = [&](const typename Check<Seen>::Found& wanted) {
        return std::ranges::any_of(found, [&](const auto& one) {
            return one.first->run == wanted.check && fits(wanted.finding, one.second);
        });
    };
    const auto fails = [](const auto& one) { return one.second.severity == Severity::fail; };
    for (const Check<Seen>& check : checks) {
        if (check.ifNothingFails && std::ranges::any_of(found, fails)) continue;
        if (std::ranges::any_of(check.after, wasFound)) continue;
        std::optional<Finding> finding = check.run(seen);
        if (!finding) continue;
        found.emplace_back(&check, *std::move(finding));
        const Finding& last = found.back().second;
        if (std::ranges::any_of(check.hides, [&](const Hides& hides) {
                return hides.hidden == nullptr && fits(hides.found, last);
            }))
            break;
    }
    const auto isHidden = [&](const Finding& finding) {
        return std::ranges::any_of(found, [&](const auto& one) {
            return std::ranges::any_of(one.first->hides, [&](const Hides& hides) {
                return hides.hidden != nullptr && is(finding, *hides.hidden) &&
                       fits(hides.found, one.second);
            });
        });
    };
    std::vector<Finding> kept;
    for (const auto& one : found)
        if (!isHidden(one.second)) kept.push_back(one.second);
    return kept;
}

}  // namespace ticker::tasks

#endif

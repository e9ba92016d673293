#ifndef TICKER_RESULT_FINDINGTEXT_H
#define TICKER_RESULT_FINDINGTEXT_H

#include <grader/result/Finding.h>

#include <string_view>

namespace ticker {

/// A row in a task's table of findings. Code names this constant instead of the id. Ids are stable:
/// new ones may be added, existing ones are never renamed.
struct FindingText {
    std::string_view id;            ///< "shadow.hard"
    std::string_view words;         ///< continue "14 of 60 ..."
    std::string_view meaning;       ///< for docs/findings.md
    std::string_view hint = {};     ///< what to change; empty: the check has its own hint
    std::string_view section = {};  ///< section of the handout
};

/// Whether `finding` has the id of `text`.
[[nodiscard]] inline bool is(const Finding& finding, const FindingText& text) {
    return finding.id == text.id;
}

}  // namespace ticker

#endif

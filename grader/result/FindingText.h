#ifndef TICKER_RESULT_FINDINGTEXT_H
#define TICKER_RESULT_FINDINGTEXT_H

#include <grader/result/Finding.h>

#include <string_view>

namespace ticker {

/// A finding as it stands once, in the table of its task: a constant that the code names instead of
/// the id. Ids are stable: new ones may come, none is renamed.
struct FindingText {
    std::string_view id;            ///< "shadow.hard"
    std::string_view words;         ///< go on "14 of 60 ..."
    std::string_view meaning;       ///< for docs/findings.md
    std::string_view hint = {};     ///< what to change; empty: the check says its own
    std::string_view section = {};  ///< of the handout
};

/// Whether `finding` is one of `text`'s kind.
[[nodiscard]] inline bool is(const Finding& finding, const FindingText& text) {
    return finding.id == text.id;
}

}  // namespace ticker

#endif

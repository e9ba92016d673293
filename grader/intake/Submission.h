#ifndef TICKER_INTAKE_SUBMISSION_H
#define TICKER_INTAKE_SUBMISSION_H

#include <grader/result/Finding.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::intake {

/// A finding of intake about one part of `Exercise::parts`.
struct IntakeFinding {
    std::optional<std::string> part;  ///< empty: about the submission as a whole
    Finding finding;
};

/// A submission: original bytes and nothing else. A part that is missing, refused or ambiguous is
/// empty; `findings` says why.
struct Submission {
    std::string name;
    std::map<std::string, std::optional<std::string>, std::less<>> parts;  ///< bytes, by name
    std::vector<std::string> ignored;     ///< paths of everything else; untrusted, one line each
    std::vector<IntakeFinding> findings;  ///< intake.*
    std::string otherExercise = {};       ///< whose files it brings instead; empty: none

    /// Bytes of the part; empty if it is missing.
    [[nodiscard]] const std::optional<std::string>& part(std::string_view which) const;
    /// A finding that prevents grading of this part, or of the whole submission; null if there is
    /// no such finding.
    [[nodiscard]] const Finding* refusalOf(std::string_view which) const;
};

}  // namespace ticker::intake

#endif

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

/// Something that intake has to say about one part: one of `Exercise::parts`, by its name.
struct IntakeFinding {
    std::optional<std::string> part;  ///< empty: about the submission as a whole
    Finding finding;
};

/// What somebody handed in: original bytes and nothing else. A part that is missing, refused or
/// ambiguous is empty; `findings` says why.
struct Submission {
    std::string name;
    std::map<std::string, std::optional<std::string>, std::less<>> parts;  ///< bytes, by name
    std::vector<std::string> ignored;     ///< paths of everything else; untrusted, one line each
    std::vector<IntakeFinding> findings;  ///< intake.*

    /// Its bytes; empty where it is missing.
    [[nodiscard]] const std::optional<std::string>& part(std::string_view which) const;
    /// A finding that keeps this part, or the whole submission, from being graded; null: none.
    [[nodiscard]] const Finding* refusalOf(std::string_view which) const;
};

}  // namespace ticker::intake

#endif

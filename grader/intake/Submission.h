#ifndef TICKER_INTAKE_SUBMISSION_H
#define TICKER_INTAKE_SUBMISSION_H

#include <grader/result/Finding.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ticker::intake {

/// The three files that make up a submission.
enum class Part { bumpySphere, renderer, screenshot };

inline constexpr std::array kParts{Part::bumpySphere, Part::renderer, Part::screenshot};

/// "BumpySphere.cpp", "Renderer.cpp" or "screenshot.png".
[[nodiscard]] std::string nameOf(Part part);

/// Something that intake has to say about one part.
struct IntakeFinding {
    std::optional<Part> part;  ///< empty: about the submission as a whole
    Finding finding;
};

/// What somebody handed in: original bytes and nothing else. A part that is missing, refused or
/// ambiguous is empty; `findings` says why.
struct Submission {
    std::string name;
    std::array<std::optional<std::string>, kParts.size()> parts;  ///< bytes, indexed by Part
    std::vector<std::string> ignored;     ///< paths of everything else; untrusted, one line each
    std::vector<IntakeFinding> findings;  ///< intake.*

    [[nodiscard]] const std::optional<std::string>& part(Part which) const {
        return parts[static_cast<std::size_t>(which)];
    }
    /// A finding that keeps this part, or the whole submission, from being graded; null: none.
    [[nodiscard]] const Finding* refusalOf(Part which) const;
};

}  // namespace ticker::intake

#endif

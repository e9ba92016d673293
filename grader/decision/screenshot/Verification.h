#ifndef TICKER_DECISION_SCREENSHOT_VERIFICATION_H
#define TICKER_DECISION_SCREENSHOT_VERIFICATION_H

#include <grader/decision/screenshot/Agreement.h>
#include <grader/decision/screenshot/Edits.h>
#include <grader/decision/screenshot/Scene.h>

#include <cstdint>
#include <optional>
#include <string>

namespace ticker::decision::screenshot {

/// What the code's windows say.
struct Verification {
    enum class Kind {
        same,
        different,
        unknown,  ///< `why`; empty: there is no code to ask
        ourFault  ///< it could not be asked; `why`
    };
    Kind kind = Kind::unknown;
    std::string why;
    Agreement agreement;
    std::optional<OwnWindows> own;  ///< where the picture differed, if it did anywhere
};

/// Asks the scene's code for a few windows of the picture, and for others where they differ.
[[nodiscard]] Verification verify(const ByteView& picture, const Scene& scene, std::uint64_t seed);

}  // namespace ticker::decision::screenshot

#endif

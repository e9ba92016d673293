#ifndef TICKER_TASKS_SCREENSHOT_VERIFICATION_H
#define TICKER_TASKS_SCREENSHOT_VERIFICATION_H

#include <grader/tasks/screenshot/Agreement.h>
#include <grader/tasks/screenshot/Edits.h>
#include <grader/tasks/screenshot/Scene.h>

#include <cstdint>
#include <optional>
#include <string>

namespace ticker::tasks::screenshot {

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

}  // namespace ticker::tasks::screenshot

#endif

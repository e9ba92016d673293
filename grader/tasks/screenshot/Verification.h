#ifndef TICKER_TASKS_SCREENSHOT_VERIFICATION_H
#define TICKER_TASKS_SCREENSHOT_VERIFICATION_H

#include <grader/tasks/screenshot/Agreement.h>
#include <grader/tasks/screenshot/Edits.h>
#include <grader/tasks/screenshot/ShownScene.h>

#include <cstdint>
#include <optional>
#include <string>

namespace ticker::tasks::screenshot {

/// Result of comparing the picture with the code's windows.
struct Verification {
    enum class Kind {
        same,
        different,
        unknown,  ///< see `why`; empty: there is no code to ask
        ourFault  ///< the code could not be asked; see `why`
    };
    Kind kind = Kind::unknown;
    std::string why;
    Agreement agreement;
    /// The windows that were compared last. After a difference that did not repeat, `kind` is
    /// `same` and these are the first windows, which differ.
    std::optional<OwnWindows> own;
};

/// Asks the scene's code for a few windows of the picture, and for other windows if they differ.
[[nodiscard]] Verification verify(const ByteView& picture, const Scene& scene, std::uint64_t seed);

}  // namespace ticker::tasks::screenshot

#endif

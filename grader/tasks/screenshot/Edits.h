#ifndef TICKER_TASKS_SCREENSHOT_EDITS_H
#define TICKER_TASKS_SCREENSHOT_EDITS_H

#include <grader/metrics/Alignment.h>
#include <grader/tasks/screenshot/ShownScene.h>
#include <grader/tasks/screenshot/Windows.h>

#include <optional>
#include <string>

namespace ticker::tasks::screenshot {

// Changes made to a picture after it was rendered. Each function looks for one kind of change, and
// returns empty when in doubt.

/// This submission's render of some windows.
struct OwnWindows {
    Windows windows;
    Picture pixels;
    bool isRandom = false;
};

/// Number of windows that agree, each judged by itself.
[[nodiscard]] int agreeingWindows(const ByteView& picture, const OwnWindows& own);

/// Displacement of a picture, pixels.
struct Shift {
    int right = 0;
    int down = 0;
};
/// The shift of up to 3 pixels under which the picture's windows agree with the code's; empty if
/// there is no such shift.
[[nodiscard]] std::optional<Shift> findShift(const ByteView& picture, const OwnWindows& own);

/// The mirroring that turns the picture back into one of the scene.
/// @param own  Null: only the scene's coarse look is compared.
[[nodiscard]] std::optional<metrics::Mirror> findMirror(const ByteView& picture, const Scene& scene,
                                                        const OwnWindows* own);

/// A change of colours.
struct Recolouring {
    double distance = 0.0;  ///< root mean square over the picture, steps of a byte
    std::string words;      ///< a clause: "it is a negative", "it has no colours"
    /// Up to this distance colours "may differ slightly", as the handout says.
    static constexpr double kSlight = 8.0;
    [[nodiscard]] bool isSlight() const { return distance <= kSlight; }
};
/// The change of colours that explains most of the difference from the scene; empty if none does.
[[nodiscard]] std::optional<Recolouring> findRecolouring(const ByteView& picture,
                                                         const Scene& scene);

/// The scene as a part of the picture, or the picture as a part of the scene.
struct Cut {
    enum class Kind {
        framed,     ///< something surrounds the scene
        cropped,    ///< a part of the scene is missing
        otherShape  ///< rendered in another shape than 4 : 3
    };
    Kind kind = Kind::framed;
    metrics::Fit fit;    ///< of the inner picture in the outer one, in pixels of a small picture
    double share = 0.0;  ///< of the outer's area
};
/// For pictures of any shape.
[[nodiscard]] std::optional<Cut> findCut(const ByteView& picture, const Scene& scene);

}  // namespace ticker::tasks::screenshot

#endif

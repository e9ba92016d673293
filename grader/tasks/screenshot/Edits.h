#ifndef TICKER_TASKS_SCREENSHOT_EDITS_H
#define TICKER_TASKS_SCREENSHOT_EDITS_H

#include <grader/metrics/Alignment.h>
#include <grader/tasks/screenshot/Scene.h>
#include <grader/tasks/screenshot/Windows.h>

#include <optional>
#include <string>

namespace ticker::tasks::screenshot {

// What may have been done to a picture of a scene after it was rendered. Each of these functions
// looks for one thing and says nothing where it is in doubt.

/// What this submission renders in some windows.
struct OwnWindows {
    Windows windows;
    Picture pixels;
    bool isRandom = false;
};

/// How many of the windows agree, each by itself.
[[nodiscard]] int agreeingWindows(const ByteView& picture, const OwnWindows& own);

/// By how many pixels the picture lies off.
struct Shift {
    int right = 0;
    int down = 0;
};
/// The shift by which the picture's windows are what the code renders; none of up to 3 pixels:
/// empty.
[[nodiscard]] std::optional<Shift> findShift(const ByteView& picture, const OwnWindows& own);

/// The mirror that makes the picture one of the scene again.
/// @param own  Null: only what the scene looks like from far away is known.
[[nodiscard]] std::optional<metrics::Mirror> findMirror(const ByteView& picture, const Scene& scene,
                                                        const OwnWindows* own);

/// A change of colours.
struct Recolouring {
    double distance = 0.0;  ///< root mean square over the picture, steps of a byte
    std::string words;      ///< "grey", "a negative", "other colours"
    /// Below this, colours "may differ slightly", as the handout says.
    static constexpr double kSlight = 8.0;
    [[nodiscard]] bool isSlight() const { return distance <= kSlight; }
};
[[nodiscard]] std::optional<Recolouring> findRecolouring(const ByteView& picture,
                                                         const Scene& scene);

/// The scene as a part of a picture, or the picture as a part of the scene.
struct Cut {
    enum class Kind {
        framed,     ///< something stands around the scene
        cropped,    ///< a part of the scene is missing
        otherShape  ///< rendered at another shape than 4 : 3
    };
    Kind kind = Kind::framed;
    metrics::Fit fit;    ///< of the inner in the outer, in pixels of a small picture
    double share = 0.0;  ///< of the outer's area
};
/// For pictures of any shape.
[[nodiscard]] std::optional<Cut> findCut(const ByteView& picture, const Scene& scene);

}  // namespace ticker::tasks::screenshot

#endif

#ifndef TICKER_TASKS_SCREENSHOT_SHOWNSCENE_H
#define TICKER_TASKS_SCREENSHOT_SHOWNSCENE_H

#include <grader/metrics/PictureView.h>
#include <grader/probe/Examinee.h>

#include <raytracer/scene/SceneDescription.h>

#include <functional>
#include <string>

namespace ticker::tasks::screenshot {

using metrics::ByteView;
using metrics::Picture;

/// A scene of the handout and its expected look. Pictures have the handout's shape, 4 : 3, and any
/// size.
struct Scene {
    std::string name;         ///< of scenes/NAME.xml
    std::string file;         ///< the file whose tasks it shows
    bool isRandom = false;    ///< two right renders differ by noise
    bool isWanted = true;     ///< an attempted option asks for a screenshot of it
    bool mayMixBoth = false;  ///< the student may have rendered it with both files, and we with one
    const raytracer::SceneDescription* description = nullptr;
    std::function<ByteView()> expected;  ///< its expected look, computed on demand
    ByteView own;  ///< this submission's render; empty if it has not rendered the scene
    probe::Examinee* examinee = nullptr;  ///< this submission's code; null if it cannot be asked
    /// Why this code's pictures may differ from each other; empty if no reason is known.
    std::string whyUnlikeItself;

    [[nodiscard]] bool hasOwn() const { return !own.rgb.empty(); }
    /// The best known estimate of the student's picture.
    [[nodiscard]] ByteView likeliest() const { return hasOwn() ? own : expected(); }
};

}  // namespace ticker::tasks::screenshot

#endif

#ifndef TICKER_TASKS_SCREENSHOT_SCENE_H
#define TICKER_TASKS_SCREENSHOT_SCENE_H

#include <grader/metrics/View.h>
#include <grader/probe/Examinee.h>

#include <raytracer/scene/SceneDescription.h>

#include <functional>
#include <string>

namespace ticker::tasks::screenshot {

using metrics::ByteView;
using metrics::Picture;

/// A scene of the handout, and what is known of how it looks. Pictures have the handout's shape,
/// 4 : 3, and any size.
struct Scene {
    std::string name;         ///< of scenes/NAME.xml
    std::string file;         ///< whose tasks it shows
    bool isRandom = false;    ///< two right renders differ by noise
    bool isWanted = true;     ///< a screenshot of it is what an attempted option asks for
    bool mayMixBoth = false;  ///< the student may have rendered it with both files, we with one
    const raytracer::SceneDescription* description = nullptr;
    std::function<ByteView()> expected;  ///< as it should look; worked out when asked
    ByteView own;  ///< as this submission's code renders it; no bytes where it did not
    probe::Examinee* examinee = nullptr;  ///< this submission's code; null where it is no use
    /// What is known of this code that makes its pictures differ from one to the next; words, or
    /// empty.
    std::string whyUnlikeItself;

    [[nodiscard]] bool hasOwn() const { return !own.rgb.empty(); }
    /// The best that is known of what this student's picture should show.
    [[nodiscard]] ByteView likeliest() const { return hasOwn() ? own : expected(); }
};

}  // namespace ticker::tasks::screenshot

#endif

#ifndef TICKER_MISTAKES_CATALOGUE_H
#define TICKER_MISTAKES_CATALOGUE_H

#include <grader/result/SubmissionResult.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::mistakes {

/// One replacement in the reference's text.
struct Edit {
    std::string find;  ///< must stand exactly once in the text, as earlier edits left it
    std::string replace;
};

/// What a grader must say about a mistake.
struct Expectation {
    TaskState state = TaskState::failed;
    std::string finding;       ///< the first finding's id; empty where there is none (notAttempted)
    bool needsReview = false;  ///< it passes, and a person has to look
};

/// A known mistake: a small edit of the reference solution, and what it must be called.
struct Mistake {
    std::string id;     ///< the name of its file, without ".json"
    std::string task;   ///< "T1", "T2.1" or "T2.2": the name of its folder
    std::string file;   ///< in reference_solution/exercise: "BumpySphere.cpp" or "Renderer.cpp"
    std::string title;  ///< what the student did, in a few words
    std::vector<Edit> edits;
    Expectation expect;
    std::string path;  ///< where it was read, for messages
};

/// Reads every `accepted/<task>/<id>.json` and `mistakes/<task>/<id>.json` under `folder`, sorted by
/// task and id. mistakes/README.md has the format.
/// @throws raytracer::InputError naming file, line where known, and what was expected.
[[nodiscard]] std::vector<Mistake> readCatalogue(const std::filesystem::path& folder);

/// The reference's text with the mistake made in it.
/// @throws raytracer::InputError where an edit's `find` does not stand exactly once in the text.
[[nodiscard]] std::string makeMistake(const Mistake& mistake, const std::string& reference);

}  // namespace ticker::mistakes

#endif

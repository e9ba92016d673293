#ifndef TICKER_RESULT_SUBMISSIONRESULT_H
#define TICKER_RESULT_SUBMISSIONRESULT_H

#include <grader/result/Finding.h>
#include <grader/result/Inputs.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker {

/// How far a task came (docs/decisions/0004).
enum class TaskState {
    passed,
    failed,
    notAttempted,  ///< the stub still stands
    blocked,       ///< did not compile, crashed, timed out: the reason says which
    notGraded      ///< our fault; never a score
};

/// What is known about one task. A judge says passed, failed, blocked (crashed, timed out) or
/// notGraded; notAttempted and build failures are known before anything is asked.
struct TaskJudgement {
    TaskState state = TaskState::notGraded;
    std::string reason;                   ///< one sentence; empty where the findings say it all
    std::vector<Finding> findings;        ///< the most important first
    bool needsReview = false;             ///< the state is the best guess, but a person should look
    std::vector<ScatterPlot> plots = {};  ///< what was seen, where no finding shows it
    std::vector<Raster> rasters = {};     ///< likewise
    /// Half-width / dofAmount of the accepted aperture that the answers show; stands in no file.
    std::optional<double> apertureFactor = {};
};

/// The judgement of one task of the exercise, or of the "screenshot".
struct TaskReport : TaskJudgement {
    std::string id;
    std::string title;
};

/// How the reason of a task begins that is blocked because nothing could be compared.
inline constexpr std::string_view kNotChecked = "not checked: ";

/// True where nothing was compared, which speaks neither for nor against the submission.
[[nodiscard]] inline bool isNotChecked(const TaskReport& task) {
    return task.state == TaskState::blocked && task.reason.starts_with(kNotChecked);
}

/// What a result calls the option of a submission that worked on more than one.
inline constexpr std::string_view kSeveralOptions = "both";

/// One way to earn the tick: all of its tasks must pass.
struct Option {
    std::string name;
    std::vector<std::string> tasks;
    double points = 0.0;
};

enum class Verdict { awarded, notAwarded, needsReview, notGraded };

/// One picture that the submission rendered, and how it compares.
struct RenderScore {
    std::string scene;  ///< its name
    int width = 0;
    int height = 0;
    double flip = 0.0;
    double ssim = 0.0;
    double gmsd = 0.0;
    double zMax = 0.0;
    double rmse = 0.0;
    std::string image;      ///< path under the result's folder; empty where there is none
    std::string reference;  ///< likewise: what was expected
    std::string errorMap;   ///< likewise: where the two look different
    std::string zMap = {};  ///< likewise: where it is too dark or too bright for noise
};

/// A picture that belongs to a result, as a file below `OUT/<submission>/`.
struct ResultPicture {
    std::string file;     ///< "images/expected-SCENE.png"
    std::string caption;  ///< for its alternative text
    std::string png;      ///< the file's bytes; empty in a result that was read back
};

/// What the compiler said about one of the student's files, made safe to read but not to embed:
/// it still has to be escaped.
struct Diagnostics {
    std::string file;  ///< its name; its lines are among SubmissionResult::sources
    std::string text;  ///< capped; paths relative
};

/// A source as it was handed in, for people to read: a file below `OUT/<submission>/code/`.
struct SourceText {
    std::string file;   ///< its name
    std::string bytes;  ///< untrusted; may not be valid UTF-8; empty in a result that was read back
};

struct Timing {
    double compileMs = 0.0;
    double probeMs = 0.0;
    double totalMs = 0.0;
};

/// Everything that is known about one submission: what result.json holds.
struct SubmissionResult {
    static constexpr int kSchemaVersion = 1;

    std::string submission;  ///< its name, as a folder under OUT
    Verdict verdict = Verdict::notGraded;
    double score = 0.0;
    double maxScore = 1.0;
    std::string option = "none";  ///< the one worked on, by its name; `kSeveralOptions`; "none"
    std::vector<Option> options;  ///< the rubric's; empty in results of older tools
    std::uint64_t seed = 0;
    std::string sandboxLevel = "none";
    std::string toolVersion;
    Inputs inputs;
    std::vector<TaskReport> tasks;
    std::vector<RenderScore> renders;
    std::vector<ResultPicture> pictures;
    std::vector<Diagnostics> diagnostics;
    std::vector<SourceText> sources;
    std::vector<std::string> notices;
    Timing timing;
};

}  // namespace ticker

#endif

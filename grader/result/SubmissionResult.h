#ifndef TICKER_RESULT_SUBMISSIONRESULT_H
#define TICKER_RESULT_SUBMISSIONRESULT_H

#include <grader/result/Finding.h>
#include <grader/result/Repair.h>
#include <grader/result/ResultInputs.h>

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
    notAttempted,  ///< the stub is unchanged
    blocked,       ///< did not compile, crashed, timed out: the reason says which
    notGraded      ///< an error of the grader; never a score
};

/// Result of one task. A judge returns passed, failed, blocked (crashed, timed out) or notGraded;
/// notAttempted and build failures are known before any question.
struct TaskJudgement {
    TaskState state = TaskState::notGraded;
    std::string reason;             ///< one sentence; empty if the findings are sufficient
    std::vector<Finding> findings;  ///< the most important first
    bool needsReview = false;       ///< the state is the best estimate, but a ticker should look
    std::vector<ScatterPlot> plots = {};  ///< observed points that no finding shows
    std::vector<Raster> rasters = {};     ///< pictures that no finding shows
    /// Half-width / dofAmount of the accepted aperture that the answers show; not written to any
    /// file.
    std::optional<double> apertureFactor = {};
};

/// The judgement of one task of the exercise, or of the "screenshot".
struct TaskReport : TaskJudgement {
    std::string id;
    std::string title;
};

/// Prefix of the reason of a task that is blocked because nothing could be compared.
inline constexpr std::string_view kNotChecked = "not checked: ";

/// True if nothing was compared, which speaks neither for nor against the submission.
[[nodiscard]] inline bool isNotChecked(const TaskReport& task) {
    return task.state == TaskState::blocked && task.reason.starts_with(kNotChecked);
}

/// Name of the option in the result of a submission that attempted more than one.
inline constexpr std::string_view kSeveralOptions = "both";

/// One way to earn the tick: all its tasks must pass.
struct Option {
    std::string name;
    std::vector<std::string> tasks;
    double points = 0.0;
};

enum class Verdict { awarded, notAwarded, needsReview, notGraded };

/// One picture that the submission rendered, compared with the expected one.
struct RenderScore {
    std::string scene;  ///< its name
    int width = 0;
    int height = 0;
    double flip = 0.0;
    double ssim = 0.0;
    double gmsd = 0.0;
    double zMax = 0.0;
    double rmse = 0.0;
    std::string image;      ///< path under the result's folder; empty if there is no image
    std::string reference;  ///< likewise: the expected picture
    std::string errorMap;   ///< likewise: map of visible differences
    /// Likewise: map of pixels that are darker or brighter than noise allows.
    std::string zMap = {};
};

/// A picture of a result: a file below `OUT/<submission>/`.
struct ResultPicture {
    std::string file;     ///< "images/expected-SCENE.png"
    std::string caption;  ///< alternative text
    std::string png;      ///< the file's bytes; empty in a result that was read back
};

/// The compiler's messages about one of the student's files. They are safe to read, but must be
/// escaped before they are embedded.
struct Diagnostics {
    std::string file;  ///< file name; its lines are in SubmissionResult::sources
    std::string text;  ///< limited in length; paths are relative
};

/// A submitted source for the report: a file below `OUT/<submission>/code/`.
struct SourceText {
    std::string file;   ///< file name
    std::string bytes;  ///< untrusted; may not be valid UTF-8; empty in a result that was read back
};

struct Timing {
    double compileMs = 0.0;
    double probeMs = 0.0;
    double totalMs = 0.0;
};

/// Everything known about one submission: the contents of result.json.
struct SubmissionResult {
    static constexpr int kSchemaVersion = 1;

    std::string submission;  ///< name, and folder under OUT
    std::string exercise;    ///< name; empty in results of older tools
    Verdict verdict = Verdict::notGraded;
    double score = 0.0;
    double maxScore = 1.0;
    std::string option = "none";  ///< name of the attempted option; `kSeveralOptions`; "none"
    std::vector<Option> options;  ///< the rubric's; empty in results of older tools
    std::uint64_t seed = 0;
    std::string sandboxLevel = "none";
    std::string toolVersion;
    Inputs inputs;
    std::vector<TaskReport> tasks;
    std::vector<RenderScore> renders;
    /// Edits that are proven to mend failed tasks; nothing: they were not looked for.
    std::optional<std::vector<Repair>> repairs;
    std::vector<ResultPicture> pictures;
    std::vector<Diagnostics> diagnostics;
    std::vector<SourceText> sources;
    /// Bytes of screenshot.png as handed in. They are untrusted: no page may show or link them.
    /// Empty without a screenshot, and in a result that was read from a file.
    std::optional<std::string> screenshot;
    std::vector<std::string> notices;
    Timing timing;
};

}  // namespace ticker

#endif

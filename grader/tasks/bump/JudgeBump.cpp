#include <grader/result/GeneralFindings.h>
#include <grader/tasks/bump/JudgeBump.h>

#include <grader/tasks/bump/BumpFindings.h>
#include <grader/tasks/bump/BumpThreads.h>
#include <grader/tasks/bump/Examination.h>
#include <grader/tasks/bump/words/BumpWords.h>
#include <grader/tasks/bump/words/Diagnosis.h>
#include <grader/tasks/support/RunEnd.h>

#include <fmt/core.h>

#include <optional>
#include <utility>
#include <vector>

namespace ticker::tasks {
namespace {

using namespace bump;
using probe::ProcessEnd;

std::string_view messageOf(ProcessEnd::Kind kind) {
    switch (kind) {
        case ProcessEnd::Kind::crashed:
            return "The program crashed while it answered questions for normals";
        case ProcessEnd::Kind::exitedEarly:
            return "The program left before the last question";
        case ProcessEnd::Kind::timedOut:
            return "getNormalAt took too long: the time was up";
        case ProcessEnd::Kind::memory:
            return "The program needs more memory than it may have";
        case ProcessEnd::Kind::outputLimit:
            return "The program printed too much";
        case ProcessEnd::Kind::forbiddenCall:
            return "The program asked the system for something that a renderer does not need";
        case ProcessEnd::Kind::finished:
        case ProcessEnd::Kind::ourFault:
            break;
    }
    return "The program ended without answering every question";
}

/// The hints of other tasks, except where getNormalAt has causes of its own: no rays, no x and y.
BadEnd endOf(ProcessEnd::Kind kind) {
    BadEnd end = badEnd(kind);
    end.seen = messageOf(kind);
    if (kind == ProcessEnd::Kind::crashed)
        end.hint =
            "Run it in a debugger, or with sanitizers on. Look for an index beyond the end "
            "of an array or a vector, and for a function that calls itself without end.";
    if (kind == ProcessEnd::Kind::timedOut) end.hint = "Look for a loop that does not end.";
    if (kind == ProcessEnd::Kind::finished) end.hint = "Make sure that getNormalAt returns.";
    return end;
}

TaskJudgement blocked(const BadEnd& end, const std::string& detail) {
    Finding finding;
    finding.id = end.id;
    finding.message =
        fmt::format("{}{}.", end.seen, detail.empty() ? "" : fmt::format(" ({})", detail));
    finding.hint = end.hint;
    if (!detail.empty()) finding.evidence.emplace_back("detail", detail);
    return {TaskState::blocked, finding.message, {finding}, false};
}

/// The judgement if the process did not end properly; empty if it did.
std::optional<TaskJudgement> judgeEnd(const Answers& answers, const Conduct& conduct) {
    const ProcessEnd& end = answers.end();
    if (end.kind == ProcessEnd::Kind::ourFault)
        return TaskJudgement{TaskState::notGraded, end.detail, {}, false};
    if (end.kind == ProcessEnd::Kind::crashed && !conduct.missing)
        return blocked({kRunCrashed.id,
                        "All normals were answered; then the program crashed while it rendered "
                        "with one thread and with two",
                        kBumpThreadsMixed.hint},
                       end.detail);
    if (end.kind != ProcessEnd::Kind::finished || conduct.missing)
        return blocked(endOf(end.kind), end.detail);
    return std::nullopt;
}

/// Judgement of ramps of whole bytes; empty if the process ends badly.
std::optional<RampJudgement> askForCoarseRamps(probe::Examinee& examinee, std::uint64_t seed) {
    const CoarsePlan plan = planCoarse(seed);
    const Answers answers(plan.questionnaire, examinee.ask(plan.questionnaire.questions()));
    if (answers.end().kind != ProcessEnd::Kind::finished) return std::nullopt;
    return judgeRamps(plan.ramps.shape, readCoarse(plan, answers));
}

/// Asks the hint questions, which may help to explain a fault; empty if the process ends badly.
std::optional<Hints> askForHints(probe::Examinee& examinee, std::uint64_t seed) {
    const HintPlan plan = planHints(seed);
    const Answers answers(plan.questionnaire, examinee.ask(plan.questionnaire.questions()));
    if (answers.end().kind != ProcessEnd::Kind::finished) return std::nullopt;
    return readHints(plan, answers);
}

TaskJudgement failed(const Diagnosis& diagnosis, const Examination& examination,
                     const std::optional<Hints>& hints, const MainPlan& plan,
                     const Answers& answers) {
    Finding finding = describe(diagnosis, examination, hints);
    if (examination.ramps().response)
        finding.rasters =
            drawRelief(plan.letters, answers, examination.ramps().fit->parametrisation,
                       *examination.ramps().response);
    TaskJudgement judgement;
    judgement.state =
        diagnosis.faults.front() == Fault::threw ? TaskState::blocked : TaskState::failed;
    judgement.reason = finding.message;
    judgement.findings.push_back(std::move(finding));
    return judgement;
}

/// The judgement of code whose normals are right, but whose pictures change with a second thread.
TaskJudgement threadsMixed(std::size_t pixels) {
    Finding finding;
    finding.id = kBumpThreadsMixed.id;
    finding.message = fmt::format(
        "All normals are right when they are asked for one after the other. {} pictures of {} x {} "
        "pixels were rendered with one thread and with two, and forEachPixel has as many as the "
        "machine has cores: {} pixels differ.",
        kThreadedPictures, kThreadedWidth, kThreadedHeight, pixels);
    finding.hint = kBumpThreadsMixed.hint;
    finding.section = kBumpThreadsMixed.section;
    finding.evidence.emplace_back("pixels", static_cast<double>(pixels));
    return {TaskState::failed, finding.message, {finding}, false};
}

/// Adds the notes. A failure at points that a picture shows makes warnings about other points
/// superfluous.
void addNotes(TaskJudgement& judgement, std::vector<Finding> notes) {
    const bool failed = !judgement.findings.empty();
    for (Finding& note : notes)
        if (!failed || judgement.findings.front().id != note.id)
            judgement.findings.push_back(std::move(note));
}

}  // namespace

TaskJudgement judgeBump(probe::Examinee& examinee, std::uint64_t seed) {
    const MainPlan plan = planMain(seed);
    std::vector<probe::Question> questions = plan.questionnaire.questions();
    const std::size_t renders = questions.size();
    for (probe::Question& render : drawThreadedRenders(seed))
        questions.push_back(std::move(render));
    probe::Run run = examinee.ask(questions);
    const std::size_t mixed = pixelsThatThreadsChange(run, renders);
    const Answers answers(plan.questionnaire, std::move(run));
    Examination examination = examine(plan, answers);
    if (auto ended = judgeEnd(answers, examination.conduct)) return *std::move(ended);
    if (!examination.ramps().response)
        examination = examine(plan, answers, askForCoarseRamps(examinee, seed));

    TaskJudgement judgement{TaskState::passed, {}, {}, false};
    Diagnosis diagnosis = diagnose(examination);
    if (!diagnosis.faults.empty()) {
        const std::optional<Hints> hints = askForHints(examinee, seed);
        if (isTransposed(examination, hints)) diagnosis = {{Fault::swapped}, {}};
        judgement = failed(diagnosis, examination, hints, plan, answers);
    } else if (examination.ramps().response) {
        judgement.rasters =
            drawRelief(plan.letters, answers, examination.ramps().fit->parametrisation,
                       *examination.ramps().response);
        if (mixed > 0) judgement = threadsMixed(mixed);
    }
    addNotes(judgement, sideNotes(examination));
    return judgement;
}

}  // namespace ticker::tasks

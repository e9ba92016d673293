#include <grader/pipeline/FileWork.h>
#include <grader/result/GeneralFindings.h>

#include <grader/intake/TaskText.h>

#include <fmt/core.h>

#include <string_view>
#include <utility>

namespace ticker::pipeline {
namespace {

using build::BuildResult;
void closeAll(FileWork& work, TaskState state, const std::string& reason) {
    for (TaskReport& task : work.tasks) {
        if (!awaitsJudge(task)) continue;
        task.state = state;
        task.reason = reason;
    }
}

void blockAll(FileWork& work, const Finding& finding, bool needsReview) {
    for (TaskReport& task : work.tasks) {
        if (!awaitsJudge(task)) continue;
        task.state = TaskState::blocked;
        task.reason = finding.message;
        task.findings.push_back(finding);
        task.needsReview = needsReview;
    }
}

// Whether a person can settle the refusal by asking the student. Other refusals are final.
bool isForAPerson(const Finding& finding) {
    return is(finding, kIntakeAmbiguous) || is(finding, kIntakeMissingFile);
}

// The compiler's first error, or the assembler's, which begins with a capital.
std::string firstError(std::string_view diagnostics) {
    std::size_t at = diagnostics.find("error: ");
    if (at == std::string_view::npos) at = diagnostics.find("Error: ");
    if (at == std::string_view::npos) at = 0;
    const std::size_t begin = at == 0 ? 0 : diagnostics.rfind('\n', at) + 1;
    constexpr std::size_t kLongest = 200;
    const std::size_t end = diagnostics.find('\n', begin);
    std::string_view line = diagnostics.substr(begin, end - begin);
    if (line.size() <= kLongest) return std::string{line};
    std::size_t cut = kLongest;
    while (cut > 0 && (static_cast<unsigned char>(line[cut]) & 0xC0U) == 0x80U)
        --cut;
    return std::string{line.substr(0, cut)} + " ...";
}

// Messages of GCC and of Clang.
bool missesHeader(const std::string& error) {
    return error.find("No such file or directory") != std::string::npos ||
           error.find("file not found") != std::string::npos;
}

// Linker messages for an address above 32 bits: a program cannot be larger.
bool outgrowsAProgram(std::string_view diagnostics) {
    return diagnostics.find("relocation truncated to fit") != std::string_view::npos ||
           (diagnostics.find("relocation R_") != std::string_view::npos &&
            diagnostics.find("out of range") != std::string_view::npos);
}

// The required function that the linker reports as missing. If it is a class's first virtual
// function, the linker names the class's table instead.
const TaskEntry* missingFunction(std::string_view diagnostics, const Exercise& exercise) {
    for (const TaskEntry& task : exercise.tasks)
        for (const std::string& symbol : task.symbols)
            for (const char* before : {"undefined symbol: ", "undefined reference to `"})
                if (diagnostics.find(before + symbol) != std::string_view::npos) return &task;
    return nullptr;
}

Finding emptyFinding(const std::string& source, const std::string& name) {
    Finding finding;
    finding.id = kBuildFailed.id;
    finding.severity = Severity::fail;
    finding.message =
        source.empty()
            ? fmt::format("{} is empty.", name)
            : fmt::format("{} holds no code: nothing but white space or comments.", name);
    finding.hint = fmt::format(
        "Save your work in the editor, look into the file once more, and hand in the {} that has "
        "your solution in it.",
        name);
    return finding;
}

/// Message and hint for a file with errors.
void explainErrors(const std::string& diagnostics, const std::string& name,
                   const Exercise& exercise, Finding& finding) {
    if (outgrowsAProgram(diagnostics)) {
        finding.message = fmt::format(
            "{} makes a program that is too large: its global and static variables take 2 GB or "
            "more.",
            name);
        finding.hint = "Look for an array whose size is far beyond what it has to hold.";
    } else if (const TaskEntry* task = missingFunction(diagnostics, exercise)) {
        finding.message =
            fmt::format("{} defines no {}, or one with other arguments.", name, task->function);
        finding.hint = "Keep its first line, and the namespace around it, as in the stub.";
    } else {
        const std::string error = firstError(diagnostics);
        finding.message = fmt::format("{} does not compile: {}", name, error);
        finding.hint = missesHeader(error)
                           ? "The file is compiled alone: put what it needs into it, and include "
                             "the kit's headers as <raytracer/...>."
                           : "Build it with ./check, or with the first command of the README.";
    }
}

Finding buildFinding(const BuildResult& result, const std::string& name, const Exercise& exercise) {
    Finding finding;
    finding.severity = Severity::fail;
    switch (result.kind) {
        case BuildResult::Kind::limit:
            finding.id = kBuildLimit.id;
            finding.message = fmt::format(
                "{} takes the compiler more time, memory or output than it may use.", name);
            finding.hint = "Look for templates or macros that expand without end.";
            break;
        case BuildResult::Kind::forbidden:
            finding.id = kBuildForbidden.id;
            finding.message = fmt::format(
                "{} defines something that belongs to the framework, such as main.", name);
            finding.hint = "Keep your own functions in an unnamed namespace, and leave out main.";
            break;
        default:
            finding.id = kBuildFailed.id;
            explainErrors(result.diagnostics, name, exercise, finding);
    }
    return finding;
}

void buildFile(FileWork& work, const std::string& source, const std::string& file,
               const Grader& grader) {
    BuildResult result =
        build::buildProgram(grader.kit, grader.sandbox, grader.policy.compile, file, source);
    work.compileMs = result.wallMs;
    if (result.kind == BuildResult::Kind::built) {
        work.program = std::move(result.program);
        return;
    }
    if (result.kind == BuildResult::Kind::ourFault)
        return closeAll(work, TaskState::notGraded,
                        "the compiler could not be run: " + result.diagnostics);
    blockAll(work, buildFinding(result, file, *grader.exercise), false);
    work.diagnostics = Diagnostics{file, result.diagnostics};
}

}  // namespace

TaskReport blankReport(const std::string& task, const Exercise& exercise) {
    TaskReport report;
    report.id = task;
    if (const TaskEntry* entry = exercise.task(task)) report.title = entry->title;
    if (task == kScreenshotTask) report.title = "Screenshot";
    return report;
}

void settle(TaskReport& task, TaskJudgement judgement) {
    static_cast<TaskJudgement&>(task) = std::move(judgement);
}

Finding forbiddenCallFinding() {
    Finding finding;
    finding.id = kRunForbiddenCall.id;
    finding.severity = Severity::fail;
    finding.message =
        "It answered, but in another run, such as one for a picture, the program asked the system "
        "for something that a renderer does not need.";
    finding.hint = "No files, processes or network connections are needed here: leave them out.";
    return finding;
}

// `notGraded` without a reason marks a report that is not judged yet; every judgement has a reason.
bool awaitsJudge(const TaskReport& task) {
    return task.state == TaskState::notGraded && task.reason.empty();
}

FileWork prepareFile(const intake::Submission& submission, const std::string& file,
                     const Grader& grader) {
    FileWork work;
    for (const TaskEntry& task : grader.exercise->tasks)
        if (task.file == file) work.tasks.push_back(blankReport(task.id, *grader.exercise));
    if (!grader.option.empty() && !grader.exercise->isIn(grader.option, file)) {
        closeAll(work, TaskState::notAttempted, "another option was to be judged");
        return work;
    }
    if (const Finding* refusal = submission.refusalOf(file)) {
        blockAll(work, *refusal, isForAPerson(*refusal));
        return work;
    }
    const std::optional<std::string>& source = submission.part(file);
    if (!source) {
        closeAll(work, TaskState::notAttempted, fmt::format("there is no {}", file));
        return work;
    }
    if (!intake::holdsCode(*source)) {
        blockAll(work, emptyFinding(*source, file), false);
        return work;
    }
    const std::string stub = grader.kit.templateSource(file);
    bool anyOpen = false;
    for (TaskReport& task : work.tasks) {
        if (intake::isStub(*source, stub, task.id)) {
            task.state = TaskState::notAttempted;
            task.reason = "the stub still stands";
        }
        anyOpen = anyOpen || awaitsJudge(task);
    }
    if (anyOpen) buildFile(work, *source, file, grader);
    return work;
}

}  // namespace ticker::pipeline

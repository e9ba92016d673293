#include <grader/report/platforms/PlatformFormats.h>

#include <grader/report/Escape.h>

#include <fmt/core.h>

#include <regex>

namespace ticker::report {
namespace {

/// Text for one workflow command: a new line would begin another one, which GitHub obeys.
std::string escaped(std::string_view text, bool isProperty) {
    std::string safe;
    for (const char c : text) {
        const bool isSpecial =
            c == '%' || c == '\r' || c == '\n' || static_cast<unsigned char>(c) < 32;
        if (isSpecial || (isProperty && (c == ':' || c == ',')))
            safe += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        else
            safe += c;
    }
    return safe;
}

const char* commandFor(Severity severity) {
    switch (severity) {
        case Severity::fail:
            return "error";
        case Severity::warn:
            return "warning";
        case Severity::note:
            break;
    }
    return "notice";
}

std::string command(std::string_view name, std::string_view file, std::string_view line,
                    std::string_view title, std::string_view message) {
    return fmt::format("::{} file=exercise/{},line={},title={}::{}\n", name, escaped(file, true),
                       line, escaped(title, true), escaped(message, false));
}

/// What the compiler said, at the lines that it names.
std::string compilerCommands(const Diagnostics& diagnostics) {
    static const std::regex kRemark{
        R"(^[^:\n]*:(\d{1,6}):(?:\d+:)? (?:fatal )?error: ([^\n]{1,500}))", std::regex::multiline};
    constexpr int kMost = 5;  // later errors are mostly consequences
    std::string text;
    int count = 0;
    const std::string& said = diagnostics.text;
    for (std::sregex_iterator at{said.begin(), said.end(), kRemark};
         at != std::sregex_iterator{} && count < kMost; ++at, ++count)
        text += command("error", diagnostics.file, (*at)[1].str(), "The compiler", (*at)[2].str());
    return text;
}

}  // namespace

std::optional<std::string> gitHubAnnotations(const StudentView& view) {
    if (view.result().verdict == Verdict::notGraded) return std::nullopt;
    std::string text;
    for (const Diagnostics& diagnostics : view.result().diagnostics)
        text += compilerCommands(diagnostics);
    for (const TaskReport& task : view.result().tasks) {
        const std::string_view file = view.exercise().fileOf(task.id);
        if (file.empty()) continue;
        for (const Finding& finding : task.findings) {
            const std::string hint = finding.hint.empty() ? "" : "\nHint: " + finding.hint;
            text += command(commandFor(finding.severity), file, fmt::format("{{{}}}", task.id),
                            taskName(task), finding.message + hint);
        }
    }
    return text;
}

}  // namespace ticker::report

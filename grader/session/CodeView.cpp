#include <grader/session/CodeView.h>
#include <grader/session/Highlight.h>

#include <grader/report/Escape.h>
#include <grader/report/SourceLines.h>
#include <grader/result/ProvenLine.h>

#include <fmt/core.h>

#include <string_view>

namespace ticker::session {
namespace {

using report::escapeHtml;

constexpr std::string_view kLineStart = "<span class=\"line\">";
constexpr std::string_view kLineEnd = "</span>";

/// One line of `highlightCpp` with its number and its remarks.
std::string numbered(std::string_view line, int number, const std::string& file,
                     const std::vector<MarkedLine>& marked) {
    std::string kinds;
    std::string said;
    for (const MarkedLine& mark : marked) {
        if (mark.file != file || mark.line != number) continue;
        kinds += " " + mark.kind;
        said += fmt::format("<span class=\"said {}\">{}</span>", mark.kind, escapeHtml(mark.words));
    }
    return fmt::format(
        "<span class=\"line{0}\" data-line=\"{1}\"><button type=\"button\" class=\"at\" "
        "tabindex=\"-1\" aria-label=\"{1}: comment on this line\">{1}</button>{2}{3}</span>",
        kinds, number,
        line.substr(kLineStart.size(), line.size() - kLineStart.size() - kLineEnd.size()), said);
}

std::string file(const SourceText& source, const std::vector<MarkedLine>& marked) {
    const std::string coloured = highlightCpp(source.bytes);
    std::string html = fmt::format(
        "<h2>{0}</h2><pre class=\"code\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\" "
        "data-file=\"{0}\"><code>",
        escapeHtml(source.file));
    int number = 0;
    for (const std::string_view line : report::linesOf(coloured))
        html += numbered(line, ++number, source.file, marked);
    return html + "</code></pre>";
}

/// " this and line 37": the other lines of an edit at several places, which passes as a whole.
std::string besides(const ProvenLine& one, const std::vector<ProvenLine>& all) {
    std::string others;
    for (const ProvenLine& other : all)
        if (other.task == one.task && other.line != one.line)
            others += fmt::format(" and line {}", other.line);
    return others.empty() ? "" : " this" + others;
}

std::string wordsOf(const ProvenLine& proven, const std::vector<ProvenLine>& all) {
    const std::string beside = besides(proven, all);
    if (proven.to.empty())
        return proven.task + " passes without" + (beside.empty() ? " this line" : beside);
    return fmt::format("{} passes with{}: {}", proven.task, beside, proven.to);
}

}  // namespace

std::vector<MarkedLine> markedLines(const SubmissionResult& result) {
    std::vector<MarkedLine> marked;
    for (const Diagnostics& said : result.diagnostics)
        for (const report::Remark& remark : report::remarksOf(said))
            marked.push_back({said.file, remark.line, std::string{remark.kind},
                              fmt::format("{}: {}", remark.kind, remark.message)});
    const std::vector<ProvenLine> all = provenLines(result);
    for (const ProvenLine& proven : all)
        marked.push_back({proven.file, proven.line, "proven", wordsOf(proven, all)});
    return marked;
}

std::string codeHtml(const std::vector<SourceText>& sources,
                     const std::vector<MarkedLine>& marked) {
    std::string html;
    for (const SourceText& source : sources)
        html += file(source, marked);
    return html.empty() ? "" : "<section class=\"codes\">" + html + "</section>";
}

}  // namespace ticker::session

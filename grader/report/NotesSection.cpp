#include <grader/report/Escape.h>
#include <grader/report/Markdown.h>
#include <grader/report/PageParts.h>
#include <grader/report/SourceLines.h>

#include <fmt/core.h>

namespace ticker::report {
namespace {

/// The line between its neighbours where the file is at hand and has not changed.
std::string quoted(const SubmissionResult& result, const LineNote& note) {
    const auto source = linesOf(sourceOf(result, note.file));
    const auto at = static_cast<std::size_t>(note.line - 1);
    if (at < source.size() && cleanText(source[at]) == note.code) return excerpt(source, note.line);
    return fmt::format(
        "<pre class=\"source\"><code><span class=\"number\">{:>4}</span> {}</code></pre>",
        note.line, escapeHtml(note.code));
}

}  // namespace

std::string notesSection(const SubmissionResult& result, const std::vector<LineNote>& notes) {
    std::string html;
    for (const LineNote& note : notes)
        html += fmt::format(
            "<div class=\"card line-note\"><h3>{}, line {}</h3>{}<div "
            "class=\"words\">{}</div></div>",
            escapeHtml(note.file), note.line, quoted(result, note), markdownHtml(note.text));
    if (html.empty()) return "";
    return "<section id=\"notes\"><h2>Your ticker about your code</h2>" + html + "</section>";
}

}  // namespace ticker::report

#include <grader/report/Escape.h>
#include <grader/report/Markdown.h>
#include <grader/report/platforms/MoodleFeedback.h>

#include <fmt/core.h>

#include <string_view>

namespace ticker::report {
namespace {

std::string paragraph(std::string_view text) {
    std::string html;
    for (const char c : escapeHtml(text))
        html += c == '\n' ? "<br>" : c == '\\' ? "&#92;" : std::string{c};
    return html;
}

/// Our own HTML on one line: newlines are kept, as <br>, in preformatted text only, and attributes
/// get single quotes.
std::string onOneLine(std::string_view html) {
    std::string line;
    bool isPreformatted = false;
    for (std::size_t i = 0; i < html.size(); ++i) {
        if (html.substr(i).starts_with("<pre>")) isPreformatted = true;
        if (html.substr(i).starts_with("</pre>")) isPreformatted = false;
        switch (html[i]) {
            case '\n':
                line += isPreformatted ? "<br>" : "";
                break;
            case '\\':
                line += "&#92;";
                break;
            case '\'':
                line += "&#39;";
                break;
            case '"':
                line += '\'';
                break;
            default:
                line += html[i];
        }
    }
    return line;
}

std::string notes(const StudentView& view) {
    std::string html;
    for (const LineNote& note : view.notes())
        html += fmt::format("<p>About {}, line {}:</p><pre>{}</pre>{}", paragraph(note.file),
                            note.line, paragraph(note.code), onOneLine(markdownHtml(note.text)));
    return html;
}

}  // namespace

std::string moodleFeedback(const StudentView& view) {
    const std::string sentence = paragraph(verdictSentence(view));
    std::string tasks = paragraph(tasksText(view));
    while (tasks.ends_with("<br>"))
        tasks.resize(tasks.size() - 4);
    if (view.comment().empty() && view.notes().empty())
        return sentence + (tasks.empty() ? "" : "<br>" + tasks);
    std::string html = "<p>" + sentence + "</p>";
    if (!view.comment().empty())
        html += "<p>Your ticker says:</p><blockquote>" + onOneLine(markdownHtml(view.comment())) +
                "</blockquote>";
    return html + notes(view) + (tasks.empty() ? "" : "<p>" + tasks + "</p>");
}

}  // namespace ticker::report

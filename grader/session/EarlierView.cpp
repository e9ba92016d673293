#include <grader/base/WholeFile.h>
#include <grader/session/EarlierView.h>
#include <grader/session/LineDiff.h>

#include <grader/report/Escape.h>
#include <grader/report/PageParts.h>
#include <grader/report/ReportWords.h>
#include <grader/result/Names.h>
#include <grader/result/Tally.h>

#include <fmt/core.h>

#include <algorithm>
#include <set>

namespace ticker::session {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLinesAround = 3;

bool isNearChange(const std::vector<DiffLine>& diff, std::size_t at) {
    const std::size_t first = at > kLinesAround ? at - kLinesAround : 0;
    const std::size_t last = std::min(at + kLinesAround, diff.size() - 1);
    for (std::size_t i = first; i <= last; ++i)
        if (diff[i].kind != ' ') return true;
    return false;
}

std::string diffHtml(const std::string& file, std::string_view before, std::string_view after) {
    const std::vector<DiffLine> diff = lineDiff(before, after);
    std::string html;
    bool isGap = false;
    for (std::size_t i = 0; i < diff.size(); ++i) {
        const bool isShown = isNearChange(diff, i);
        if (isShown)
            html += fmt::format("<span class=\"diff {}\">{} {}</span>",
                                diff[i].kind == '+'   ? "in"
                                : diff[i].kind == '-' ? "out"
                                                      : "same",
                                diff[i].kind, report::escapeHtml(diff[i].text));
        else if (!isGap)
            html += "<span class=\"diff gap\">...</span>";
        isGap = !isShown;
    }
    const bool isSame =
        std::ranges::all_of(diff, [](const DiffLine& line) { return line.kind == ' '; });
    if (isSame)
        return fmt::format("<p class=\"soft\">{} has not changed.</p>", report::escapeHtml(file));
    return fmt::format(
        "<h3>{0}</h3><pre tabindex=\"0\" role=\"region\" aria-label=\"Changes in {0}\">{1}</pre>",
        report::escapeHtml(file), html);
}

std::string idsWithout(const SubmissionResult& one, const SubmissionResult& other) {
    const auto others = findingIds(other);
    std::string text;
    for (const std::string& id : findingIds(one))
        if (std::ranges::find(others, id) == others.end())
            text += fmt::format(" <code>{}</code>", report::escapeHtml(id));
    return text;
}

/// The findings that are gone and those that are new, in words.
std::string changeOf(const SubmissionResult& before, const SubmissionResult& next) {
    const std::string gone = idsWithout(before, next);
    const std::string come = idsWithout(next, before);
    return (gone.empty() ? "" : " No longer found:" + gone + ".") +
           (come.empty() ? "" : " New:" + come + ".");
}

std::string sourceIn(const fs::path& folder, const std::string& file) {
    return cleanText(readIfThere(folder / file).value_or(""));
}

std::set<std::string> filesOf(const fs::path& code) {
    std::set<std::string> files;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator{code, ignored})
        files.insert(entry.path().filename().string());
    return files;
}

std::string one(const store::Earlier& before, const SubmissionResult& next, const fs::path& code,
                bool isOpen) {
    std::string html = fmt::format(
        "<details class=\"card\"{}><summary>Graded <time datetime=\"{}\">{}</time>: {}</summary>"
        "<p>Then {}.{}</p>",
        isOpen ? " open" : "", before.gradedAt, before.gradedAt,
        report::badge(toString(before.result.verdict), report::wordsFor(before.result.verdict)),
        report::badge(toString(next.verdict), report::wordsFor(next.verdict)),
        changeOf(before.result, next));
    std::set<std::string> files = filesOf(before.code);
    files.merge(filesOf(code));
    for (const std::string& file : files)
        html += diffHtml(file, sourceIn(before.code, file), sourceIn(code, file));
    return html + "</details>";
}

}  // namespace

std::string earlierHtml(const SubmissionResult& now, const fs::path& code,
                        const std::vector<store::Earlier>& earlier) {
    std::string html;
    for (std::size_t i = 0; i < earlier.size(); ++i)
        html += one(earlier[i], i == 0 ? now : earlier[i - 1].result,
                    i == 0 ? code : earlier[i - 1].code, i == 0);
    if (html.empty()) return "";
    return "<section id=\"earlier\"><h2 tabindex=\"-1\">Handed in before</h2>" + html +
           "</section>";
}

std::string earlierLine(const SubmissionResult& now, const std::vector<store::Earlier>& earlier) {
    if (earlier.empty()) return "";
    const SubmissionResult& before = earlier.front().result;
    return fmt::format(
        "<p class=\"before\">Handed in before: {}.{} <button type=\"button\" class=\"link\" "
        "data-act=\"earlier\">What has changed</button></p>",
        report::badge(toString(before.verdict), report::wordsFor(before.verdict)),
        changeOf(before, now));
}

}  // namespace ticker::session

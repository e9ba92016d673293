#include <grader/similar/SimilarPage.h>

#include <grader/report/Escape.h>
#include <grader/report/PageParts.h>
#include <grader/report/ReportWords.h>
#include <grader/report/SourceLines.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace ticker::similar {
namespace {

using report::escapeHtml;

constexpr const char* kCss = R"css(
main, header { max-width: 96rem; }
table { border-collapse: collapse; }
th, td { text-align: left; padding: .25rem .8rem .25rem 0; border-bottom: 1px solid var(--line);
  overflow-wrap: anywhere; }
details { background: var(--card); border: 1px solid var(--line); border-radius: .6rem;
  margin: 1rem 0; padding: .6rem 1rem; box-shadow: var(--shade); }
summary { cursor: pointer; font-weight: 600; overflow-wrap: anywhere; }
.two { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; }
.two > * { min-width: 0; }
.two h3 { margin: .6rem 0 .3rem; overflow-wrap: anywhere; }
.two pre { margin: 0; overflow: auto; max-height: 70vh; line-height: 1.45;
  border: 1px solid var(--line); border-radius: .4rem; padding: .4rem 0; }
.two pre span { display: block; padding: 0 .5rem; width: max-content; min-width: 100%; }
.two .common { color: var(--soft); font-style: italic; }
.two .shared { background: var(--look-paper); color: var(--look); }
.two .shared.odd { background: var(--accent-paper); color: var(--accent); }
@media (max-width: 60rem) { .two { grid-template-columns: 1fr; } .two pre { max-height: 45vh; } }
)css";

bool isIn(const LineRange& range, int line) {
    return range.first <= line && line <= range.last;
}

/// Where a line belongs: the number of its passage, counted from 1, or 0.
std::size_t passageOf(const std::vector<LineRange>& passages, int line) {
    const auto found =
        std::ranges::find_if(passages, [&](const LineRange& one) { return isIn(one, line); });
    return found == passages.end() ? 0 : static_cast<std::size_t>(found - passages.begin()) + 1;
}

std::string codeHtml(const std::string& text, const std::vector<LineRange>& passages,
                     const std::vector<LineRange>& common) {
    std::string html;
    int number = 0;
    for (const std::string_view line : report::linesOf(text)) {
        const std::size_t passage = passageOf(passages, ++number);
        const bool isCommon = passageOf(common, number) > 0;
        const char* kind = isCommon           ? "common"
                           : passage == 0     ? "own"
                           : passage % 2 != 0 ? "shared"
                                              : "shared odd";
        const std::string mark =
            passage > 0 && !isCommon ? fmt::format("{:>2}", passage) : std::string{"  "};
        html += fmt::format("<span class=\"{}\">{} {:>4} {}</span>", kind, mark, number,
                            escapeHtml(line));
    }
    return html;
}

std::string side(const ComparedFile& file, std::size_t index,
                 const std::vector<LineRange>& passages) {
    const StudentFile& student = file.files[index];
    const std::string name = escapeHtml(student.submission);
    return fmt::format(
        "<section><h3>{0}</h3><pre tabindex=\"0\" role=\"region\" aria-label=\"{1} of {0}\">"
        "<code>{2}</code></pre></section>",
        name, escapeHtml(file.name),
        codeHtml(student.text, passages, file.comparison.common[index]));
}

std::string pairHtml(const ComparedFile& file, const SimilarPair& pair, bool isOpen) {
    std::vector<LineRange> left;
    std::vector<LineRange> right;
    for (const Passage& passage : pair.passages) {
        left.push_back(passage.left);
        right.push_back(passage.right);
    }
    return fmt::format(
        "<details{}><summary>{} %: {} and {}, {}, {}</summary><div class=\"two\">{}{}</div>"
        "</details>",
        isOpen ? " open" : "", pair.percent, escapeHtml(file.files[pair.left].submission),
        escapeHtml(file.files[pair.right].submission), escapeHtml(file.name),
        report::counted(pair.passages.size(), "passage"), side(file, pair.left, left),
        side(file, pair.right, right));
}

/// Names the files that are too long: padding must not hide a copy.
std::string leftOutHtml(const ComparedFile& file) {
    if (file.leftOut.empty()) return "";
    std::string html = "<p><strong>Too long to be compared; look at it yourself:</strong> ";
    for (const std::string& submission : file.leftOut)
        html += (&submission == file.leftOut.data() ? "" : ", ") + escapeHtml(submission);
    return html + "</p>";
}

/// The pairs of a file, and how many files were compared.
std::string fileHtml(const ComparedFile& file) {
    const Comparison& comparison = file.comparison;
    std::string html = fmt::format(
        "<section><h2>{}</h2><p>{} of {} have enough code of their own to be compared; {} "
        "listed.</p>",
        escapeHtml(file.name), comparison.compared, report::counted(file.files.size(), "file"),
        report::counted(comparison.pairs.size(), "pair"));
    html += leftOutHtml(file);
    const std::size_t shown = std::min(comparison.pairs.size(), kMostPairs);
    for (std::size_t i = 0; i < shown; ++i)
        html += pairHtml(file, comparison.pairs[i], i == 0);
    if (shown < comparison.pairs.size())
        html += fmt::format("<p>The {} least similar pairs are left out.</p>",
                            comparison.pairs.size() - shown);
    return html + "</section>";
}

}  // namespace

std::string similarPage(const std::vector<ComparedFile>& compared) {
    std::string html =
        "<header><h1>Similar submissions</h1><p>Each pair shares code that is neither in the "
        "template nor in the reference solution. Names, numbers, comments and layout do not "
        "count. The percentage is the shared part of the code that is left, the mean of both "
        "files. Passages have the same number on both sides; grey lines are in the template or "
        "the reference.</p><p><strong>A high percentage is no proof of copying.</strong> Two "
        "students who follow the same lecture may write the same lines. Read both files, and "
        "talk to both students, before you conclude anything.</p></header><main id=\"main\">";
    for (const ComparedFile& file : compared)
        html += fileHtml(file);
    return report::page("Similar submissions", kCss, "", html + "</main>");
}

std::string similarJson(const std::vector<ComparedFile>& compared) {
    nlohmann::json all = nlohmann::json::array();
    for (const ComparedFile& file : compared)
        for (const SimilarPair& pair : file.comparison.pairs)
            all.push_back({{"left", file.files[pair.left].submission},
                           {"right", file.files[pair.right].submission},
                           {"file", file.name},
                           {"percent", pair.percent}});
    return all.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace ticker::similar

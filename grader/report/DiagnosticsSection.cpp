#include <grader/report/Escape.h>
#include <grader/report/PageParts.h>
#include <grader/report/SourceLines.h>

#include <fmt/core.h>
#include <algorithm>
#include <vector>

namespace ticker::report {
namespace {

constexpr std::size_t kMostErrors = 8;  // later errors are mostly consequences

std::string ofFile(const Diagnostics& said, std::string_view text) {
    const std::vector<std::string_view> source = linesOf(text);
    std::string html = fmt::format("<h3>{}</h3>", escapeHtml(said.file));
    const std::vector<Remark> remarks = remarksOf(said);
    const std::size_t shown = std::min(remarks.size(), kMostErrors);
    for (std::size_t i = 0; i < shown; ++i) {
        const Remark& remark = remarks[i];
        html += fmt::format("<div class=\"remark\"><p>{} line {}: {}</p>{}</div>",
                            badge(remark.kind == "error" ? "fail" : "warn", remark.kind),
                            remark.line, escapeHtml(remark.message), excerpt(source, remark.line));
    }
    if (remarks.size() > shown)
        html += fmt::format("<p class=\"soft\">{} more follow.</p>", remarks.size() - shown);
    return html + fmt::format(
                      "<details{}><summary>The compiler's own words</summary><pre>{}</pre>"
                      "</details>",
                      remarks.empty() ? " open" : "", escapeHtml(said.text));
}

}  // namespace

std::string diagnosticsSection(const SubmissionResult& result) {
    std::string html;
    for (const Diagnostics& said : result.diagnostics)
        if (!said.text.empty()) html += ofFile(said, sourceOf(result, said.file));
    if (html.empty()) return "";
    return "<section id=\"compiler\"><h2>What the compiler said</h2>" + html + "</section>";
}

}  // namespace ticker::report

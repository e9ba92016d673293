#include <grader/report/Escape.h>
#include <grader/report/PageParts.h>
#include <grader/report/ReportWords.h>
#include <grader/result/Names.h>

#include <fmt/core.h>

namespace ticker::report {
namespace {

std::string evidenceText(const EvidenceValue& value) {
    struct Visitor {
        std::string operator()(bool flag) const { return flag ? "yes" : "no"; }
        std::string operator()(double real) const { return fmt::format("{:.6g}", real); }
        std::string operator()(const std::string& text) const { return escapeHtml(text); }
        std::string operator()(const std::vector<double>& list) const {
            std::string text;
            for (const double real : list)
                text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", real);
            return text;
        }
    };
    return std::visit(Visitor{}, value);
}

std::string evidenceTable(const Evidence& evidence) {
    if (evidence.empty()) return "";
    std::string html = "<details><summary>What was measured</summary><table class=\"evidence\">";
    for (const auto& [key, value] : evidence)
        html += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>",
                            escapeHtml(spelledOut(key)), evidenceText(value));
    return html + "</table></details>";
}

}  // namespace

std::string findingCard(const Finding& finding, const Album& album, const std::string& seen) {
    const std::string_view severity = toString(finding.severity);
    std::string html =
        fmt::format("<article class=\"card {0}\"><div class=\"finding-head\">{1}<h3>{2}</h3>",
                    severity, badge(severity, wordsFor(finding.severity)), escapeHtml(finding.id));
    if (!finding.section.empty())
        html += fmt::format("<span class=\"soft\">Handout: {}</span>", escapeHtml(finding.section));
    html += fmt::format("</div><p class=\"message\">{}</p>", escapeHtml(finding.message));
    if (!finding.hint.empty())
        html += fmt::format("<p class=\"hint\"><strong>Hint.</strong> {}</p>",
                            escapeHtml(finding.hint));
    if (const std::string shown = figures(finding.plots, finding.rasters, album) + seen;
        !shown.empty())
        html += "<div class=\"figures\">" + shown + "</div>";
    return html + evidenceTable(finding.evidence) + "</article>";
}

}  // namespace ticker::report

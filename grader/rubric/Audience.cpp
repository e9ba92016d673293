#include <grader/result/Names.h>
#include <grader/rubric/Audience.h>
#include <grader/rubric/JsonMember.h>

#include <nlohmann/json.hpp>

#include <array>
#include <string_view>
#include <utility>

namespace ticker::rubric {
namespace {

constexpr std::array<std::pair<Detail, std::string_view>, 3> kDetailNames{
    {{Detail::hidden, "hidden"}, {Detail::message, "message"}, {Detail::hint, "hint"}}};

Detail readDetail(const JsonMember& member) {
    const auto detail = valueIn(kDetailNames, std::string_view{member.text()});
    if (!detail) member.fail("\"hidden\", \"message\" or \"hint\"");
    return *detail;
}

Detail detailFor(const Audience& audience, const Finding& finding) {
    const auto own = audience.byFinding.find(finding.id);
    return own != audience.byFinding.end() ? own->second : audience.bySeverity.at(finding.severity);
}

}  // namespace

Audience readAudience(const std::filesystem::path& file, const std::string& name) {
    const nlohmann::json document = readJson(file, "what each audience sees");
    const JsonMember member = JsonMember{file.string(), "", document}.at(name);
    member.expectOnly({"verdict", "fail", "warn", "note", "findings"});
    Audience audience;
    audience.verdict = member.at("verdict").yesOrNo();
    for (const auto& [severity, severityName] : kSeverityNames)
        audience.bySeverity[severity] = readDetail(member.at(std::string{severityName}));
    const JsonMember findings = member.at("findings");
    if (!findings.value().is_object()) findings.fail("an object");
    for (const auto& [id, unused] : findings.value().items())
        audience.byFinding[id] = readDetail(findings.at(id));
    return audience;
}

SubmissionResult shownTo(const Audience& audience, SubmissionResult result) {
    for (TaskReport& task : result.tasks) {
        std::erase_if(task.findings, [&](const Finding& finding) {
            return detailFor(audience, finding) == Detail::hidden;
        });
        for (Finding& finding : task.findings) {
            if (detailFor(audience, finding) == Detail::hint) continue;
            finding.hint.clear();
            finding.section.clear();
            finding.evidence.clear();
            finding.plots.clear();
            finding.rasters.clear();
        }
    }
    return result;
}

}  // namespace ticker::rubric

#include <grader/report/Escape.h>
#include <grader/report/ResultJson.h>
#include <grader/result/Names.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <unistd.h>
#include <cmath>
#include <fstream>
#include <system_error>

namespace ticker::report {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json evidenceValue(const EvidenceValue& value) {
    struct Visitor {
        ordered_json operator()(bool flag) const { return flag; }
        ordered_json operator()(double real) const { return number(real); }
        ordered_json operator()(const std::string& text) const { return cleanText(text); }
        ordered_json operator()(const std::vector<double>& list) const {
            ordered_json array = ordered_json::array();
            for (const double real : list)
                array.push_back(number(real));
            return array;
        }
    };
    return std::visit(Visitor{}, value);
}

ordered_json findingJson(const Finding& finding) {
    ordered_json evidence = ordered_json::object();
    for (const auto& [key, value] : finding.evidence)
        evidence[cleanText(key)] = evidenceValue(value);
    ordered_json json;
    json["id"] = finding.id;
    json["severity"] = toString(finding.severity);
    json["message"] = cleanText(finding.message);
    json["hint"] = cleanText(finding.hint);
    if (!finding.section.empty()) json["section"] = cleanText(finding.section);
    json["evidence"] = evidence;
    return json;
}

ordered_json taskJson(const TaskReport& task) {
    ordered_json findings = ordered_json::array();
    for (const Finding& finding : task.findings)
        findings.push_back(findingJson(finding));
    ordered_json json;
    json["id"] = task.id;
    json["title"] = task.title;
    json["state"] = toString(task.state);
    json["reason"] = cleanText(task.reason);
    json["findings"] = findings;
    if (task.needsReview) json["needsReview"] = true;
    return json;
}

ordered_json diagnosticsJson(const SubmissionResult& result) {
    ordered_json list = ordered_json::array();
    for (const Diagnostics& said : result.diagnostics)
        list.push_back({{"file", cleanText(said.file)}, {"text", cleanText(said.text)}});
    return list;
}

ordered_json renderJson(const RenderScore& render) {
    ordered_json json;
    json["scene"] = render.scene;
    json["width"] = render.width;
    json["height"] = render.height;
    json["flip"] = number(render.flip);
    json["ssim"] = number(render.ssim);
    json["gmsd"] = number(render.gmsd);
    json["zMax"] = number(render.zMax);
    json["rmse"] = number(render.rmse);
    json["image"] = render.image;
    json["reference"] = render.reference;
    if (!render.errorMap.empty()) json["errorMap"] = render.errorMap;
    return json;
}

}  // namespace

std::string resultJson(const SubmissionResult& result) {
    ordered_json tasks = ordered_json::array();
    for (const TaskReport& task : result.tasks)
        tasks.push_back(taskJson(task));
    ordered_json renders = ordered_json::array();
    for (const RenderScore& render : result.renders)
        renders.push_back(renderJson(render));
    ordered_json notices = ordered_json::array();
    for (const std::string& notice : result.notices)
        notices.push_back(cleanText(notice));

    ordered_json json;
    json["schemaVersion"] = SubmissionResult::kSchemaVersion;
    json["submission"] = cleanText(result.submission);
    json["verdict"] = toString(result.verdict);
    json["score"] = number(result.score);
    json["maxScore"] = number(result.maxScore);
    json["option"] = result.option;
    json["seed"] = std::to_string(result.seed);
    json["sandboxLevel"] = result.sandboxLevel;
    json["toolVersion"] = result.toolVersion;
    if (result.inputs.areKnown())
        json["inputs"] = {{"files", result.inputs.files},
                          {"tool", result.inputs.tool},
                          {"how", result.inputs.how}};
    json["tasks"] = tasks;
    json["renders"] = renders;
    json["notices"] = notices;
    if (!result.diagnostics.empty()) json["diagnostics"] = diagnosticsJson(result);
    json["timing"] = {{"compileMs", number(std::round(result.timing.compileMs))},
                      {"probeMs", number(std::round(result.timing.probeMs))},
                      {"totalMs", number(std::round(result.timing.totalMs))}};
    // What is no UTF-8 is replaced: no text may keep a result from being written.
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

void writeAtomically(const std::string& text, const std::filesystem::path& file) {
    const std::filesystem::path temporary =
        file.parent_path() / fmt::format(".{}.{}.part", file.filename().string(), ::getpid());
    std::ofstream stream{temporary, std::ios::binary | std::ios::trunc};
    stream << text;
    stream.close();
    std::error_code error;
    if (stream) std::filesystem::rename(temporary, file, error);
    if (!stream || error) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw raytracer::InputError(
            file.string(), 0, "cannot be written; is the folder there and the disk not full?");
    }
}

}  // namespace ticker::report

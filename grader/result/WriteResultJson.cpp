#include <grader/base/Utf8.h>
#include <grader/result/Names.h>
#include <grader/result/RayDrawingJson.h>
#include <grader/result/ResultJson.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cctype>
#include <cmath>
#include <cstddef>

namespace ticker {
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

/// Four digits: plots show no more.
ordered_json shortNumber(double value) {
    if (!std::isfinite(value)) return nullptr;
    const double scale =
        value == 0.0 ? 1.0 : std::pow(10.0, 3.0 - std::floor(std::log10(std::abs(value))));
    const double rounded = std::round(value * scale) / scale;
    return std::isfinite(rounded) ? ordered_json(rounded) : ordered_json(value);
}

ordered_json plotJson(const ScatterPlot& plot) {
    ordered_json points = ordered_json::array();
    for (const PlotPoint& point : plot.points)
        points.push_back({shortNumber(point.x), shortNumber(point.y)});
    ordered_json json;
    json["title"] = cleanText(plot.title);
    json["unit"] = cleanText(plot.unit);
    json["expectedShape"] = toString(plot.expectedShape);
    json["expectedHalfWidth"] = number(plot.expectedHalfWidth);
    if (plot.otherHalfWidth > 0.0) json["otherHalfWidth"] = number(plot.otherHalfWidth);
    json["points"] = points;
    if (plot.drawing) json["drawing"] = ordered_json::parse(rayDrawingJson(*plot.drawing));
    return json;
}

/// Adds the plots and rasters of a finding or a task, if there are any.
void addFigures(ordered_json& json, const std::vector<ScatterPlot>& plots,
                const std::vector<Raster>& rasters) {
    for (const ScatterPlot& plot : plots)
        json["plots"].push_back(plotJson(plot));
    for (const Raster& raster : rasters)
        if (!raster.image.empty())
            json["pictures"].push_back(
                {{"title", cleanText(raster.title)}, {"image", raster.image}});
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
    addFigures(json, finding.plots, finding.rasters);
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
    addFigures(json, task.plots, task.rasters);
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
    if (!render.zMap.empty()) json["zMap"] = render.zMap;
    return json;
}

/// End of the array that begins at `begin` if it contains only numbers (or such arrays).
std::size_t endOfNumbers(const std::string& text, std::size_t begin) {
    int depth = 0;
    for (std::size_t i = begin; i < text.size(); ++i) {
        if (text[i] == '"' || text[i] == '{') return std::string::npos;
        if (text[i] == '[') ++depth;
        if (text[i] == ']' && --depth == 0) return i;
    }
    return std::string::npos;
}

/// Puts lists of numbers on one line; otherwise their hundreds of lines hide the rest.
std::string listsOnOneLine(const std::string& text) {
    std::string result;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\')
            result += text[i++];  // an escaped character never ends a string
        else if (text[i] == '"')
            quoted = !quoted;
        const std::size_t end =
            text[i] == '[' && !quoted ? endOfNumbers(text, i) : std::string::npos;
        if (end == std::string::npos) {
            result += text[i];
            continue;
        }
        for (; i <= end; ++i)
            if (std::isspace(static_cast<unsigned char>(text[i])) == 0)
                result += text[i] == ',' ? std::string{", "} : std::string(1, text[i]);
        --i;
    }
    return result;
}

ordered_json optionsJson(const std::vector<Option>& options) {
    ordered_json list = ordered_json::array();
    for (const Option& option : options)
        list.push_back({{"name", cleanText(option.name)},
                        {"tasks", option.tasks},
                        {"points", number(option.points)}});
    return list;
}

ordered_json pictureJson(const ResultPicture& picture) {
    return {{"file", picture.file}, {"caption", cleanText(picture.caption)}};
}

ordered_json editJson(const RepairEdit& edit) {
    return {{"from", cleanText(edit.from)}, {"to", cleanText(edit.to)}};
}

/// Repairs that are not proven are not written.
ordered_json repairsJson(const std::vector<Repair>& repairs) {
    ordered_json list = ordered_json::array();
    for (const Repair& repair : repairs) {
        if (!repair.proven || repair.edits.empty()) continue;
        ordered_json json{{"task", repair.task},
                          {"finding", repair.finding},
                          {"file", cleanText(repair.file)},
                          {"line", repair.edits.front().line},
                          {"edit", editJson(repair.edits.front())},
                          {"proven", true},
                          {"next", repair.next}};
        for (std::size_t i = 1; i < repair.edits.size(); ++i)
            json["more"].push_back(
                {{"line", repair.edits[i].line}, {"edit", editJson(repair.edits[i])}});
        list.push_back(std::move(json));
    }
    return list;
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
    if (!result.exercise.empty()) json["exercise"] = cleanText(result.exercise);
    json["verdict"] = toString(result.verdict);
    json["score"] = number(result.score);
    json["maxScore"] = number(result.maxScore);
    json["option"] = cleanText(result.option);
    if (!result.options.empty()) json["options"] = optionsJson(result.options);
    json["seed"] = std::to_string(result.seed);
    json["sandboxLevel"] = result.sandboxLevel;
    json["toolVersion"] = result.toolVersion;
    if (result.inputs.areKnown())
        json["inputs"] = {{"files", result.inputs.files},
                          {"tool", result.inputs.tool},
                          {"how", result.inputs.how}};
    json["tasks"] = tasks;
    json["renders"] = renders;
    if (result.repairs) json["repairs"] = repairsJson(*result.repairs);
    json["notices"] = notices;
    for (const ResultPicture& picture : result.pictures)
        json["pictures"].push_back(pictureJson(picture));
    if (!result.diagnostics.empty()) json["diagnostics"] = diagnosticsJson(result);
    json["timing"] = {{"compileMs", number(std::round(result.timing.compileMs))},
                      {"probeMs", number(std::round(result.timing.probeMs))},
                      {"totalMs", number(std::round(result.timing.totalMs))}};
    // Invalid UTF-8 is replaced: no text may prevent writing a result.
    return listsOnOneLine(json.dump(2, ' ', false, ordered_json::error_handler_t::replace)) + "\n";
}

}  // namespace ticker

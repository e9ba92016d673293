#include <grader/base/JsonValue.h>
#include <grader/base/WholeFile.h>
#include <grader/result/Names.h>
#include <grader/result/RayDrawingJson.h>
#include <grader/result/ResultJson.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/core.h>

#include <cstdint>
#include <limits>
#include <utility>

namespace ticker {
namespace {

using raytracer::InputError;

constexpr std::uintmax_t kLargestFile = 16U << 20U;

/// null stands for NaN.
double realOf(const JsonValue& value) {
    return value.isNull() ? std::numeric_limits<double>::quiet_NaN() : value.number();
}

int integerOf(const JsonValue& value) {
    const double real = realOf(value);
    if (!(real >= -2147483648.0 && real <= 2147483647.0)) value.expect("an integer");
    return static_cast<int>(real);
}

template <typename Names>
auto oneOf(const Names& names, const JsonValue& value) {
    const auto known = valueIn(names, value.text());
    if (!known) value.expect("one of the words of the schema, found \"" + value.text() + "\"");
    return *known;
}

EvidenceValue readEvidence(const JsonValue& place) {
    if (const auto flag = place.asFlag()) return *flag;
    if (const auto text = place.asText()) return *text;
    if (!place.isArray()) return realOf(place);
    std::vector<double> list;
    for (const JsonValue& item : place.items())
        list.push_back(realOf(item));
    return list;
}

ScatterPlot readPlot(const JsonValue& place) {
    ScatterPlot plot;
    plot.title = place.at("title").text();
    plot.unit = place.at("unit").text();
    plot.expectedShape = oneOf(kShapeNames, place.at("expectedShape"));
    plot.expectedHalfWidth = realOf(place.at("expectedHalfWidth"));
    if (place.has("otherHalfWidth")) plot.otherHalfWidth = realOf(place.at("otherHalfWidth"));
    for (const JsonValue& point : place.at("points").items()) {
        const std::vector<JsonValue> pair = point.items();
        if (pair.size() != 2) point.expect("two numbers");
        plot.points.push_back({realOf(pair[0]), realOf(pair[1])});
    }
    if (place.has("drawing")) plot.drawing = readRayDrawing(place.at("drawing"));
    return plot;
}

/// A picture's path, which must lie below the result's folder.
std::string readImage(const JsonValue& place) {
    const std::string file = place.text();
    if (!file.starts_with("images/") || file.find("..") != std::string::npos)
        place.expect("the path of a file in images/");
    return file;
}

void readFigures(const JsonValue& place, std::vector<ScatterPlot>& plots,
                 std::vector<Raster>& rasters) {
    if (place.has("plots"))
        for (const JsonValue& plot : place.at("plots").items())
            plots.push_back(readPlot(plot));
    if (!place.has("pictures")) return;
    for (const JsonValue& picture : place.at("pictures").items()) {
        Raster raster;
        raster.title = picture.at("title").text();
        raster.image = readImage(picture.at("image"));
        rasters.push_back(std::move(raster));
    }
}

Finding readFinding(const JsonValue& place) {
    Finding finding;
    finding.id = place.at("id").text();
    finding.severity = oneOf(kSeverityNames, place.at("severity"));
    finding.message = place.at("message").text();
    finding.hint = place.at("hint").text();
    if (place.has("section")) finding.section = place.at("section").text();
    for (const auto& [key, value] : place.at("evidence").members())
        finding.evidence.emplace_back(key, readEvidence(value));
    readFigures(place, finding.plots, finding.rasters);
    return finding;
}

TaskReport readTask(const JsonValue& place) {
    TaskReport task;
    task.id = place.at("id").text();
    task.title = place.at("title").text();
    task.state = oneOf(kTaskStateNames, place.at("state"));
    task.reason = place.at("reason").text();
    for (const JsonValue& finding : place.at("findings").items())
        task.findings.push_back(readFinding(finding));
    if (place.has("needsReview")) task.needsReview = place.at("needsReview").flag();
    readFigures(place, task.plots, task.rasters);
    return task;
}

RenderScore readRender(const JsonValue& place) {
    RenderScore render;
    render.scene = place.at("scene").text();
    render.width = integerOf(place.at("width"));
    render.height = integerOf(place.at("height"));
    render.flip = realOf(place.at("flip"));
    render.ssim = realOf(place.at("ssim"));
    render.gmsd = realOf(place.at("gmsd"));
    render.zMax = realOf(place.at("zMax"));
    if (place.has("rmse")) render.rmse = realOf(place.at("rmse"));
    render.image = place.at("image").text();
    if (place.has("reference")) render.reference = place.at("reference").text();
    if (place.has("errorMap")) render.errorMap = place.at("errorMap").text();
    if (place.has("zMap")) render.zMap = place.at("zMap").text();
    return render;
}

RepairEdit readRepairEdit(const JsonValue& place) {
    const JsonValue edit = place.at("edit");
    return {integerOf(place.at("line")), edit.at("from").text(), edit.at("to").text()};
}

/// An edit that is not proven is left out, even if the file holds one.
std::vector<Repair> readRepairs(const JsonValue& place) {
    std::vector<Repair> repairs;
    for (const JsonValue& item : place.items()) {
        Repair repair;
        repair.task = item.at("task").text();
        repair.finding = item.at("finding").text();
        repair.file = item.at("file").text();
        repair.proven = item.at("proven").flag();
        repair.next = item.at("next").text();
        repair.edits.push_back(readRepairEdit(item));
        if (item.has("more"))
            for (const JsonValue& more : item.at("more").items())
                repair.edits.push_back(readRepairEdit(more));
        if (repair.proven) repairs.push_back(std::move(repair));
    }
    return repairs;
}

Option readOption(const JsonValue& place) {
    Option option{place.at("name").text(), {}, realOf(place.at("points"))};
    for (const JsonValue& task : place.at("tasks").items())
        option.tasks.push_back(task.text());
    if (option.tasks.empty()) place.at("tasks").expect("an array that is not empty");
    return option;
}

std::uint64_t readSeed(const JsonValue& place) {
    const auto seed = raytracer::parseCount(place.text());
    if (!seed) place.expect("a whole number in a string");
    return *seed;
}

Inputs readInputs(const JsonValue& place) {
    return {place.at("files").text(), place.at("tool").text(), place.at("how").text()};
}

}  // namespace

SubmissionResult readResultJson(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) throw InputError(file.string(), 0, "cannot be read; expected a result.json");
    if (size > kLargestFile)
        throw InputError(file.string(), 0, fmt::format("{} bytes: too large for a result", size));
    return parseResultJson(readWhole(file, "cannot be read; expected a result.json"),
                           file.string());
}

SubmissionResult parseResultJson(const std::string& text, const std::string& name) {
    const JsonValue top = JsonValue::parse(text, name);
    if (integerOf(top.at("schemaVersion")) != SubmissionResult::kSchemaVersion)
        top.at("schemaVersion").expect(fmt::format("{}", SubmissionResult::kSchemaVersion));
    SubmissionResult result;
    result.submission = top.at("submission").text();
    if (top.has("exercise")) result.exercise = top.at("exercise").text();
    result.verdict = oneOf(kVerdictNames, top.at("verdict"));
    result.score = top.at("score").number();
    result.maxScore = top.at("maxScore").number();
    result.option = top.at("option").text();
    if (top.has("options"))
        for (const JsonValue& option : top.at("options").items())
            result.options.push_back(readOption(option));
    result.seed = readSeed(top.at("seed"));
    result.sandboxLevel = top.at("sandboxLevel").text();
    result.toolVersion = top.at("toolVersion").text();
    if (top.has("inputs")) result.inputs = readInputs(top.at("inputs"));
    for (const JsonValue& task : top.at("tasks").items())
        result.tasks.push_back(readTask(task));
    for (const JsonValue& render : top.at("renders").items())
        result.renders.push_back(readRender(render));
    if (top.has("repairs")) result.repairs = readRepairs(top.at("repairs"));
    for (const JsonValue& notice : top.at("notices").items())
        result.notices.push_back(notice.text());
    if (top.has("pictures"))
        for (const JsonValue& picture : top.at("pictures").items())
            result.pictures.push_back(
                {readImage(picture.at("file")), picture.at("caption").text(), {}});
    if (top.has("diagnostics"))
        for (const JsonValue& said : top.at("diagnostics").items())
            result.diagnostics.push_back({said.at("file").text(), said.at("text").text()});
    const JsonValue timing = top.at("timing");
    result.timing = {realOf(timing.at("compileMs")), realOf(timing.at("probeMs")),
                     realOf(timing.at("totalMs"))};
    return result;
}

}  // namespace ticker

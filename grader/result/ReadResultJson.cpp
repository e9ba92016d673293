#include <grader/base/JsonLines.h>
#include <grader/base/WholeFile.h>
#include <grader/result/Names.h>
#include <grader/result/ResultJson.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cstdint>
#include <limits>
#include <utility>

namespace ticker::report {
namespace {

// Ordered: evidence stands in the order in which a person should read it.
using nlohmann::ordered_json;
using raytracer::InputError;

constexpr std::uintmax_t kLargestFile = 16U << 20U;

/// A value of the file, with its place for messages.
struct Place {
    const std::string& file;
    const std::string& whole;  ///< the file's text
    std::string path;
    const ordered_json* value = nullptr;

    [[noreturn]] void fail(const std::string& expected) const {
        throw InputError(
            file, jsonLineOf(whole, path),
            fmt::format("{}: expected {}", path.empty() ? "the file" : path, expected));
    }
    [[nodiscard]] Place at(const char* name) const {
        if (!value->is_object() || !value->contains(name))
            fail(fmt::format("an object with a member \"{}\"", name));
        return {file, whole, path + "/" + name, &value->at(name)};
    }
    [[nodiscard]] bool has(const char* name) const {
        return value->is_object() && value->contains(name);
    }
    [[nodiscard]] std::vector<Place> items() const {
        if (!value->is_array()) fail("an array");
        std::vector<Place> places;
        for (std::size_t i = 0; i < value->size(); ++i)
            places.push_back({file, whole, path + "/" + std::to_string(i), &(*value)[i]});
        return places;
    }
    [[nodiscard]] std::string text() const {
        if (!value->is_string()) fail("a string");
        return value->get<std::string>();
    }
    [[nodiscard]] double number() const {
        if (value->is_null()) return std::numeric_limits<double>::quiet_NaN();
        if (!value->is_number()) fail("a number");
        return value->get<double>();
    }
    [[nodiscard]] int integer() const {
        const double real = number();
        if (!(real >= -2147483648.0 && real <= 2147483647.0)) fail("an integer");
        return static_cast<int>(real);
    }
    [[nodiscard]] bool flag() const {
        if (!value->is_boolean()) fail("true or false");
        return value->get<bool>();
    }
    template <typename Names>
    [[nodiscard]] auto oneOf(const Names& names) const {
        const auto known = valueIn(names, text());
        if (!known) fail("one of the words of the schema, found \"" + text() + "\"");
        return *known;
    }
};

EvidenceValue readEvidence(const Place& place) {
    if (place.value->is_boolean()) return place.value->get<bool>();
    if (place.value->is_string()) return place.text();
    if (!place.value->is_array()) return place.number();
    std::vector<double> list;
    for (const Place& item : place.items())
        list.push_back(item.number());
    return list;
}

ScatterPlot readPlot(const Place& place) {
    ScatterPlot plot;
    plot.title = place.at("title").text();
    plot.unit = place.at("unit").text();
    plot.expectedShape = place.at("expectedShape").oneOf(kShapeNames);
    plot.expectedHalfWidth = place.at("expectedHalfWidth").number();
    if (place.has("otherHalfWidth")) plot.otherHalfWidth = place.at("otherHalfWidth").number();
    for (const Place& point : place.at("points").items()) {
        const std::vector<Place> pair = point.items();
        if (pair.size() != 2) point.fail("two numbers");
        plot.points.push_back({pair[0].number(), pair[1].number()});
    }
    return plot;
}

/// A picture of the result: below its folder, and nowhere else.
std::string readImage(const Place& place) {
    const std::string file = place.text();
    if (!file.starts_with("images/") || file.find("..") != std::string::npos)
        place.fail("the path of a file in images/");
    return file;
}

void readFigures(const Place& place, std::vector<ScatterPlot>& plots,
                 std::vector<Raster>& rasters) {
    if (place.has("plots"))
        for (const Place& plot : place.at("plots").items())
            plots.push_back(readPlot(plot));
    if (!place.has("pictures")) return;
    for (const Place& picture : place.at("pictures").items()) {
        Raster raster;
        raster.title = picture.at("title").text();
        raster.image = readImage(picture.at("image"));
        rasters.push_back(std::move(raster));
    }
}

Finding readFinding(const Place& place) {
    Finding finding;
    finding.id = place.at("id").text();
    finding.severity = place.at("severity").oneOf(kSeverityNames);
    finding.message = place.at("message").text();
    finding.hint = place.at("hint").text();
    if (place.has("section")) finding.section = place.at("section").text();
    const Place evidence = place.at("evidence");
    if (!evidence.value->is_object()) evidence.fail("an object");
    for (const auto& [key, value] : evidence.value->items())
        finding.evidence.emplace_back(
            key, readEvidence({place.file, place.whole, evidence.path + "/" + key, &value}));
    readFigures(place, finding.plots, finding.rasters);
    return finding;
}

TaskReport readTask(const Place& place) {
    TaskReport task;
    task.id = place.at("id").text();
    task.title = place.at("title").text();
    task.state = place.at("state").oneOf(kTaskStateNames);
    task.reason = place.at("reason").text();
    for (const Place& finding : place.at("findings").items())
        task.findings.push_back(readFinding(finding));
    if (place.has("needsReview")) task.needsReview = place.at("needsReview").flag();
    readFigures(place, task.plots, task.rasters);
    return task;
}

RenderScore readRender(const Place& place) {
    RenderScore render;
    render.scene = place.at("scene").text();
    render.width = place.at("width").integer();
    render.height = place.at("height").integer();
    render.flip = place.at("flip").number();
    render.ssim = place.at("ssim").number();
    render.gmsd = place.at("gmsd").number();
    render.zMax = place.at("zMax").number();
    if (place.has("rmse")) render.rmse = place.at("rmse").number();
    render.image = place.at("image").text();
    if (place.has("reference")) render.reference = place.at("reference").text();
    if (place.has("errorMap")) render.errorMap = place.at("errorMap").text();
    if (place.has("zMap")) render.zMap = place.at("zMap").text();
    return render;
}

Option readOption(const Place& place) {
    Option option{place.at("name").text(), {}, place.at("points").number()};
    for (const Place& task : place.at("tasks").items())
        option.tasks.push_back(task.text());
    if (option.tasks.empty()) place.at("tasks").fail("an array that is not empty");
    return option;
}

std::uint64_t readSeed(const Place& place) {
    const std::string text = place.text();
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error != std::errc{} || end != text.data() + text.size())
        place.fail("a whole number in a string");
    return seed;
}

}  // namespace

SubmissionResult readResultJson(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) throw InputError(file.string(), 0, "cannot be read; expected a result.json");
    if (size > kLargestFile)
        throw InputError(file.string(), 0, fmt::format("{} bytes: too large for a result", size));
    return parseResultJson(readIfThere(file).value_or(""), file.string());
}

SubmissionResult parseResultJson(const std::string& text, const std::string& name) {
    ordered_json document;
    try {
        document = ordered_json::parse(text);
    } catch (const ordered_json::parse_error& problem) {
        throw InputError(name, lineOfByte(text, problem.byte),
                         fmt::format("not JSON: {}", problem.what()));
    }
    const Place top{name, text, "", &document};
    if (top.at("schemaVersion").integer() != SubmissionResult::kSchemaVersion)
        top.at("schemaVersion").fail(fmt::format("{}", SubmissionResult::kSchemaVersion));
    SubmissionResult result;
    result.submission = top.at("submission").text();
    result.verdict = top.at("verdict").oneOf(kVerdictNames);
    result.score = top.at("score").number();
    result.maxScore = top.at("maxScore").number();
    result.option = top.at("option").text();
    if (top.has("options"))
        for (const Place& option : top.at("options").items())
            result.options.push_back(readOption(option));
    result.seed = readSeed(top.at("seed"));
    result.sandboxLevel = top.at("sandboxLevel").text();
    result.toolVersion = top.at("toolVersion").text();
    if (top.has("inputs")) {
        const Place inputs = top.at("inputs");
        result.inputs = {inputs.at("files").text(), inputs.at("tool").text(),
                         inputs.at("how").text()};
    }
    for (const Place& task : top.at("tasks").items())
        result.tasks.push_back(readTask(task));
    for (const Place& render : top.at("renders").items())
        result.renders.push_back(readRender(render));
    for (const Place& notice : top.at("notices").items())
        result.notices.push_back(notice.text());
    if (top.has("pictures"))
        for (const Place& picture : top.at("pictures").items())
            result.pictures.push_back(
                {readImage(picture.at("file")), picture.at("caption").text(), {}});
    if (top.has("diagnostics"))
        for (const Place& said : top.at("diagnostics").items())
            result.diagnostics.push_back({said.at("file").text(), said.at("text").text()});
    const Place timing = top.at("timing");
    result.timing = {timing.at("compileMs").number(), timing.at("probeMs").number(),
                     timing.at("totalMs").number()};
    return result;
}

}  // namespace ticker::report

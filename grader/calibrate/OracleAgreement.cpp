#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/calibrate/Agreement.h>
#include <grader/calibrate/OracleAgreement.h>

#include <raytracer/base/Error.h>
#include <raytracer/io/SceneReader.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <utility>

namespace ticker::calibrate {
namespace {

using build::SourceFile;
using oracle::Moments;
using raytracer::RenderSettings;
using raytracer::SceneDescription;

constexpr int kRenders = 40;
// Means and variances of fifty thousand comparisons of normal variables: a false alarm in all of
// them together has a chance below 1e-3.
constexpr double kLargestZ = 5.8;
// Rays that graze an edge, or meet a texel's, may fall on its other side in single precision.
constexpr double kEdge = 2e-4;
constexpr double kEdgeShare = 0.01;

RenderSettings smallSettings() {
    RenderSettings settings;
    settings.width = 32;
    settings.height = 24;
    settings.dofRayCount = 16;
    settings.shadowRayCount = 5;
    return settings;
}

// A program that brings one file of its own has the template's other one: a pinhole camera and one
// hard shadow ray here, smooth spheres there.
RenderSettings bumpSettings() {
    RenderSettings settings;
    settings.width = 160;
    settings.height = 120;
    return settings;
}

SceneDescription smooth(SceneDescription scene) {
    for (raytracer::SphereDescription& sphere : scene.spheres)
        sphere.heightMap.reset();
    return scene;
}

std::string textOf(const std::filesystem::path& file) {
    std::ifstream stream{file, std::ios::binary};
    if (!stream) throw raytracer::InputError(file.string(), 0, "cannot be read");
    return {std::istreambuf_iterator<char>{stream}, {}};
}

std::vector<std::vector<raytracer::ColourRGB>> rendersOf(const build::Program& program,
                                                         const sandbox::Sandbox& sandbox,
                                                         const SceneDescription& scene,
                                                         const RenderSettings& settings,
                                                         int repetitions) {
    const sandbox::Limits limits;
    build::SandboxedExaminee examinee{program, sandbox, limits};
    const probe::Sitting sitting =
        examinee.ask({probe::RenderQuestion{scene, settings, repetitions, 0}});
    const auto& answer = std::get<probe::RenderAnswer>(sitting.answers.at(0));
    if (answer.state != probe::AnswerState::answered ||
        answer.images.size() != static_cast<std::size_t>(repetitions))
        throw raytracer::Error("the reference did not answer: " + sitting.end.detail);
    return answer.images;
}

raytracer::Image imageOf(const std::vector<raytracer::ColourRGB>& pixels,
                         const RenderSettings& settings) {
    raytracer::Image image{settings};
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image.set(x, y, pixels[static_cast<std::size_t>(y * image.width() + x)]);
    return image;
}

double distance(const raytracer::ColourRGB& a, const raytracer::ColourRGB& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

}  // namespace

OracleAgreement::OracleAgreement(AgreementPlan plan, const build::Kit& kit,
                                 const sandbox::Sandbox& sandbox)
    : plan_(std::move(plan)), kit_(kit), sandbox_(sandbox) {
    for (const auto& entry : std::filesystem::directory_iterator(plan_.scenes))
        if (entry.path().extension() == ".xml")
            scenes_.push_back({entry.path().stem().string(),
                               raytracer::readScene(entry.path(), plan_.assets)});
    std::ranges::sort(scenes_, {}, &Scene::name);
    for (std::size_t reading = 0; reading < plan_.cases.size(); ++reading)
        for (std::size_t scene = 0; scene < scenes_.size(); ++scene) {
            const bool isBump = plan_.cases[reading].file == SourceFile::bumpySphere;
            const auto& spheres = scenes_[scene].description.spheres;
            if (isBump && std::ranges::none_of(
                              spheres, [](const auto& sphere) { return !!sphere.heightMap; }))
                continue;
            for (int round = 0; round < (isBump ? 1 : plan_.rounds); ++round)
                units_.push_back({units_.size(), reading, scene});
        }
}

std::vector<std::size_t> OracleAgreement::checkUnits() const {
    // One of every thirtieth, so that all scenes and readings get their turn as they are added.
    std::vector<std::size_t> picked;
    for (std::size_t unit = 0; unit < units_.size(); unit += 30)
        picked.push_back(unit);
    return picked;
}

std::shared_ptr<const build::Program> OracleAgreement::programOf(std::size_t reading) {
    const std::lock_guard lock{mutex_};
    if (const auto found = programs_.find(reading); found != programs_.end()) return found->second;
    const AgreementCase& wanted = plan_.cases[reading];
    mistakes::Mistake edited;
    edited.id = wanted.name;
    edited.path = "the reading " + wanted.name;
    edited.edits = wanted.edits;
    build::BuildResult built = build::buildProgram(
        kit_, sandbox_, sandbox::Limits{}, wanted.file,
        mistakes::makeMistake(edited, textOf(plan_.reference / build::nameOf(wanted.file))));
    if (!built.program)
        throw raytracer::Error(edited.path + " does not compile: " + built.diagnostics);
    auto program = std::make_shared<const build::Program>(std::move(*built.program));
    programs_[reading] = program;
    return program;
}

std::string OracleAgreement::run(std::size_t unit) {
    const Unit& wanted = units_.at(unit);
    const std::shared_ptr<const build::Program> program = programOf(wanted.reading);
    const bool isBump = plan_.cases[wanted.reading].file == SourceFile::bumpySphere;
    return isBump ? runBump(wanted, *program) : runNoisy(wanted, *program);
}

std::string OracleAgreement::runNoisy(const Unit& unit, const build::Program& program) const {
    const SceneDescription scene = smooth(scenes_[unit.scene].description);
    RenderSettings settings = smallSettings();
    settings.seed = 1'000'000 + 1'000 * unit.number;
    oracle::Precision precision;
    precision.share = 0.05;
    precision.renders = kRenders;
    const Moments moments = oracle::Oracle{scene, settings, plan_.cases[unit.reading].reading}
                                .moments(unit.number + 1, precision);
    const auto images = rendersOf(program, sandbox_, scene, settings, kRenders);
    const Agreement found = compare(moments, kRenders, [&](int number) {
        return imageOf(images[static_cast<std::size_t>(number - 1)], settings);
    });
    return nlohmann::json{{"reading", plan_.cases[unit.reading].name},
                          {"scene", scenes_[unit.scene].name},
                          {"tiles", found.tiles},
                          {"largestZ", found.largestZ},
                          {"meanZ2", found.meanZ2},
                          {"varianceZ", found.varianceZ},
                          {"varianceRatio", found.varianceRatio}}
        .dump();
}

std::string OracleAgreement::runBump(const Unit& unit, const build::Program& program) const {
    const SceneDescription& scene = scenes_[unit.scene].description;
    const RenderSettings settings = bumpSettings();
    oracle::Reading reading = plan_.cases[unit.reading].reading;
    reading.lightShape = oracle::LightShape::centre;
    oracle::Mistake pinhole;
    pinhole.aperture = oracle::Mistake::Aperture::none;
    RenderSettings one = settings;
    one.dofRayCount = 1;
    one.shadowRayCount = 1;
    const raytracer::Image expected =
        oracle::Oracle{scene, one, reading, pinhole}.studentRender(1);
    const auto images = rendersOf(program, sandbox_, scene, settings, 1);
    int off = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < expected.pixels().size(); ++i) {
        const double difference = distance(expected.pixels()[i], images[0][i]);
        if (difference > kEdge)
            ++off;
        else
            largest = std::max(largest, difference);
    }
    return nlohmann::json{{"reading", plan_.cases[unit.reading].name},
                          {"scene", scenes_[unit.scene].name},
                          {"pixels", expected.pixels().size()},
                          {"off", off},
                          {"largest", largest}}
        .dump();
}

namespace {

/// All units of one reading.
struct Row {
    int units = 0;
    int comparisons = 0;
    double largestZ = 0.0;
    double sumZ2 = 0.0;
    double varianceZ = 0.0;
    int pixels = 0;
    int off = 0;
    double largest = 0.0;

    void add(const nlohmann::json& record) {
        ++units;
        if (record.contains("off")) {
            pixels += record.at("pixels").get<int>();
            off += record.at("off").get<int>();
            largest = std::max(largest, record.at("largest").get<double>());
            return;
        }
        const int tiles = record.at("tiles").get<int>();
        comparisons += tiles;
        sumZ2 += tiles * record.at("meanZ2").get<double>();
        largestZ = std::max(largestZ, record.at("largestZ").get<double>());
        varianceZ = std::max(varianceZ, record.at("varianceZ").get<double>());
    }

    [[nodiscard]] bool agrees() const {
        return largestZ < kLargestZ && varianceZ < kLargestZ && off <= kEdgeShare * pixels;
    }
};

}  // namespace

Summary OracleAgreement::summarise(const std::vector<std::string>& records) const {
    std::vector<std::pair<std::string, Row>> rows;
    for (const AgreementCase& wanted : plan_.cases)
        rows.emplace_back(wanted.name, Row{});
    for (const std::string& text : records) {
        const auto record = nlohmann::json::parse(text);
        const auto row = std::ranges::find(rows, record.at("reading").get<std::string>(),
                                           &std::pair<std::string, Row>::first);
        if (row != rows.end()) row->second.add(record);
    }
    std::string noisy =
        "| reading | scenes x rounds | tile means | largest z | mean z^2 | largest z of a variance "
        "|\n|---|---|---|---|---|---|\n";
    std::string exact =
        "| bump reading | scenes | pixels | at an edge | largest difference elsewhere |\n"
        "|---|---|---|---|---|\n";
    Summary summary;
    for (const auto& [name, row] : rows) {
        if (row.units == 0) continue;
        summary.asExpected = summary.asExpected && row.agrees();
        if (row.pixels > 0)
            exact += fmt::format("| {} | {} | {} | {} | {:.1e} |\n", name, row.units, row.pixels,
                                 row.off, row.largest);
        else
            noisy += fmt::format("| {} | {} | {} | {:.2f} | {:.3f} | {:.2f} |\n", name, row.units,
                                 row.comparisons, row.largestZ, row.sumZ2 / row.comparisons,
                                 row.varianceZ);
    }
    summary.text = noisy + "\n" + exact;
    return summary;
}

}  // namespace ticker::calibrate

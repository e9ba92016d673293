#include <grader/base/CpuTime.h>
#include <grader/base/WholeFile.h>
#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/lab/agreement/MomentAgreement.h>
#include <grader/lab/agreement/OracleAgreement.h>
#include <grader/lab/calibrate/CodeOnly.h>
#include <grader/lab/calibrate/Seed.h>

#include <raytracer/base/Error.h>
#include <raytracer/io/SceneReader.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ticker::calibrate {
namespace {

using oracle::Moments;
using raytracer::RenderSettings;
using raytracer::SceneDescription;

constexpr int kRenders = 40;
// A larger difference of a channel comes from an edge: a ray that grazes the edge of an object or
// of a texel may fall on its other side in single precision.
constexpr double kEdge = 2e-4;

RenderSettings smallSettings() {
    RenderSettings settings;
    settings.width = 32;
    settings.height = 24;
    settings.dofRayCount = 16;
    settings.shadowRayCount = 5;
    return settings;
}

// A program with one edited file uses the template's other file. Programs with bumps therefore
// render with a pinhole camera and one hard shadow ray, and those of option 2 render smooth
// spheres.
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

struct Renders {
    std::vector<std::vector<raytracer::ColourRGB>> images;
    double cpuMs = 0.0;
};

Renders rendersOf(const build::Program& program, const sandbox::Sandbox& sandbox,
                  const SceneDescription& scene, const RenderSettings& settings, int repetitions) {
    const sandbox::Limits limits;
    build::SandboxedExaminee examinee{program, sandbox, limits};
    const probe::Run run = examinee.ask({probe::RenderQuestion{scene, settings, repetitions, 0}});
    const auto& answer = std::get<probe::RenderAnswer>(run.answers.at(0));
    if (answer.state != probe::AnswerState::answered ||
        answer.images.size() != static_cast<std::size_t>(repetitions))
        throw raytracer::Error("the reference did not answer: " + run.end.detail);
    return {answer.images, examinee.cpuMs()};
}

raytracer::Image imageOf(const std::vector<raytracer::ColourRGB>& pixels,
                         const RenderSettings& settings) {
    raytracer::Image image{settings};
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image.set(x, y, pixels[static_cast<std::size_t>(y * image.width() + x)]);
    return image;
}

// Rounded, because records are also read by people.
double inThousandths(double value) {
    return std::round(1e3 * value) / 1e3;
}

double distance(const raytracer::ColourRGB& a, const raytracer::ColourRGB& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

}  // namespace

OracleAgreement::OracleAgreement(AgreementPlan plan, const build::Kit& kit,
                                 const sandbox::Sandbox& sandbox)
    : plan_(std::move(plan)), kit_(kit), sandbox_(sandbox) {
    for (const auto& entry : std::filesystem::directory_iterator(plan_.scenes))
        if (entry.path().extension() == ".xml" &&
            std::ranges::count(plan_.leftOut, entry.path().stem().string()) == 0)
            scenes_.push_back({entry.path().stem().string(), readWhole(entry.path()),
                               raytracer::readScene(entry.path(), plan_.assets)});
    std::ranges::sort(scenes_, {}, &Scene::name);
    for (std::size_t reading = 0; reading < plan_.cases.size(); ++reading)
        for (std::size_t scene = 0; scene < scenes_.size(); ++scene) {
            const bool isBump = plan_.cases[reading].isBump();
            const auto& spheres = scenes_[scene].description.spheres;
            if (isBump && std::ranges::none_of(
                              spheres, [](const auto& sphere) { return !!sphere.heightMap; }))
                continue;
            for (int round = 0; round < (isBump ? 1 : plan_.rounds); ++round)
                units_.push_back({reading, scene, round});
        }
}

std::vector<std::size_t> OracleAgreement::checkUnits() const {
    // Every thirtieth unit, so that all scenes and readings are included as they are added.
    std::vector<std::size_t> picked;
    for (std::size_t unit = 0; unit < units_.size(); unit += 30)
        picked.push_back(unit);
    return picked;
}

std::string OracleAgreement::sourceOf(const AgreementCase& wanted) const {
    return corpus::applyEdits(readWhole(plan_.reference / wanted.file), wanted.edits,
                              "the reading " + wanted.name);
}

Campaign::Basis OracleAgreement::basisOf(std::size_t unit) const {
    const AgreementCase& wanted = plan_.cases[units_.at(unit).reading];
    return {{"agreement"},
            wanted.name,
            codeOnly(sourceOf(wanted)) + "\n" + scenes_[units_[unit].scene].text};
}

std::shared_ptr<const build::Program> OracleAgreement::programOf(std::size_t reading) {
    const std::lock_guard lock{mutex_};
    if (const auto found = programs_.find(reading); found != programs_.end()) return found->second;
    const AgreementCase& wanted = plan_.cases[reading];
    const std::string name = "the reading " + wanted.name;
    build::BuildResult built =
        build::buildProgram(kit_, sandbox_, sandbox::Limits{}, wanted.file, sourceOf(wanted));
    if (!built.program) throw raytracer::Error(name + " does not compile: " + built.diagnostics);
    auto program = std::make_shared<const build::Program>(std::move(*built.program));
    programs_[reading] = program;
    return program;
}

std::pair<std::string, std::string> OracleAgreement::nameOf(std::size_t unit) const {
    return {plan_.cases[units_.at(unit).reading].name, scenes_[units_[unit].scene].name};
}

std::string OracleAgreement::unitName(std::size_t unit) const {
    const auto [reading, scene] = nameOf(unit);
    return fmt::format("{} {} {}", reading, scene, units_.at(unit).round);
}

std::string OracleAgreement::run(std::size_t unit) {
    const Unit& wanted = units_.at(unit);
    const std::shared_ptr<const build::Program> program = programOf(wanted.reading);
    const bool isBump = plan_.cases[wanted.reading].isBump();
    return isBump ? runBump(wanted, *program) : runNoisy(unit, *program);
}

std::string OracleAgreement::runNoisy(std::size_t number, const build::Program& program) const {
    const Unit& unit = units_.at(number);
    const double before = threadCpuMs();
    const std::uint64_t seed = seedOf(unitName(number));
    const SceneDescription scene = smooth(scenes_[unit.scene].description);
    RenderSettings settings = smallSettings();
    settings.seed = seed;
    oracle::Precision precision;
    precision.share = 0.05;
    precision.renders = kRenders;
    const Moments moments =
        oracle::Oracle{scene, settings, plan_.cases[unit.reading].reading}.moments(seed + 1,
                                                                                   precision);
    const Renders renders = rendersOf(program, sandbox_, scene, settings, kRenders);
    const Agreement found = compare(moments, kRenders, [&](int render) {
        return imageOf(renders.images[static_cast<std::size_t>(render - 1)], settings);
    });
    return nlohmann::json{{"reading", plan_.cases[unit.reading].name},
                          {"scene", scenes_[unit.scene].name},
                          {"tiles", found.tiles},
                          {"largestZ", inThousandths(found.largestZ)},
                          {"meanZ2", inThousandths(found.meanZ2)},
                          {"varianceZ", inThousandths(found.varianceZ)},
                          {"varianceRatio", inThousandths(found.varianceRatio)},
                          {"cpu", std::lround(threadCpuMs() - before + renders.cpuMs)}}
        .dump();
}

std::string OracleAgreement::runBump(const Unit& unit, const build::Program& program) const {
    const double before = threadCpuMs();
    const SceneDescription& scene = scenes_[unit.scene].description;
    const RenderSettings settings = bumpSettings();
    oracle::Reading reading = plan_.cases[unit.reading].reading;
    reading.lightShape = oracle::LightShape::centre;
    oracle::Mistake pinhole;
    pinhole.aperture = oracle::Mistake::Aperture::none;
    RenderSettings one = settings;
    one.dofRayCount = 1;
    one.shadowRayCount = 1;
    const raytracer::Image expected = oracle::Oracle{scene, one, reading, pinhole}.studentRender(1);
    const Renders renders = rendersOf(program, sandbox_, scene, settings, 1);
    int off = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < expected.pixels().size(); ++i) {
        const double difference = distance(expected.pixels()[i], renders.images[0][i]);
        if (difference > kEdge)
            ++off;
        else
            largest = std::max(largest, difference);
    }
    return nlohmann::json{{"reading", plan_.cases[unit.reading].name},
                          {"scene", scenes_[unit.scene].name},
                          {"pixels", expected.pixels().size()},
                          {"off", off},
                          {"largest", largest},
                          {"cpu", std::lround(threadCpuMs() - before + renders.cpuMs)}}
        .dump();
}

}  // namespace ticker::calibrate

#include <grader/lab/agreement/AgreementCases.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <utility>

namespace ticker::calibrate {
namespace {

using corpus::Edit;
using corpus::Entry;
using oracle::BumpReading;
using oracle::LightShape;
using oracle::PhongReading;
using oracle::Reading;
using oracle::ShadowReach;

std::vector<Edit> editsOf(const std::vector<Entry>& catalogue, const std::string& task,
                          const std::string& id) {
    const auto found = std::ranges::find_if(catalogue, [&](const Entry& mistake) {
        return mistake.group == task && mistake.name == id;
    });
    if (found == catalogue.end())
        throw raytracer::InputError("grader/corpus/mistakes/" + task + "/" + id + ".json", 0,
                                    "is missing; the oracle's agreement is tried on it");
    return found->edits.at("Renderer.cpp");
}

std::vector<AgreementCase> distributedCases(const std::vector<Entry>& catalogue) {
    std::vector<AgreementCase> cases{{"reference", "Renderer.cpp", {}, {}}};
    const auto add = [&](const char* name, const char* task, const char* id, auto change) {
        AgreementCase next{name, "Renderer.cpp", editsOf(catalogue, task, id), {}};
        change(next.reading);
        cases.push_back(std::move(next));
    };
    add("half-aperture", "T2.2", "accepted-half-aperture",
        [](Reading& r) { r.apertureFactor = 0.5; });
    add("surface", "T2.1", "accepted-surface",
        [](Reading& r) { r.lightShape = LightShape::surface; });
    add("uniform-radius", "T2.1", "accepted-uniform-radius",
        [](Reading& r) { r.lightShape = LightShape::uniformRadius; });
    add("original-helper", "T2.1", "clustered",
        [](Reading& r) { r.lightShape = LightShape::polarHelper; });
    add("distance-to-centre", "T2.1", "accepted-distance-to-centre",
        [](Reading& r) { r.shadowReach = ShadowReach::toCentre; });
    add("per-sample", "T2.1", "accepted-per-sample",
        [](Reading& r) { r.phong = PhongReading::perSample; });
    add("per-sample-direction", "T2.1", "accepted-per-sample-direction",
        [](Reading& r) { r.phong = PhongReading::perSampleDirection; });
    add("view-from-eye", "T2.1", "accepted-view-from-eye",
        [](Reading& r) { r.viewerIsEye = true; });
    add("bias-along-light", "T2.1", "accepted-bias-along-light",
        [](Reading& r) { r.biasAlongLight = true; });
    add("bias-1e-3", "T2.1", "accepted-bias-1e-3", [](Reading& r) { r.shadowBias = 1e-3; });
    add("bias-1e-6", "T2.1", "accepted-bias-1e-6", [](Reading& r) { r.shadowBias = 1e-6; });

    AgreementCase together{"half-aperture-surface-to-centre-eye", "Renderer.cpp", {}, {}};
    for (const auto& [task, id] : {std::pair{"T2.2", "accepted-half-aperture"},
                                   {"T2.1", "accepted-surface"},
                                   {"T2.1", "accepted-distance-to-centre"},
                                   {"T2.1", "accepted-view-from-eye"}})
        for (const Edit& edit : editsOf(catalogue, task, id))
            together.edits.push_back(edit);
    together.reading.apertureFactor = 0.5;
    together.reading.lightShape = LightShape::surface;
    together.reading.shadowReach = ShadowReach::toCentre;
    together.reading.viewerIsEye = true;
    cases.push_back(std::move(together));
    return cases;
}

// The lines of the reference that the edits below replace.
constexpr const char* kU = "longitude / (2.0 * std::numbers::pi) + 0.5;";
constexpr const char* kBu = "map.at(columnRight, row) - map.at(column, row);";
constexpr const char* kBv = "map.at(column, rowBelow) - map.at(column, row);";
constexpr const char* kTilt = "normal + Bu * normal.cross(Pv) - Bv * normal.cross(Pu)";

constexpr const char* kLeft = "map.at((column + map.width() - 1) % map.width(), row)";
constexpr const char* kAbove = "map.at(column, std::max(row - 1, 0))";

// A lambda that interpolates the height between the texels' centres; the edits of the slopes call
// it.
constexpr const char* kSmooth =
    "[&](double right, double below) {\n"
    "        const double x = u * map.width() - 0.5 + right;\n"
    "        const double y = v * map.height() - 0.5 + below;\n"
    "        const int left = static_cast<int>(std::floor(x));\n"
    "        const int top = static_cast<int>(std::floor(y));\n"
    "        const auto texel = [&](int i, int j) {\n"
    "            return map.at((i + map.width()) % map.width(),\n"
    "                          std::clamp(j, 0, map.height() - 1));\n"
    "        };\n"
    "        const double a = x - left;\n"
    "        const double b = y - top;\n"
    "        return (1 - b) * ((1 - a) * texel(left, top) + a * texel(left + 1, top)) +\n"
    "               b * ((1 - a) * texel(left, top + 1) + a * texel(left + 1, top + 1));\n"
    "    }";

std::vector<AgreementCase> bumpCases() {
    std::vector<AgreementCase> cases{{"bump-reference", "BumpySphere.cpp", {}, {}}};
    const auto add = [&](const char* name, std::vector<Edit> edits, auto change) {
        AgreementCase next{name, "BumpySphere.cpp", std::move(edits), {}};
        change(next.reading.bump);
        cases.push_back(std::move(next));
    };
    using Difference = BumpReading::Difference;
    const std::string left = kLeft;
    const std::string above = kAbove;
    add("bump-backward",
        {{kBu, "map.at(column, row) - " + left + "; (void)columnRight;"},
         {kBv, "map.at(column, row) - " + above + "; (void)rowBelow;"}},
        [](BumpReading& b) { b.difference = Difference::backward; });
    add("bump-central",
        {{kBu, "0.5 * (map.at(columnRight, row) - " + left + ");"},
         {kBv, "0.5 * (map.at(column, rowBelow) - " + above + ");"}},
        [](BumpReading& b) { b.difference = Difference::central; });
    const std::string smooth = kSmooth;
    add("bump-bilinear",
        {{kBu, smooth + "(1, 0) - " + smooth + "(0, 0); (void)columnRight;"},
         {kBv, smooth + "(0, 1) - " + smooth + "(0, 0); (void)rowBelow;"}},
        [](BumpReading& b) { b.lookup = BumpReading::Lookup::bilinear; });
    add("bump-origin-3/4", {{kU, "std::fmod(longitude / (2.0 * std::numbers::pi) + 0.75, 1.0);"}},
        [](BumpReading& b) { b.uOrigin = 0.75; });
    add("bump-mirrored",
        {{kU, "0.5 - longitude / (2.0 * std::numbers::pi);"},
         {kTilt, "normal - Bu * normal.cross(Pv) - Bv * normal.cross(Pu)"}},
        [](BumpReading& b) { b.mirrored = true; });
    add("bump-gains",
        {{kTilt, "normal + 0.4 * Bu * normal.cross(Pv) - 2.5 * Bv * normal.cross(Pu)"}},
        [](BumpReading& b) {
            b.gainU = 0.4;
            b.gainV = 2.5;
        });
    add("bump-scaled-tangent",
        {{kTilt, "normal + std::sin(polarAngle) * Bu * normal.cross(Pv) - Bv * normal.cross(Pu)"}},
        [](BumpReading& b) { b.longitudeGain = BumpReading::LatitudeGain::sine; });
    add("bump-exact-gradient",
        {{kTilt, "normal + Bu / std::sin(polarAngle) * normal.cross(Pv) - Bv * normal.cross(Pu)"}},
        [](BumpReading& b) { b.longitudeGain = BumpReading::LatitudeGain::inverseSine; });
    return cases;
}

}  // namespace

std::vector<AgreementCase> agreementCases(const std::vector<Entry>& catalogue) {
    std::vector<AgreementCase> cases = distributedCases(catalogue);
    for (AgreementCase& bump : bumpCases())
        cases.push_back(std::move(bump));
    return cases;
}

}  // namespace ticker::calibrate

#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/LightFindings.h>
#include <grader/tasks/maintick/LitSetups.h>
#include <grader/tasks/maintick/PhongModel.h>
#include <grader/tasks/maintick/Threads.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/RunEnd.h>

#include <fmt/core.h>

#include <array>
#include <utility>
#include <variant>

namespace ticker::tasks {
namespace {

using maintick::isNear;
using maintick::LitSetup;
using maintick::PhongSlip;
using maintick::words;

/// A mistake under its name, with what mends it where the name's own hint is too general.
struct NamedSlip {
    PhongSlip slip;
    const FindingText* finding;
    const char* hint = "";
};

// In the order in which the first that explains everything is named.
constexpr std::array kPhongSlips{
    NamedSlip{PhongSlip::flat, &kPhongUnlit},
    NamedSlip{PhongSlip::lightsMissing, &kPhongUnlit},
    NamedSlip{PhongSlip::ambientMissing, &kPhongAmbient,
              "Ambient light is missing: begin with object.colour() * scene.ambientLighting()."},
    NamedSlip{PhongSlip::ambientPerLight, &kPhongAmbient,
              "Ambient light is added once for each point light: add it before the loop."},
    NamedSlip{PhongSlip::ambientTimesKd, &kPhongAmbient,
              "Ambient light has no coefficient: leave phongKD() out of it."},
    NamedSlip{PhongSlip::ambientColourless, &kPhongAmbient,
              "Ambient light takes the colour of the surface: multiply by object.colour()."},
    NamedSlip{PhongSlip::diffuseMissing, &kPhongDiffuse,
              "The diffuse term is missing: add object.colour() * I * (object.phongKD() * max(0, "
              "N.L)) for every light."},
    NamedSlip{PhongSlip::diffuseColourless, &kPhongDiffuse,
              "Multiply the diffuse term by object.colour()."},
    NamedSlip{PhongSlip::diffuseWithoutI, &kPhongDiffuse,
              "Multiply the diffuse term by I, what arrives of the light."},
    NamedSlip{PhongSlip::diffuseWithoutKd, &kPhongDiffuse,
              "Multiply the diffuse term by object.phongKD()."},
    NamedSlip{PhongSlip::diffuseLightTwice, &kPhongDiffuse,
              "I holds the colour of the light already: leave light.colour() out of the diffuse "
              "term."},
    NamedSlip{PhongSlip::specularMissing, &kPhongSpecular,
              "The specular term is missing: add light.colour() * I * (object.phongKS() * "
              "pow(max(0, R.V), object.phongAlpha())) for every light."},
    NamedSlip{
        PhongSlip::specularObjectColour, &kPhongSpecular,
        "Highlights take the colour of the light, not of the surface: light.colour() in place "
        "of object.colour()."},
    NamedSlip{PhongSlip::specularLightOnce, &kPhongSpecular,
              "Highlights are multiplied by light.colour() as well as by I: the exercise takes the "
              "colour of the light twice."},
    NamedSlip{PhongSlip::specularWithoutI, &kPhongSpecular,
              "Multiply the specular term by I, what arrives of the light."},
    NamedSlip{PhongSlip::specularWithoutKs, &kPhongSpecular,
              "Multiply the specular term by object.phongKS()."},
    NamedSlip{PhongSlip::specularAlphaMissing, &kPhongSpecular,
              "Raise max(0, R.V) to the power object.phongAlpha()."},
    NamedSlip{PhongSlip::specularPowerOfAll, &kPhongSpecular,
              "Only max(0, R.V) is raised to the power; multiply by phongKS() afterwards."},
    NamedSlip{PhongSlip::coefficientsExchanged, &kPhongWrong,
              "phongKD() belongs to the diffuse term and phongKS() to the specular one: they are "
              "exchanged."},
    NamedSlip{PhongSlip::halfVector, &kPhongSpecular,
              "That is N.H with the half vector (Blinn); the exercise takes R.V (Phong), with R = "
              "L.reflectIn(N)."},
    NamedSlip{PhongSlip::viewFromCamera, &kPhongViewer,
              "V points to the origin of the world here. It is (O - P).normalised(): behind a "
              "mirror O is not the camera."},
    NamedSlip{PhongSlip::viewReversed, &kPhongViewer,
              "V or R points the wrong way: V is (O - P).normalised() and R is L.reflectIn(N)."},
    NamedSlip{PhongSlip::mirrorOfView, &kPhongViewer,
              "V or R points the wrong way: V is (O - P).normalised() and R is L.reflectIn(N)."},
    NamedSlip{PhongSlip::viewNotUnit, &kPhongViewer, "V needs length 1: add .normalised()."},
    NamedSlip{PhongSlip::viewIsO, &kPhongViewer,
              "O is a place, no direction: V is (O - P).normalised()."},
    NamedSlip{PhongSlip::cosineOfNandV, &kPhongSpecular,
              "That is N.V; the exercise takes R.V with R = L.reflectIn(N)."},
    NamedSlip{PhongSlip::cosineOfLandV, &kPhongSpecular,
              "That is L.V; the exercise takes R.V with R = L.reflectIn(N)."},
    NamedSlip{PhongSlip::lightNotUnit, &kPhongLightWay,
              "L needs length 1: (light.position() - P).normalised()."},
    NamedSlip{PhongSlip::lightReversed, &kPhongLightWay,
              "L points away from the light: it is (light.position() - P).normalised()."},
    NamedSlip{
        PhongSlip::lightFromWorldOrigin, &kPhongLightWay,
        "light.position() is a place, no direction: L is (light.position() - P).normalised()."},
    NamedSlip{PhongSlip::facingUnclamped, &kPhongClamp,
              "N.L is negative for a light behind the surface: take std::max(0.0, N.dot(L))."},
    NamedSlip{PhongSlip::facingAbsolute, &kPhongClamp,
              "The absolute value lights a surface from behind: take std::max(0.0, N.dot(L))."},
    NamedSlip{PhongSlip::mirroredUnclamped, &kPhongClamp,
              "An even power makes a negative R.V positive: take std::max(0.0, R.dot(V)) before "
              "std::pow."},
    NamedSlip{PhongSlip::mirroredAbsolute, &kPhongClamp,
              "The absolute value makes highlights away from the mirrored ray: take std::max(0.0, "
              "R.dot(V)) before std::pow."},
    NamedSlip{PhongSlip::bothUnclamped, &kPhongClamp},
    NamedSlip{
        PhongSlip::normalTurned, &kPhongClamp,
        "N is turned to the viewer here, so that the back of a surface is lit like its front: "
        "take N as it is handed over."},
    NamedSlip{PhongSlip::defaultCoefficients, &kPhongWrong,
              "The coefficients are the usual ones, whatever the object's are: take "
              "object.phongKD(), object.phongKS() and object.phongAlpha()."},
    NamedSlip{PhongSlip::farLightsMissing, &kPhongFalloff,
              "Lights that are far away count as well: leave no light out for its distance."},
    NamedSlip{PhongSlip::lastHighlightOnly, &kPhongLights,
              "Only the last light has a highlight: add (+=) the specular terms as well."},
    NamedSlip{PhongSlip::falloffMissing, &kPhongFalloff,
              "The light does not fade: I is light.illuminationAt(d), where d is the distance "
              "between P and the light, (light.position() - P).magnitude()."},
    NamedSlip{PhongSlip::falloffLinear, &kPhongFalloff},
    NamedSlip{PhongSlip::falloffSquaredAgain, &kPhongFalloff,
              "illuminationAt squares the distance itself: hand it d, not d * d."},
    NamedSlip{PhongSlip::falloffFromViewer, &kPhongFalloff},
    NamedSlip{PhongSlip::falloffFromOrigin, &kPhongFalloff},
    NamedSlip{PhongSlip::fourPiMissing, &kPhongFalloff,
              "I is divided by 4 pi d^2: light.illuminationAt(d) does it."},
    NamedSlip{PhongSlip::firstLightOnly, &kPhongLights,
              "Only the first light counts: a return or break stands inside of the loop."},
    NamedSlip{PhongSlip::lastLightOnly, &kPhongLights,
              "Only the last light counts: add its terms (+=) instead of assigning them (=)."},
    NamedSlip{PhongSlip::averaged, &kPhongLights, "Lights add up: do not divide by their number."},
    NamedSlip{PhongSlip::clamped, &kPhongRange},
};

const FindingText& nameOf(maintick::LitKind kind) {
    switch (kind) {
        case maintick::LitKind::ambient:
            return kPhongAmbient;
        case maintick::LitKind::diffuse:
            return kPhongDiffuse;
        case maintick::LitKind::specular:
            return kPhongSpecular;
        case maintick::LitKind::behind:
            return kPhongClamp;
        case maintick::LitKind::several:
            return kPhongLights;
        case maintick::LitKind::bright:
            return kPhongRange;
        case maintick::LitKind::far:
            return kPhongFalloff;
        default:
            return kPhongWrong;
    }
}

std::string askedOf(const LitSetup& setup) {
    std::string text =
        fmt::format("illuminate was asked about P = {} with N = {}, seen from O = {}",
                    words(setup.P), words(setup.N), words(setup.O));
    if (setup.scene.pointLights.empty()) return text + ", without any point light";
    text += ", lit from";
    for (const auto& light : setup.scene.pointLights)
        text += " " + words(light.position());
    return text;
}

bool explains(PhongSlip slip, const std::vector<maintick::LitQuestion>& asked,
              const std::vector<ColourRGB>& given) {
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (!isNear(given[i], maintick::phongWith(slip, asked[i].setup))) return false;
    return true;
}

std::optional<Finding> check(const std::vector<maintick::LitQuestion>& asked,
                             const std::vector<ColourRGB>& given) {
    std::size_t first = 0;
    const auto expected = [&](std::size_t i) {
        return maintick::phongWith(PhongSlip::none, asked[i].setup);
    };
    while (first < asked.size() && isNear(given[first], expected(first)))
        ++first;
    if (first == asked.size()) return std::nullopt;
    const std::string seen = fmt::format("{}: expected {}, got {}.", askedOf(asked[first].setup),
                                         words(expected(first)), words(given[first]));
    for (const NamedSlip& named : kPhongSlips)
        if (explains(named.slip, asked, given))
            return maintick::failure(*named.finding, seen, named.hint);
    return maintick::failure(nameOf(asked[first].kind), seen);
}

}  // namespace

TaskJudgement judgePhong(probe::Examinee& examinee, std::uint64_t seed) {
    const std::vector<maintick::LitQuestion> asked = maintick::drawLitQuestions(seed);
    std::vector<probe::Question> questions;
    for (const maintick::LitQuestion& one : asked)
        questions.emplace_back(maintick::questionOf(one.setup));
    const probe::Run run = examinee.ask(questions);
    if (auto blocked = judgeUnanswered(run, "Renderer::illuminate")) return *std::move(blocked);
    std::vector<ColourRGB> given;
    for (const probe::Answer& answer : run.answers)
        given.push_back(std::get<probe::IlluminateAnswer>(answer).colours.at(0));
    std::vector<Finding> findings;
    auto wrong = check(asked, given);
    if (!wrong)
        wrong = maintick::checkThreads(examinee, seed, maintick::Shows::floor, kPhongThreadsMixed);
    if (wrong) findings.push_back(*std::move(wrong));
    return judgementOf(std::move(findings), kPhongFindings);
}

}  // namespace ticker::tasks

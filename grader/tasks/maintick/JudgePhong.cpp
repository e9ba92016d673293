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
using maintick::PhongMistake;
using maintick::words;

/// A mistake under its name, with what mends it where the name's own hint is too general.
struct NamedMistake {
    PhongMistake mistake;
    const FindingText* finding;
    const char* hint = "";
};

// In the order in which the first that explains everything is named.
constexpr std::array kPhongMistakes{
    NamedMistake{PhongMistake::flat, &kPhongUnlit},
    NamedMistake{PhongMistake::lightsMissing, &kPhongUnlit},
    NamedMistake{PhongMistake::ambientMissing, &kPhongAmbient,
                 "Ambient light is missing: begin with object.colour() * scene.ambientLighting()."},
    NamedMistake{PhongMistake::ambientPerLight, &kPhongAmbient,
                 "Ambient light is added once for each point light: add it before the loop."},
    NamedMistake{PhongMistake::ambientTimesKd, &kPhongAmbient,
                 "Ambient light has no coefficient: leave phongKD() out of it."},
    NamedMistake{PhongMistake::ambientColourless, &kPhongAmbient,
                 "Ambient light takes the colour of the surface: multiply by object.colour()."},
    NamedMistake{
        PhongMistake::diffuseMissing, &kPhongDiffuse,
        "The diffuse term is missing: add object.colour() * I * (object.phongKD() * max(0, "
        "N.L)) for every light."},
    NamedMistake{PhongMistake::diffuseColourless, &kPhongDiffuse,
                 "Multiply the diffuse term by object.colour()."},
    NamedMistake{PhongMistake::diffuseWithoutI, &kPhongDiffuse,
                 "Multiply the diffuse term by I, what arrives of the light."},
    NamedMistake{PhongMistake::diffuseWithoutKd, &kPhongDiffuse,
                 "Multiply the diffuse term by object.phongKD()."},
    NamedMistake{PhongMistake::diffuseLightTwice, &kPhongDiffuse,
                 "I holds the colour of the light already: leave light.colour() out of the diffuse "
                 "term."},
    NamedMistake{PhongMistake::specularMissing, &kPhongSpecular,
                 "The specular term is missing: add light.colour() * I * (object.phongKS() * "
                 "pow(max(0, R.V), object.phongAlpha())) for every light."},
    NamedMistake{
        PhongMistake::specularObjectColour, &kPhongSpecular,
        "Highlights take the colour of the light, not of the surface: light.colour() in place "
        "of object.colour()."},
    NamedMistake{
        PhongMistake::specularLightOnce, &kPhongSpecular,
        "Highlights are multiplied by light.colour() as well as by I: the exercise takes the "
        "colour of the light twice."},
    NamedMistake{PhongMistake::specularWithoutI, &kPhongSpecular,
                 "Multiply the specular term by I, what arrives of the light."},
    NamedMistake{PhongMistake::specularWithoutKs, &kPhongSpecular,
                 "Multiply the specular term by object.phongKS()."},
    NamedMistake{PhongMistake::specularAlphaMissing, &kPhongSpecular,
                 "Raise max(0, R.V) to the power object.phongAlpha()."},
    NamedMistake{PhongMistake::specularPowerOfAll, &kPhongSpecular,
                 "Only max(0, R.V) is raised to the power; multiply by phongKS() afterwards."},
    NamedMistake{
        PhongMistake::coefficientsExchanged, &kPhongWrong,
        "phongKD() belongs to the diffuse term and phongKS() to the specular one: they are "
        "exchanged."},
    NamedMistake{
        PhongMistake::halfVector, &kPhongSpecular,
        "That is N.H with the half vector (Blinn); the exercise takes R.V (Phong), with R = "
        "L.reflectIn(N)."},
    NamedMistake{PhongMistake::viewFromCamera, &kPhongViewer,
                 "V points to the origin of the world here. It is (O - P).normalised(): behind a "
                 "mirror O is not the camera."},
    NamedMistake{PhongMistake::viewReversed, &kPhongViewer,
                 "V or R points the wrong way: V is (O - P).normalised() and R is L.reflectIn(N)."},
    NamedMistake{PhongMistake::mirrorOfView, &kPhongViewer,
                 "V or R points the wrong way: V is (O - P).normalised() and R is L.reflectIn(N)."},
    NamedMistake{PhongMistake::viewNotUnit, &kPhongViewer, "V needs length 1: add .normalised()."},
    NamedMistake{PhongMistake::viewIsO, &kPhongViewer,
                 "O is a place, no direction: V is (O - P).normalised()."},
    NamedMistake{PhongMistake::cosineOfNandV, &kPhongSpecular,
                 "That is N.V; the exercise takes R.V with R = L.reflectIn(N)."},
    NamedMistake{PhongMistake::cosineOfLandV, &kPhongSpecular,
                 "That is L.V; the exercise takes R.V with R = L.reflectIn(N)."},
    NamedMistake{PhongMistake::lightNotUnit, &kPhongLightWay,
                 "L needs length 1: (light.position() - P).normalised()."},
    NamedMistake{PhongMistake::lightReversed, &kPhongLightWay,
                 "L points away from the light: it is (light.position() - P).normalised()."},
    NamedMistake{
        PhongMistake::lightFromWorldOrigin, &kPhongLightWay,
        "light.position() is a place, no direction: L is (light.position() - P).normalised()."},
    NamedMistake{PhongMistake::facingUnclamped, &kPhongClamp,
                 "N.L is negative for a light behind the surface: take std::max(0.0, N.dot(L))."},
    NamedMistake{PhongMistake::facingAbsolute, &kPhongClamp,
                 "The absolute value lights a surface from behind: take std::max(0.0, N.dot(L))."},
    NamedMistake{PhongMistake::mirroredUnclamped, &kPhongClamp,
                 "An even power makes a negative R.V positive: take std::max(0.0, R.dot(V)) before "
                 "std::pow."},
    NamedMistake{
        PhongMistake::mirroredAbsolute, &kPhongClamp,
        "The absolute value makes highlights away from the mirrored ray: take std::max(0.0, "
        "R.dot(V)) before std::pow."},
    NamedMistake{PhongMistake::bothUnclamped, &kPhongClamp},
    NamedMistake{
        PhongMistake::normalTurned, &kPhongClamp,
        "N is turned to the viewer here, so that the back of a surface is lit like its front: "
        "take N as it is handed over."},
    NamedMistake{PhongMistake::defaultCoefficients, &kPhongWrong,
                 "The coefficients are the usual ones, whatever the object's are: take "
                 "object.phongKD(), object.phongKS() and object.phongAlpha()."},
    NamedMistake{PhongMistake::farLightsMissing, &kPhongFalloff,
                 "Lights that are far away count as well: leave no light out for its distance."},
    NamedMistake{PhongMistake::lastHighlightOnly, &kPhongLights,
                 "Only the last light has a highlight: add (+=) the specular terms as well."},
    NamedMistake{PhongMistake::falloffMissing, &kPhongFalloff,
                 "The light does not fade: I is light.illuminationAt(d), where d is the distance "
                 "between P and the light, (light.position() - P).magnitude()."},
    NamedMistake{PhongMistake::falloffLinear, &kPhongFalloff},
    NamedMistake{PhongMistake::falloffSquaredAgain, &kPhongFalloff,
                 "illuminationAt squares the distance itself: hand it d, not d * d."},
    NamedMistake{PhongMistake::falloffFromViewer, &kPhongFalloff},
    NamedMistake{PhongMistake::falloffFromOrigin, &kPhongFalloff},
    NamedMistake{PhongMistake::fourPiMissing, &kPhongFalloff,
                 "I is divided by 4 pi d^2: light.illuminationAt(d) does it."},
    NamedMistake{PhongMistake::firstLightOnly, &kPhongLights,
                 "Only the first light counts: a return or break stands inside of the loop."},
    NamedMistake{PhongMistake::lastLightOnly, &kPhongLights,
                 "Only the last light counts: add its terms (+=) instead of assigning them (=)."},
    NamedMistake{PhongMistake::averaged, &kPhongLights,
                 "Lights add up: do not divide by their number."},
    NamedMistake{PhongMistake::clamped, &kPhongRange},
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

bool explains(PhongMistake mistake, const std::vector<maintick::LitQuestion>& asked,
              const std::vector<ColourRGB>& given) {
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (!isNear(given[i], maintick::phongWith(mistake, asked[i].setup))) return false;
    return true;
}

std::optional<Finding> check(const std::vector<maintick::LitQuestion>& asked,
                             const std::vector<ColourRGB>& given) {
    std::size_t first = 0;
    const auto expected = [&](std::size_t i) {
        return maintick::phongWith(PhongMistake::none, asked[i].setup);
    };
    while (first < asked.size() && isNear(given[first], expected(first)))
        ++first;
    if (first == asked.size()) return std::nullopt;
    const std::string seen = fmt::format("{}: expected {}, got {}.", askedOf(asked[first].setup),
                                         words(expected(first)), words(given[first]));
    for (const NamedMistake& named : kPhongMistakes)
        if (explains(named.mistake, asked, given))
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

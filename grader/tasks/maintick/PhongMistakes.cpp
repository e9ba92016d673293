#include <grader/tasks/maintick/LightFindings.h>
#include <grader/tasks/maintick/PhongModel.h>

#include <numbers>
#include <utility>

namespace ticker::tasks::maintick {
namespace {

using Step = PhongStep;
using Terms = PhongTerms;

void withUsualCoefficients(Terms& t) {
    const ColourRGB colour = t.material.colour;
    t.material = {};
    t.material.colour = colour;
}

void withPowerOfAll(Terms& t) {
    const double share = std::pow(t.material.phongKS * t.mirrored, t.material.phongAlpha);
    t.ownSpecular = t.lamp().colour() * t.arriving * share;
}

void withNormalTurnedToViewer(Terms& t) {
    if (t.setup.N.dot(t.V) < 0.0) t.facing = -t.facing;
}

double unclampedMirrored(const Terms& t) {
    return t.L.reflectIn(t.setup.N).dot(t.V);
}

/// Drops this light's terms if `ends` holds for any of the first `lights` lights, as if the loop
/// had ended there.
template <class Ends>
void endAt(Terms& t, std::size_t lights, const Ends& ends) {
    for (std::size_t i = 0; i < lights; ++i) {
        const Vector3 path = t.setup.scene.pointLights[i].position() - t.setup.P;
        if (ends(path.normalised())) t.ownDiffuse = t.ownSpecular = {};
    }
}

void endAtLightBehind(Terms& t) {
    endAt(t, t.light + 1, [&](const Vector3& L) { return t.setup.N.dot(L) <= 0.0; });
}

void endAfterLightWithoutHighlight(Terms& t) {
    endAt(t, t.light, [&](const Vector3& L) { return L.reflectIn(t.setup.N).dot(t.V) <= 0.0; });
}

constexpr const char* kFadesNot =
    "The light does not fade: I is light.illuminationAt(d), where d is the distance between P and "
    "the light, (light.position() - P).magnitude().";

constexpr PhongMistake kPhongMistakes[] = {
    {&kPhongUnlit, Step::colour, [](Terms& t) { t.colour = t.material.colour; }},
    {&kPhongUnlit, Step::colour, [](Terms& t) { t.colour = t.ambient; }},
    {&kPhongAmbient, Step::material, [](Terms& t) { t.ambient = {}; },
     "Ambient light is missing: begin with object.colour() * scene.ambientLighting()."},
    {&kPhongAmbient, Step::colour,
     [](Terms& t) { t.colour += t.ambient * (static_cast<double>(t.light) - 1.0); },
     "Ambient light is added once for each point light: add it before the loop."},
    {&kPhongAmbient, Step::colour,
     [](Terms& t) { t.colour += t.ambient * static_cast<double>(t.light); },
     "Ambient light is added before the loop and once more for each light: add it before the loop "
     "alone."},
    {&kPhongAmbient, Step::colour,
     [](Terms& t) {
         if (t.light > 0) t.colour = t.diffuse + t.specular;
     },
     "Ambient light is missing wherever a light arrives: add it once for every point, before the "
     "loop, lit or not."},
    {&kPhongAmbient, Step::material, [](Terms& t) { t.ambient *= t.material.phongKD; },
     "Ambient light has no coefficient: leave phongKD() out of it."},
    {&kPhongAmbient, Step::material, [](Terms& t) { t.ambient = t.setup.scene.ambientLighting; },
     "Ambient light takes the colour of the surface: multiply by object.colour()."},
    {&kPhongDiffuse, Step::light, [](Terms& t) { t.ownDiffuse = {}; },
     "The diffuse term is missing: add object.colour() * I * (object.phongKD() * max(0, N.L)) for "
     "every light."},
    {&kPhongDiffuse, Step::light,
     [](Terms& t) { t.ownDiffuse = t.arriving * (t.material.phongKD * t.facing); },
     "Multiply the diffuse term by object.colour()."},
    {&kPhongDiffuse, Step::light,
     [](Terms& t) { t.ownDiffuse = t.material.colour * (t.material.phongKD * t.facing); },
     "Multiply the diffuse term by I, what arrives of the light."},
    {&kPhongDiffuse, Step::material, [](Terms& t) { t.material.phongKD = 1.0; },
     "Multiply the diffuse term by object.phongKD()."},
    {&kPhongDiffuse, Step::light, [](Terms& t) { t.ownDiffuse = t.ownDiffuse * t.lamp().colour(); },
     "I holds the colour of the light already: leave light.colour() out of the diffuse term."},
    {&kPhongSpecular, Step::light, [](Terms& t) { t.ownSpecular = {}; },
     "The specular term is missing: add light.colour() * I * (object.phongKS() * pow(max(0, R.V), "
     "object.phongAlpha())) for every light."},
    {&kPhongSpecular, Step::light,
     [](Terms& t) { t.ownSpecular = t.material.colour * t.arriving * t.share; },
     "Highlights take the colour of the light, not of the surface: light.colour() in place of "
     "object.colour()."},
    {&kPhongSpecular, Step::light, [](Terms& t) { t.ownSpecular = t.arriving * t.share; },
     "Highlights are multiplied by light.colour() as well as by I: the exercise takes the colour "
     "of the light twice."},
    {&kPhongSpecular, Step::light, [](Terms& t) { t.ownSpecular = t.lamp().colour() * t.share; },
     "Multiply the specular term by I, what arrives of the light."},
    {&kPhongSpecular, Step::material, [](Terms& t) { t.material.phongKS = 1.0; },
     "Multiply the specular term by object.phongKS()."},
    {&kPhongSpecular, Step::material, [](Terms& t) { t.material.phongAlpha = 1.0; },
     "Raise max(0, R.V) to the power object.phongAlpha()."},
    {&kPhongSpecular, Step::light, withPowerOfAll,
     "Only max(0, R.V) is raised to the power; multiply by phongKS() afterwards."},
    {&kPhongSpecular, Step::light,
     [](Terms& t) {
         if (t.share > 1.0) t.ownSpecular = t.lamp().colour() * t.arriving;
     },
     "A highlight may be brighter than the light that makes it: leave out the limit of 1 for "
     "phongKS() times the power."},
    {&kPhongWrong, Step::material,
     [](Terms& t) { std::swap(t.material.phongKD, t.material.phongKS); },
     "phongKD() belongs to the diffuse term and phongKS() to the specular one: they are "
     "exchanged."},
    {&kPhongSpecular, Step::cosines,
     [](Terms& t) { t.mirrored = t.setup.N.dot((t.L + t.V).normalised()); },
     "That is N.H with the half vector (Blinn); the exercise takes R.V (Phong), with R = "
     "L.reflectIn(N)."},
    {&kPhongViewer, Step::ways, [](Terms& t) { t.V = (-t.setup.P).normalised(); },
     "V points to the origin of the world here. It is (O - P).normalised(): behind a mirror O is "
     "not the camera."},
    {&kPhongViewer, Step::ways, [](Terms& t) { t.V = -t.V; },
     "V or R points the wrong way: V is (O - P).normalised() and R is L.reflectIn(N)."},
    {&kPhongViewer, Step::cosines, [](Terms& t) { t.mirrored = -t.mirrored; },
     "V or R points the wrong way: V is (O - P).normalised() and R is L.reflectIn(N)."},
    {&kPhongViewer, Step::ways, [](Terms& t) { t.V = t.setup.O - t.setup.P; },
     "V needs length 1: add .normalised()."},
    {&kPhongViewer, Step::ways, [](Terms& t) { t.V = t.setup.O.normalised(); },
     "O is a place, no direction: V is (O - P).normalised()."},
    {&kPhongSpecular, Step::cosines, [](Terms& t) { t.mirrored = t.setup.N.dot(t.V); },
     "That is N.V; the exercise takes R.V with R = L.reflectIn(N)."},
    {&kPhongSpecular, Step::cosines, [](Terms& t) { t.mirrored = t.L.dot(t.V); },
     "That is L.V; the exercise takes R.V with R = L.reflectIn(N)."},
    {&kPhongLightWay, Step::ways, [](Terms& t) { t.L = t.path(); },
     "L needs length 1: (light.position() - P).normalised()."},
    {&kPhongLightWay, Step::ways, [](Terms& t) { t.L = -t.L; },
     "L points away from the light: it is (light.position() - P).normalised()."},
    {&kPhongLightWay, Step::ways, [](Terms& t) { t.L = t.lamp().position().normalised(); },
     "light.position() is a place, no direction: L is (light.position() - P).normalised()."},
    {&kPhongClamp, Step::clamped, [](Terms& t) { t.facing = t.setup.N.dot(t.L); },
     "N.L is negative for a light behind the surface: take std::max(0.0, N.dot(L))."},
    {&kPhongClamp, Step::cosines, [](Terms& t) { t.facing = std::abs(t.facing); },
     "The absolute value lights a surface from behind: take std::max(0.0, N.dot(L))."},
    {&kPhongClamp, Step::clamped, [](Terms& t) { t.mirrored = unclampedMirrored(t); },
     "An even power makes a negative R.V positive: take std::max(0.0, R.dot(V)) before std::pow."},
    {&kPhongClamp, Step::cosines, [](Terms& t) { t.mirrored = std::abs(t.mirrored); },
     "The absolute value makes highlights away from the mirrored ray: take std::max(0.0, "
     "R.dot(V)) before std::pow."},
    {&kPhongClamp, Step::clamped,
     [](Terms& t) {
         t.facing = t.setup.N.dot(t.L);
         t.mirrored = unclampedMirrored(t);
     }},
    {&kPhongClamp, Step::cosines, withNormalTurnedToViewer,
     "N is turned to the viewer here, so that the back of a surface is lit like its front: take N "
     "as it is handed over."},
    {&kPhongWrong, Step::material, withUsualCoefficients,
     "The coefficients are the usual ones, whatever the object's are: take object.phongKD(), "
     "object.phongKS() and object.phongAlpha()."},
    {&kPhongFalloff, Step::light,
     [](Terms& t) {
         constexpr double kFar = 10.0;
         if (t.distance > kFar) t.ownDiffuse = t.ownSpecular = {};
     },
     "Lights that are far away count as well: leave no light out for its distance."},
    {&kPhongLights, Step::light, [](Terms& t) { t.specular = {}; },
     "Only the last light has a highlight: add (+=) the specular terms as well."},
    {&kPhongFalloff, Step::ways, [](Terms& t) { t.distance = 1.0; }, kFadesNot},
    {&kPhongFalloff, Step::ways,
     [](Terms& t) { t.distance = 1.0 / std::sqrt(4.0 * std::numbers::pi); }, kFadesNot},
    {&kPhongFalloff, Step::ways, [](Terms& t) { t.distance = std::sqrt(t.distance); }},
    {&kPhongFalloff, Step::ways, [](Terms& t) { t.distance *= t.distance; },
     "illuminationAt squares the distance itself: hand it d, not d * d."},
    {&kPhongFalloff, Step::ways,
     [](Terms& t) { t.distance = (t.lamp().position() - t.setup.O).magnitude(); }},
    {&kPhongFalloff, Step::ways, [](Terms& t) { t.distance = t.lamp().position().magnitude(); }},
    {&kPhongFalloff, Step::ways, [](Terms& t) { t.distance /= std::sqrt(4.0 * std::numbers::pi); },
     "I is divided by 4 pi d^2: light.illuminationAt(d) does it."},
    {&kPhongLights, Step::light,
     [](Terms& t) {
         if (t.light > 0) t.ownDiffuse = t.ownSpecular = {};
     },
     "Only the first light counts: a return or break stands inside of the loop."},
    {&kPhongLights, Step::light, endAtLightBehind,
     "A light behind the surface (N.L <= 0) ends the loop, and later lights are lost: go on with "
     "the next one (continue, not break or return)."},
    {&kPhongLights, Step::light, endAfterLightWithoutHighlight,
     "A light without a highlight (R.V <= 0) ends the loop, and later lights are lost: go on with "
     "the next one (continue, not break or return)."},
    {&kPhongLights, Step::light,
     [](Terms& t) {
         constexpr double kByte = 1.0 / 255.0;
         const ColourRGB own = t.ownDiffuse + t.ownSpecular;
         if (std::max({own.r, own.g, own.b}) < kByte) t.ownDiffuse = t.ownSpecular = {};
     },
     kFaintLight},
    {&kPhongLights, Step::light, [](Terms& t) { t.diffuse = t.specular = {}; },
     "Only the last light counts: add (+=) its diffuse and its specular term alone, and add "
     "ambient light once, before the loop."},
    {&kPhongLights, Step::colour,
     [](Terms& t) {
         const double lights = std::max(1.0, static_cast<double>(t.light));
         t.colour = t.ambient + (t.diffuse + t.specular) / lights;
     },
     "Lights add up: do not divide by their number."},
    {&kPhongFalloff, Step::ways, [](Terms& t) { t.distance = std::max(1.0, t.distance); },
     "Lights nearer than 1 are brighter still: leave out the limit of the distance."},
    {&kPhongRange, Step::colour,
     [](Terms& t) {
         t.colour = {std::min(1.0, t.colour.r), std::min(1.0, t.colour.g),
                     std::min(1.0, t.colour.b)};
     }},
    {&kPhongSpecular, Step::clamped,
     [](Terms& t) {
         constexpr double kRim = 0.25;
         if (t.mirrored < kRim) t.mirrored = 0.0;
     },
     "A highlight fades out by itself: leave out the limit below which R.V counts as 0."},
    {&kPhongDiffuse, Step::material,
     [](Terms& t) { t.material.phongKD = std::min(1.0, t.material.phongKD); },
     "phongKD() may be above 1: leave out the limit of 1."},
    {&kPhongSpecular, Step::material,
     [](Terms& t) { t.material.phongKS = std::min(1.0, t.material.phongKS); },
     "phongKS() may be above 1: leave out the limit of 1."},
};

}  // namespace

std::span<const PhongMistake> phongMistakes() {
    return kPhongMistakes;
}

}  // namespace ticker::tasks::maintick

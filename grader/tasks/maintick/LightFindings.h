#ifndef TICKER_TASKS_MAINTICK_LIGHTFINDINGS_H
#define TICKER_TASKS_MAINTICK_LIGHTFINDINGS_H

#include <grader/result/FindingText.h>

#include <array>

namespace ticker::tasks {

// What can be said about Phong illumination (M2) and shadows (M3.2).

inline constexpr std::string_view kPhongSection = "Phong illumination (M2)";
inline constexpr std::string_view kShadeSection = "Shadows (M3.2)";

inline constexpr FindingText kPhongAmbient{
    .id = "phong.ambient",
    .words = "got ambient light wrong",
    .meaning = "a point without any point light has another colour",
    .hint =
        "Ambient light is object.colour() * scene.ambientLighting(), once, before the loop over "
        "the lights.",
    .section = kPhongSection};
inline constexpr FindingText kPhongDiffuse{
    .id = "phong.diffuse",
    .words = "got diffuse light wrong",
    .meaning = "a surface without highlights has another colour",
    .hint =
        "The diffuse term is object.colour() * I * (object.phongKD() * max(0, N.L)), with N and "
        "L of length 1.",
    .section = kPhongSection};
inline constexpr FindingText kPhongSpecular{
    .id = "phong.specular",
    .words = "got highlights wrong",
    .meaning = "a surface without diffuse light has another colour",
    .hint =
        "The specular term is light.colour() * I * (object.phongKS() * pow(max(0, R.V), "
        "object.phongAlpha())), with R and V of length 1.",
    .section = kPhongSection};
inline constexpr FindingText kPhongViewer{
    .id = "phong.viewer",
    .words = "looked from another place than O",
    .meaning = "V does not point from P to O",
    .hint = "V is (O - P).normalised(): O is where the ray started, the camera or the last mirror.",
    .section = kPhongSection};
inline constexpr FindingText kPhongLightWay{
    .id = "phong.light-direction",
    .words = "took another direction to the light",
    .meaning = "L does not point from P to the light with length 1",
    .hint = "L is (light.position() - P).normalised().",
    .section = kPhongSection};
inline constexpr FindingText kPhongFalloff{
    .id = "phong.falloff",
    .words = "let light fade wrongly with distance",
    .meaning = "another law than 1 / (4 pi d^2), or another distance",
    .hint = "I is light.illuminationAt(d) with d = (light.position() - P).magnitude().",
    .section = kPhongSection};
inline constexpr FindingText kPhongClamp{
    .id = "phong.clamp",
    .words = "let light come from behind",
    .meaning = "N.L or R.V counts where it is negative",
    .hint =
        "Take std::max(0.0, N.dot(L)) and std::max(0.0, R.dot(V)), the latter before the power.",
    .section = kPhongSection};
inline constexpr FindingText kPhongLights{
    .id = "phong.lights",
    .words = "mixed up several point lights",
    .meaning = "right with one light, wrong with two",
    .hint =
        "Add (+=) the terms of every light of scene.pointLights() to one colour, and return it "
        "after the loop.",
    .section = kPhongSection};
inline constexpr FindingText kPhongRange{
    .id = "phong.range",
    .words = "cut bright colours off",
    .meaning = "no channel exceeds 1",
    .hint =
        "Colours are not clamped: the tone curve brings them into range when the picture is "
        "written.",
    .section = kPhongSection};
inline constexpr FindingText kPhongUnlit{
    .id = "phong.unlit",
    .words = "gave no light of point lights",
    .meaning = "point lights add nothing, or the flat colours of the stub are there still",
    .hint =
        "For every light of scene.pointLights() add the diffuse and the specular term. If M3.2 "
        "is there already, see whether isShadowed is true where nothing is in the way.",
    .section = kPhongSection};
inline constexpr FindingText kPhongWrong{
    .id = "phong.wrong",
    .words = "got colours wrong",
    .meaning = "terms are right one by one and wrong together",
    .hint = "The colour is ambient light plus, for every light, its diffuse and its specular term.",
    .section = kPhongSection};

inline constexpr FindingText kPhongThreadsMixed{
    .id = "phong.threads-mixed",
    .words = "let threads share what they light",
    .meaning = "right with one thread, another picture with two",
    .hint =
        "forEachPixel calls your code from several threads at once: a static or global variable "
        "belongs to all of them. Declare it inside of the function, without static.",
    .section = kPhongSection};

inline constexpr FindingText kShadeNoLight{
    .id = "shade.no-light",
    .words = "had no light that shadows could take away",
    .meaning = "point lights add nothing to a point that sees them: M2 comes first",
    .hint = "Do M2 first: without diffuse and specular light there is nothing to shade.",
    .section = kShadeSection};
inline constexpr FindingText kShadeInverted{
    .id = "shade.inverted",
    .words = "exchanged light and shadow",
    .meaning = "lit where something is in the way, dark where nothing is",
    .hint = "isShadowed is true where the ray meets something before the light.",
    .section = kShadeSection};
inline constexpr FindingText kShadeNone{
    .id = "shade.none",
    .words = "cast no shadows",
    .meaning = "what stands between point and light changes nothing",
    .hint =
        "Cast Ray{P + N * kShadowBias, L} with scene.findClosestIntersection and leave the "
        "diffuse and the specular term out where it meets something before the light.",
    .section = kShadeSection};
inline constexpr FindingText kShadeAcne{
    .id = "shade.acne",
    .words = "let surfaces shade themselves",
    .meaning = "dark points on a surface that faces the light",
    .hint =
        "Start the ray a little above the surface, at P + N * kShadowBias: from P itself, or "
        "from below, it meets the surface that it starts on.",
    .section = kShadeSection};
inline constexpr FindingText kShadeBeyond{
    .id = "shade.beyond-light",
    .words = "let objects behind the light cast shadows",
    .meaning = "what stands behind the light shades",
    .hint = "Compare: only a hit whose distance is smaller than that of the light shades.",
    .section = kShadeSection};
inline constexpr FindingText kShadeDistance{
    .id = "shade.distance",
    .words = "compared hits with a wrong distance of the light",
    .meaning = "right far from the light or near it, wrong at other distances",
    .hint =
        "Give the ray a direction of length 1 and compare occluder->distance with "
        "(light.position() - P).magnitude(), neither of them squared.",
    .section = kShadeSection};
inline constexpr FindingText kShadeAmbient{.id = "shade.ambient",
                                           .words = "shadowed the ambient light, too",
                                           .meaning = "a point in shadow loses ambient light",
                                           .hint =
                                               "Ambient light is added before the loop over the "
                                               "lights, whatever is in the way of them.",
                                           .section = kShadeSection};
inline constexpr FindingText kShadeSpecular{
    .id = "shade.specular",
    .words = "let highlights shine in shadow",
    .meaning = "the specular term is not shadowed",
    .hint = "Leave out the specular term of a light that is hidden, too.",
    .section = kShadeSection};
inline constexpr FindingText kShadeDiffuse{
    .id = "shade.diffuse",
    .words = "let diffuse light into shadow",
    .meaning = "the diffuse term is not shadowed",
    .hint = "Leave out the diffuse term of a light that is hidden, too.",
    .section = kShadeSection};
inline constexpr FindingText kShadeLights{
    .id = "shade.lights",
    .words = "lost lights after one that is hidden",
    .meaning = "one light in shadow changes what others give",
    .hint =
        "Ask for each light by itself, and go on with the next one (continue, not break or "
        "return).",
    .section = kShadeSection};
inline constexpr FindingText kShadeBias{
    .id = "shade.bias",
    .words = "started shadow rays too far from the surface",
    .meaning = "the start is more than 0.0011 from the point",
    .hint = "Start at P + N * kShadowBias: from further away thin or near objects are missed.",
    .section = kShadeSection};
inline constexpr FindingText kShadeWrong{
    .id = "shade.wrong",
    .words = "got shadows wrong",
    .meaning = "no known mistake gives these colours",
    .hint =
        "Cast Ray{P + N * kShadowBias, L} for each light, and leave out its diffuse and its "
        "specular term where a hit is nearer than the light.",
    .section = kShadeSection};

inline constexpr FindingText kShadeThreadsMixed{
    .id = "shade.threads-mixed",
    .words = "let threads share their shadow rays",
    .meaning = "right with one thread, another picture with two",
    .hint =
        "forEachPixel calls your code from several threads at once: a static or global variable "
        "belongs to all of them. Declare it inside of the function, without static.",
    .section = kShadeSection};

inline constexpr std::array kPhongFindings{&kPhongUnlit,   &kPhongAmbient,      &kPhongLightWay,
                                           &kPhongViewer,  &kPhongFalloff,      &kPhongClamp,
                                           &kPhongDiffuse, &kPhongSpecular,     &kPhongLights,
                                           &kPhongRange,   &kPhongThreadsMixed, &kPhongWrong};
inline constexpr std::array kShadeFindings{
    &kShadeNoLight,  &kShadeInverted,     &kShadeNone,     &kShadeAcne,    &kShadeBeyond,
    &kShadeDistance, &kShadeAmbient,      &kShadeSpecular, &kShadeDiffuse, &kShadeLights,
    &kShadeBias,     &kShadeThreadsMixed, &kShadeWrong};
}  // namespace ticker::tasks

#endif

#ifndef TICKER_TASKS_MAINTICK_LIGHTFINDINGS_H
#define TICKER_TASKS_MAINTICK_LIGHTFINDINGS_H

#include <grader/result/FindingText.h>

#include <array>

namespace ticker::tasks {

// What can be said about Phong illumination (M2) and shadows (M3.2).

inline constexpr std::string_view kPhongSection = "Phong illumination (M2)";
inline constexpr std::string_view kShadeSection = "Shadows (M3.2)";

inline constexpr FindingText kPhongAmbient{
    "phong.ambient", "got ambient light wrong",
    "a point without any point light has another colour",
    "Ambient light is object.colour() * scene.ambientLighting(), once, before the loop over the "
    "lights.",
    kPhongSection};
inline constexpr FindingText kPhongDiffuse{
    "phong.diffuse", "got diffuse light wrong", "a surface without highlights has another colour",
    "The diffuse term is object.colour() * I * (object.phongKD() * max(0, N.L)), where I is "
    "light.illuminationAt((light.position() - P).magnitude()), and N and L have length 1.",
    kPhongSection};
inline constexpr FindingText kPhongSpecular{
    "phong.specular", "got highlights wrong", "a surface without diffuse light has another colour",
    "The specular term is light.colour() * I * (object.phongKS() * pow(max(0, R.V), "
    "object.phongAlpha())), where I is light.illuminationAt((light.position() - P).magnitude()), "
    "and R and V have length 1.",
    kPhongSection};
inline constexpr FindingText kPhongViewer{
    "phong.viewer", "looked from another place than O", "V does not point from P to O",
    "V is (O - P).normalised(): O is where the ray started, the camera or the last mirror.",
    kPhongSection};
inline constexpr FindingText kPhongLightWay{
    "phong.light-direction", "took another direction to the light",
    "L does not point from P to the light with length 1",
    "L is (light.position() - P).normalised().", kPhongSection};
inline constexpr FindingText kPhongFalloff{
    "phong.falloff", "let light fade wrongly with distance",
    "another law than 1 / (4 pi d^2), or another distance",
    "I is light.illuminationAt(d) with d = (light.position() - P).magnitude().", kPhongSection};
inline constexpr FindingText kPhongClamp{
    "phong.clamp", "let light come from behind", "N.L or R.V counts where it is negative",
    "Take std::max(0.0, N.dot(L)) and std::max(0.0, R.dot(V)), the latter before the power.",
    kPhongSection};
inline constexpr FindingText kPhongLights{
    "phong.lights", "mixed up several point lights", "right with one light, wrong with two",
    "Add (+=) the terms of every light of scene.pointLights() to one colour, and return it after "
    "the loop.",
    kPhongSection};
inline constexpr FindingText kPhongRange{
    "phong.range", "cut bright colours off", "no channel exceeds 1",
    "Colours are not clamped: the tone curve brings them into range when the picture is written.",
    kPhongSection};
inline constexpr FindingText kPhongUnlit{
    "phong.unlit", "gave no light of point lights",
    "point lights add nothing, or the flat colours of the stub are there still",
    "Add the diffuse and the specular term of every light of scene.pointLights() to one colour, "
    "and return that colour. If M3.2 is there already, see whether isShadowed is true where "
    "nothing is in the way.",
    kPhongSection};
inline constexpr FindingText kPhongWrong{
    "phong.wrong", "got colours wrong", "terms are right one by one and wrong together",
    "The colour is ambient light plus, for every light, its diffuse and its specular term.",
    kPhongSection};

inline constexpr FindingText kPhongThreadsMixed{
    "phong.threads-mixed", "let threads share what they light",
    "right with one thread, another picture with two",
    "forEachPixel calls your code from several threads at once: a static or global variable "
    "belongs to all of them. Declare it inside of the function, without static.",
    kPhongSection};

inline constexpr FindingText kShadeNoLight{
    "shade.no-light", "had no light that shadows could take away",
    "point lights add nothing to a point that sees them: M2 comes first",
    "Do M2 first: without diffuse and specular light there is nothing to shade.", kShadeSection};
inline constexpr FindingText kShadeInverted{
    "shade.inverted", "exchanged light and shadow",
    "lit where something is in the way, dark where nothing is",
    "isShadowed is true where the ray meets something before the light.", kShadeSection};
inline constexpr FindingText kShadeNone{
    "shade.none", "cast no shadows", "what stands between point and light changes nothing",
    "Cast Ray{P + N * kShadowBias, L} with scene.findClosestIntersection and leave the diffuse and "
    "the specular term out where it meets something before the light.",
    kShadeSection};
inline constexpr FindingText kShadeAcne{
    "shade.acne", "let surfaces shade themselves", "dark points on a surface that faces the light",
    "Start the ray a little above the surface, at P + N * kShadowBias: from P itself, or from "
    "below, it meets the surface that it starts on.",
    kShadeSection};
inline constexpr FindingText kShadeBeyond{
    "shade.beyond-light", "let objects behind the light cast shadows",
    "what stands behind the light shades",
    "Compare: only a hit whose distance is smaller than that of the light shades.", kShadeSection};
inline constexpr FindingText kShadeDistance{
    "shade.distance", "compared hits with a wrong distance of the light",
    "right far from the light or near it, wrong at other distances",
    "Give the ray a direction of length 1 and compare occluder->distance with (light.position() - "
    "P).magnitude(), neither of them squared.",
    kShadeSection};
inline constexpr FindingText kShadeAmbient{
    "shade.ambient", "shadowed the ambient light, too", "a point in shadow loses ambient light",
    "A light that is hidden adds nothing, and what is there stays: go on with the next light "
    "(continue), and do not return or assign black. Ambient light is added before the loop over "
    "the lights, whatever is in the way of them.",
    kShadeSection};
inline constexpr FindingText kShadeSpecular{
    "shade.specular", "let highlights shine in shadow", "the specular term is not shadowed",
    "Leave out the specular term of a light that is hidden, too.", kShadeSection};
inline constexpr FindingText kShadeDiffuse{
    "shade.diffuse", "let diffuse light into shadow", "the diffuse term is not shadowed",
    "Leave out the diffuse term of a light that is hidden, too.", kShadeSection};
inline constexpr FindingText kShadeLights{
    "shade.lights", "lost lights after one that is hidden",
    "one light in shadow changes what others give",
    "Ask for each light by itself, and go on with the next one (continue, not break or return).",
    kShadeSection};
inline constexpr FindingText kShadeBias{
    "shade.bias", "started shadow rays too far from the surface",
    "the start is more than 0.0011 from the point",
    "Start at P + N * kShadowBias: from further away thin or near objects are missed.",
    kShadeSection};
inline constexpr FindingText kShadeWrong{
    "shade.wrong", "got shadows wrong", "no known mistake gives these colours",
    "Cast Ray{P + N * kShadowBias, L} for each light, and leave out its diffuse and its specular "
    "term where a hit is nearer than the light.",
    kShadeSection};

inline constexpr FindingText kShadeThreadsMixed{
    "shade.threads-mixed", "let threads share their shadow rays",
    "right with one thread, another picture with two",
    "forEachPixel calls your code from several threads at once: a static or global variable "
    "belongs to all of them. Declare it inside of the function, without static.",
    kShadeSection};

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

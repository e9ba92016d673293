#ifndef TICKER_TASKS_SHADOWS_SHADOWFINDINGS_H
#define TICKER_TASKS_SHADOWS_SHADOWFINDINGS_H

#include <grader/result/GeneralFindings.h>

#include <array>

namespace ticker::tasks {

// The findings of T2.1. A new finding is one row here and one entry in the table below.

inline constexpr FindingText kShadowHard{
    .id = "shadow.hard",
    .words = "cast hard shadows",
    .meaning = "one ray, or all rays to the centre",
    .hint =
        "Cast settings().shadowRayCount rays at every point for every light, aim each at "
        "light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize, a new point "
        "for every ray, and divide the number of rays that arrive by that count.",
    .section = "Soft shadows (T2.1), step 1"};

inline constexpr FindingText kShadowTooFewRays{
    .id = "shadow.too-few-rays",
    .words = "cast too few shadow rays",
    .meaning = "fewer than `shadowRayCount` for a point and light",
    .hint =
        "Cast settings().shadowRayCount rays for every light, and divide by the same number: do "
        "not leave the loop early, and count no ray that was not cast. Draw a new point within "
        "lightSize of that light for each ray, inside of the loop over the rays, for every light "
        "alike.",
    .section = "Soft shadows (T2.1), step 1"};

inline constexpr FindingText kShadowFixedSamples{
    .id = "shadow.fixed-samples",
    .words = "aimed at the same points everywhere",
    .meaning =
        "the same aims at every point: fail for one or two; warn, for a person, for more: the "
        "edges of shadows come in steps",
    .hint =
        "Draw a new point for every ray, inside of the loop over the rays, and keep none in a "
        "static variable. Vector3::randomInsideUnitSphere() goes on from call to call: use it, and "
        "do not start it again with seedRandom. A generator of your own must go on as well: make "
        "it thread_local.",
    .section = "Soft shadows (T2.1), step 1"};

inline constexpr FindingText kShadowInverted{.id = "shadow.inverted",
                                             .words = "exchanged light and shadow",
                                             .meaning = "lit and shadowed exchanged",
                                             .hint =
                                                 "The light that arrives is the share of rays that "
                                                 "reach the light, not of those that are blocked.",
                                             .section = "Soft shadows (T2.1), step 2"};

inline constexpr FindingText kShadowAllOrNothing{
    .id = "shadow.all-or-nothing",
    .words = "made shadow all or nothing",
    .meaning = "never a fraction",
    .hint =
        "The share must be a fraction: the number of rays that arrive, divided by the number of "
        "rays. Dividing one int by another drops everything after the point; and a yes or no (any "
        "ray, all rays), or what the last ray met, is no number of rays.",
    .section = "Soft shadows (T2.1), step 2"};

inline constexpr FindingText kShadowAmbientScaled{
    .id = "shadow.ambient-scaled",
    .words = "shadowed the ambient light, too",
    .meaning = "the ambient term is shadowed",
    .hint =
        "Scale the diffuse and the specular term only; the ambient term is there in full shadow, "
        "too.",
    .section = "Soft shadows (T2.1), step 3"};

inline constexpr FindingText kShadowSpecularUnshadowed{
    .id = "shadow.specular-unshadowed",
    .words = "let highlights shine in shadow",
    .meaning = "the specular term is not shadowed",
    .hint = "Scale the specular term by the share, too.",
    .section = "Soft shadows (T2.1), step 3"};

inline constexpr FindingText kShadowDiffuseUnshadowed{
    .id = "shadow.diffuse-unshadowed",
    .words = "let diffuse light into shadow",
    .meaning = "the diffuse term is not shadowed",
    .hint = "Scale the diffuse term by the share, too.",
    .section = "Soft shadows (T2.1), step 3"};

inline constexpr FindingText kShadowLightsMixed{
    .id = "shadow.lights-mixed",
    .words = "mixed up several lights",
    .meaning =
        "sums shared between lights, ambient light once for each light, lights lost where one "
        "shines from behind, or one of several objects that casts its shadow alone",
    .hint =
        "What you count, multiply or add up for one light starts anew inside of the loop over the "
        "lights. Add to the colour with +=, and only this light's diffuse and specular light, not "
        "the ambient light. Aim at this light's own position, compare hits with the distance of "
        "its own aim, and divide by the number of its rays, not by that of the lights. No return "
        "before every light has had its turn. Every "
        "object may stand in the way: findClosestIntersection asks all.",
    .section = "Soft shadows (T2.1), step 2"};

inline constexpr FindingText kShadowBeyondLight{
    .id = "shadow.beyond-light",
    .words = "let objects behind a light cast shadows",
    .meaning = "an object behind the light shadows",
    .hint =
        "An object casts a shadow only if it is nearer than the light: compare the distance of the "
        "hit with that of the point that the ray aims at, (target - start).magnitude(), both plain "
        "or both squared. The distance of a hit counts in lengths of the ray's direction, so give "
        "that unit length; and ask with < or >, since two doubles are hardly ever equal (==).",
    .section = "Soft shadows (T2.1), step 1"};

inline constexpr FindingText kShadowPointJittered{
    .id = "shadow.point-jittered",
    .words = "moved the lit point instead of the light",
    .meaning = "the origin of the shadow rays was moved",
    .hint =
        "All shadow rays start at P + N * kShadowBias, and their direction is target - start, from "
        "that same start. The random offset belongs to their target: light.position() + "
        "Vector3::randomInsideUnitSphere() * settings().lightSize.",
    .section = "Soft shadows (T2.1), step 1"};

inline constexpr FindingText kShadowDirectionOffset{
    .id = "shadow.direction-offset",
    .words = "let the light grow with its distance",
    .meaning = "the unit direction was offset, so the size grows with distance",
    .hint =
        "Aim at light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize: the "
        "offset belongs to the light's position, with lightSize as its radius, before the "
        "direction is normalised.",
    .section = "Soft shadows (T2.1), step 1"};

inline constexpr FindingText kShadowLightSize{
    .id = "shadow.light-size",
    .words = "gave the light another size",
    .meaning = "the right shape with a wrong radius",
    .hint =
        "A point in a light is light.position() + Vector3::randomInsideUnitSphere() * "
        "settings().lightSize, for every light alike: lightSize is the radius.",
    .section = "Soft shadows (T2.1), step 1"};

inline constexpr FindingText kShadowNotABall{
    .id = "shadow.not-a-ball",
    .words = "gave the light another shape than a ball",
    .meaning =
        "cube, a disc that keeps its place or faces the viewer, a square or an ellipse that faces "
        "the point, half-ball, off-centre; what looks round from every point and is neither denser "
        "in the "
        "middle than the original's helper nor denser at the rim than a surface is accepted",
    .hint =
        "Replace what you add to light.position() by Vector3::randomInsideUnitSphere() * "
        "settings().lightSize, as it is: no sign turned, nothing added. Numbers of your own go "
        "from -1 to 1 in x, y and z, each drawn anew, and all three are drawn again while the "
        "point is outside of the unit ball; two angles need a random number each. Of flat shapes "
        "only a round disc that faces the point P will do: no square, no ellipse, not turned to N.",
    .section = "Soft shadows (T2.1), step 1"};

inline constexpr FindingText kShadowClustered{
    .id = "shadow.clustered",
    .words = "crowded the samples in the light",
    .meaning = "warn: denser at the centre or the poles",
    .hint = "Vector3::randomInsideUnitSphere() of this kit gives points that fill the ball evenly.",
    .section = "Soft shadows (T2.1), step 1"};

inline constexpr FindingText kShadowViewFromEye{
    .id = "shadow.view-from-eye",
    .words = "took the eye for the viewer of a reflection",
    .meaning = "warn: V points to the eye instead of O, so reflections come out wrong",
    .hint =
        "V points from P to O. At a mirrored surface O is not the camera, so reflections come out "
        "wrong.",
    .section = "Soft shadows (T2.1), step 3"};

inline constexpr FindingText kShadowNearSideFalloff{
    .id = "shadow.near-side-falloff",
    .words = "measured the falloff to the light's surface",
    .meaning =
        "warn: the distance in the falloff ends at the near side of the light's ball, which makes "
        "the light brighter, by about (d / (d - r))^2",
    .hint =
        "The light is a ball around light.position(), of radius r = settings().lightSize. Measured "
        "to the near side of its surface, the distance d is up to r too short, so that light is up "
        "to (d / (d - r))^2 times as bright. The handout means the distance to the light's centre, "
        "(light.position() - P).magnitude(); that to a random point in the ball is right, too.",
    .section = "Soft shadows (T2.1), step 3"};

inline constexpr FindingText kShadowThreadsMixed{
    .id = "shadow.threads-mixed",
    .words = "let several threads share what a light adds up",
    .meaning =
        "right with one thread, wrong with two: threads share a counter, a sum or a point of "
        "illuminate",
    .hint =
        "forEachPixel works on several rows at the same time, and each calls illuminate. What "
        "illuminate counts, adds up or aims at must be its own: declare it inside of the loop over "
        "the lights, neither static nor outside of illuminate.",
    .section = "Soft shadows (T2.1), step 2"};

inline constexpr FindingText kShadowNotInRenders{
    .id = "shadow.not-in-renders",
    .words = "cast other shadow rays in pictures than when asked",
    .meaning =
        "warn, for a person: illuminate casts its rays when asked about a point, but not inside of "
        "render",
    .hint =
        "render sends its rays through trace, with the settings that it was given; trace calls "
        "illuminate, which casts settings().shadowRayCount rays to every light, always.",
    .section = "Soft shadows (T2.1), step 1"};

inline constexpr FindingText kShadowUnseenRays{
    .id = "shadow.unseen-rays",
    .words = "cast shadow rays that cannot be seen",
    .meaning =
        "note: no ray was seen, or more than can be followed, or a shadow cache hides some blocked "
        "ones, so values were judged statistically; warn, for a person: they left it open"};

inline constexpr FindingText kShadowWrong{
    .id = "shadow.wrong",
    .words = "computed light in no known way",
    .meaning =
        "fits nothing known; also a share of the rays above the horizon alone, an own loop over "
        "the objects that keeps another hit than the nearest or counts a ray for each object on "
        "its way, and samples with weights: the share is the count of rays that arrive, divided by "
        "their number",
    .hint =
        "Compare with the steps of the handout. A ray runs from the point to the light and is "
        "blocked if any object is nearer than its target (in a loop over the objects the next one "
        "must not set that back, and no ray leaves the next one a shorter limit). Diffuse and "
        "specular light are added once for each light (not "
        "for each ray), both times the same share: the number of rays that arrive, divided once, "
        "as double, by the number of rays that the loop casts (not one more or less; the share has "
        "no lower limit). Nothing else depends on them: "
        "neither share nor 1 - share scales the ambient light.",
    .section = "Soft shadows (T2.1), step 3"};

/// In the order in which they are reported.
inline constexpr std::array kShadowFindings{&kShadowHard,
                                            &kShadowTooFewRays,
                                            &kShadowFixedSamples,
                                            &kShadowInverted,
                                            &kShadowAllOrNothing,
                                            &kShadowAmbientScaled,
                                            &kShadowSpecularUnshadowed,
                                            &kShadowDiffuseUnshadowed,
                                            &kShadowLightsMixed,
                                            &kShadowBeyondLight,
                                            &kShadowPointJittered,
                                            &kShadowDirectionOffset,
                                            &kShadowLightSize,
                                            &kShadowNotABall,
                                            &kShadowClustered,
                                            &kShadowViewFromEye,
                                            &kShadowNearSideFalloff,
                                            &kShadowThreadsMixed,
                                            &kShadowNotInRenders,
                                            &kShadowWrong,
                                            &kSettingsHardCoded,
                                            &kShadowUnseenRays};

}  // namespace ticker::tasks

#endif

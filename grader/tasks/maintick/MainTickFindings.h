#ifndef TICKER_TASKS_MAINTICK_MAINTICKFINDINGS_H
#define TICKER_TASKS_MAINTICK_MAINTICKFINDINGS_H

#include <grader/result/FindingText.h>

#include <array>

namespace ticker::tasks {

// What can be said about spheres (M1) and planes (M3.1). A new finding is a row here and its place
// in the table.

inline constexpr std::string_view kSphereSection = "Spheres (M1)";
inline constexpr std::string_view kPlaneSection = "Planes (M3.1)";

inline constexpr FindingText kSphereMissed{
    .id = "sphere.missed",
    .words = "saw no sphere where there is one",
    .meaning = "no hit where the ray meets the sphere",
    .hint =
        "Check a = D.D, b = 2 D.(O - C), c = (O - C).(O - C) - r * r and the discriminant "
        "b * b - 4 a c one by one: only where it is negative there is no hit.",
    .section = kSphereSection};
inline constexpr FindingText kSpherePhantom{
    .id = "sphere.phantom",
    .words = "hit spheres that the ray passes by",
    .meaning = "a hit where the discriminant is negative",
    .hint =
        "Where b * b - 4 a c is negative the ray passes by: return std::nullopt before the "
        "square root is taken.",
    .section = kSphereSection};
inline constexpr FindingText kSphereBehind{
    .id = "sphere.behind",
    .words = "hit spheres behind the ray",
    .meaning = "a hit where both roots are negative",
    .hint =
        "A negative distance lies behind the origin: where no root is positive, return "
        "std::nullopt.",
    .section = kSphereSection};
inline constexpr FindingText kSphereFarRoot{
    .id = "sphere.far-root",
    .words = "took the far side of spheres",
    .meaning = "the larger root where the smaller one is positive",
    .hint = "Of two positive roots the smaller one, (-b - root) / (2 a), is the side that is seen.",
    .section = kSphereSection};
inline constexpr FindingText kSphereInside{
    .id = "sphere.inside",
    .words = "went wrong inside of spheres",
    .meaning = "a ray that starts inside does not meet the surface ahead of it",
    .hint =
        "From inside one root is negative: it lies behind the ray. The positive one, "
        "(-b + root) / (2 a), is the hit.",
    .section = kSphereSection};
inline constexpr FindingText kSphereDistance{
    .id = "sphere.distance",
    .words = "got distances to spheres wrong",
    .meaning = "another distance, by a mistake in the quadratic formula or by none that is known",
    .hint =
        "Write a = D.D, b = 2 D.(O - C) and c = (O - C).(O - C) - r * r out for the ray above "
        "and compare each with what your code has.",
    .section = kSphereSection};
inline constexpr FindingText kSphereLocation{
    .id = "sphere.location",
    .words = "put hits of spheres in a wrong place",
    .meaning = "the distance is right and the location is not",
    .hint = "The location is the point of the ray at that distance: ray.evaluateAt(distance).",
    .section = kSphereSection};
inline constexpr FindingText kSphereNormal{
    .id = "sphere.normal",
    .words = "got normals of spheres wrong",
    .meaning = "not of unit length, inwards, or another direction",
    .hint = "The normal is (location - centre()).normalised(): getNormalAt(location).",
    .section = kSphereSection};
inline constexpr FindingText kSphereObject{.id = "sphere.object",
                                           .words = "left the sphere out of its hits",
                                           .meaning = "the hit names another object or none",
                                           .hint = "The hit's first member is `this`.",
                                           .section = kSphereSection};
inline constexpr FindingText kSphereTurned{
    .id = "sphere.turned-normal",
    .words = "turned the normals of spheres to the ray",
    .meaning = "note: accepted, the text does not ask it",
    .hint =
        "The exercise takes the outward normal everywhere; only what is seen from inside looks "
        "different.",
    .section = kSphereSection};
inline constexpr FindingText kSphereLength{
    .id = "sphere.direction-length",
    .words = "met spheres elsewhere when directions are long",
    .meaning = "note: right for directions of length 1 alone, as all of the exercise are",
    .hint =
        "Your code relies on |D| = 1, which the handout grants; with a = D.D it is right for any "
        "direction.",
    .section = kSphereSection};

inline constexpr FindingText kPlaneMissed{
    .id = "plane.missed",
    .words = "saw no plane where there is one",
    .meaning = "no hit where the ray meets the plane",
    .hint = "s = (Q - O).N / D.N; there is a hit wherever s is positive.",
    .section = kPlaneSection};
inline constexpr FindingText kPlaneOneSided{
    .id = "plane.one-sided",
    .words = "saw planes from one side alone",
    .meaning = "no hit, or a wrong one, from one of the two sides",
    .hint =
        "The sign of D.N says from which side the ray comes; both are hits. Only the sign of "
        "s = (Q - O).N / D.N matters.",
    .section = kPlaneSection};
inline constexpr FindingText kPlaneBehind{
    .id = "plane.behind",
    .words = "hit planes behind the ray",
    .meaning = "a hit where s is negative",
    .hint = "A negative s lies behind the origin of the ray: return std::nullopt.",
    .section = kPlaneSection};
inline constexpr FindingText kPlaneDistance{
    .id = "plane.distance",
    .words = "got distances to planes wrong",
    .meaning = "another distance",
    .hint = "s = (Q - O).N / D.N: Q is a point of the plane, O the origin of the ray.",
    .section = kPlaneSection};
inline constexpr FindingText kPlaneLocation{
    .id = "plane.location",
    .words = "put hits of planes in a wrong place",
    .meaning = "the distance is right and the location is not",
    .hint = "The location is the point of the ray at that distance: ray.evaluateAt(distance).",
    .section = kPlaneSection};
inline constexpr FindingText kPlaneNormal{
    .id = "plane.normal",
    .words = "got normals of planes wrong",
    .meaning = "another normal than the plane's own",
    .hint = "A plane has the same normal everywhere: normal().",
    .section = kPlaneSection};
inline constexpr FindingText kPlaneObject{.id = "plane.object",
                                          .words = "left the plane out of its hits",
                                          .meaning = "the hit names another object or none",
                                          .hint = "The hit's first member is `this`.",
                                          .section = kPlaneSection};
inline constexpr FindingText kPlaneTurned{
    .id = "plane.turned-normal",
    .words = "turned the normals of planes to the ray",
    .meaning = "note: accepted, the text does not ask it",
    .hint =
        "The exercise takes the normal as it is stored: from wherever a plane is seen, lights "
        "behind it add nothing.",
    .section = kPlaneSection};
inline constexpr FindingText kPlaneLength{
    .id = "plane.direction-length",
    .words = "met planes elsewhere when directions are long",
    .meaning = "note: right for directions of length 1 alone, as all of the exercise are",
    .hint = "s D with s = (Q - O).N / D.N is right for every length of D.",
    .section = kPlaneSection};

inline constexpr std::array kSphereFindings{&kSphereMissed,   &kSpherePhantom, &kSphereBehind,
                                            &kSphereFarRoot,  &kSphereInside,  &kSphereDistance,
                                            &kSphereLocation, &kSphereNormal,  &kSphereObject,
                                            &kSphereTurned,   &kSphereLength};
inline constexpr std::array kPlaneFindings{&kPlaneMissed,   &kPlaneOneSided, &kPlaneBehind,
                                           &kPlaneDistance, &kPlaneLocation, &kPlaneNormal,
                                           &kPlaneObject,   &kPlaneTurned,   &kPlaneLength};

}  // namespace ticker::tasks

#endif

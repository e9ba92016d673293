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
    "sphere.missed", "saw no sphere where there is one", "no hit where the ray meets the sphere",
    "Check a = D.D, b = 2 D.(O - C), c = (O - C).(O - C) - r * r and the discriminant b * b - 4 a "
    "c one by one: only where it is negative there is no hit.",
    kSphereSection};
inline constexpr FindingText kSpherePhantom{"sphere.phantom", "hit spheres that the ray passes by",
                                            "a hit where the discriminant is negative",
                                            "Where b * b - 4 a c is negative the ray passes by: "
                                            "return std::nullopt before the square root is taken.",
                                            kSphereSection};
inline constexpr FindingText kSphereBehind{
    "sphere.behind", "hit spheres behind the ray", "a hit where both roots are negative",
    "A negative distance lies behind the origin: where no root is positive, return std::nullopt.",
    kSphereSection};
inline constexpr FindingText kSphereFarRoot{
    "sphere.far-root", "took the far side of spheres",
    "the larger root where the smaller one is positive",
    "Of two positive roots the smaller one, (-b - root) / (2 a), is the side that is seen.",
    kSphereSection};
inline constexpr FindingText kSphereInside{
    "sphere.inside", "went wrong inside of spheres",
    "a ray that starts inside does not meet the surface ahead of it",
    "From inside one root is negative: it lies behind the ray. The positive one, (-b + root) / (2 "
    "a), is the hit.",
    kSphereSection};
inline constexpr FindingText kSphereDistance{
    "sphere.distance", "got distances to spheres wrong",
    "another distance, by a mistake in the quadratic formula or by none that is known",
    "Work out for the ray above, one by one, and compare each with what your code has: a = D.D, b "
    "= 2 D.(O - C), c = (O - C).(O - C) - r * r, root = std::sqrt(b * b - 4 a c), s = (-b - root) "
    "/ (2 a), or (-b + root) / (2 a) where that is not positive, and what RaycastHit is given. The "
    "first that differs is the mistake.",
    kSphereSection};
inline constexpr FindingText kSphereLocation{
    "sphere.location", "put hits of spheres in a wrong place",
    "the distance is right and the location is not",
    "The location is the point of the ray at that distance: ray.evaluateAt(distance). The normal "
    "is made of it: getNormalAt(location).",
    kSphereSection};
inline constexpr FindingText kSphereNormal{
    "sphere.normal", "got normals of spheres wrong",
    "not of unit length, inwards, or another direction",
    "The normal is (location - centre()).normalised(): getNormalAt(location).", kSphereSection};
inline constexpr FindingText kSphereObject{"sphere.object", "left the sphere out of its hits",
                                           "the hit names another object or none",
                                           "The hit's first member is `this`.", kSphereSection};
inline constexpr FindingText kSphereTurned{"sphere.turned-normal",
                                           "turned the normals of spheres to the ray",
                                           "note: accepted, the text does not ask it",
                                           "The exercise takes the outward normal everywhere; only "
                                           "what is seen from inside looks different.",
                                           kSphereSection};
inline constexpr FindingText kSphereLength{
    "sphere.direction-length", "met spheres elsewhere when directions are long",
    "note: right for directions of length 1 alone, as all of the exercise are",
    "Your code relies on |D| = 1, which the handout grants; with a = D.D it is right for any "
    "direction.",
    kSphereSection};

inline constexpr FindingText kPlaneMissed{
    "plane.missed", "saw no plane where there is one", "no hit where the ray meets the plane",
    "s = (Q - O).N / D.N; there is a hit wherever s is positive.", kPlaneSection};
inline constexpr FindingText kPlaneOneSided{
    "plane.one-sided", "saw planes from one side alone",
    "no hit, or a wrong one, from one of the two sides",
    "The sign of D.N says from which side the ray comes; both are hits. Only the sign of s = (Q - "
    "O).N / D.N matters.",
    kPlaneSection};
inline constexpr FindingText kPlaneBehind{
    "plane.behind", "hit planes behind the ray", "a hit where s is negative",
    "A negative s lies behind the origin of the ray: return std::nullopt.", kPlaneSection};
inline constexpr FindingText kPlaneDistance{
    "plane.distance", "got distances to planes wrong", "another distance",
    "s = (Q - O).N / D.N: Q is point() and N is normal() of this plane, O the origin of this ray. "
    "Read all of them in each call: a static variable keeps those of the first.",
    kPlaneSection};
inline constexpr FindingText kPlaneLocation{
    "plane.location", "put hits of planes in a wrong place",
    "the distance is right and the location is not",
    "The location is the point of the ray at that distance: ray.evaluateAt(distance).",
    kPlaneSection};
inline constexpr FindingText kPlaneNormal{
    "plane.normal", "got normals of planes wrong", "another normal than the plane's own",
    "A plane has the same normal everywhere: normal().", kPlaneSection};
inline constexpr FindingText kPlaneObject{"plane.object", "left the plane out of its hits",
                                          "the hit names another object or none",
                                          "The hit's first member is `this`.", kPlaneSection};
inline constexpr FindingText kPlaneTurned{"plane.turned-normal",
                                          "turned the normals of planes to the ray",
                                          "note: accepted, the text does not ask it",
                                          "The exercise takes the normal as it is stored: from "
                                          "wherever a plane is seen, lights behind it add nothing.",
                                          kPlaneSection};
inline constexpr FindingText kPlaneLength{
    "plane.direction-length", "met planes elsewhere when directions are long",
    "note: right for directions of length 1 alone, as all of the exercise are",
    "s D with s = (Q - O).N / D.N is right for every length of D.", kPlaneSection};

inline constexpr std::array kSphereFindings{&kSphereMissed,   &kSpherePhantom, &kSphereBehind,
                                            &kSphereFarRoot,  &kSphereInside,  &kSphereDistance,
                                            &kSphereLocation, &kSphereNormal,  &kSphereObject,
                                            &kSphereTurned,   &kSphereLength};
inline constexpr std::array kPlaneFindings{&kPlaneMissed,   &kPlaneOneSided, &kPlaneBehind,
                                           &kPlaneDistance, &kPlaneLocation, &kPlaneNormal,
                                           &kPlaneObject,   &kPlaneTurned,   &kPlaneLength};

}  // namespace ticker::tasks

#endif

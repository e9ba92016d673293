#ifndef TICKER_TASKS_SHADOWS_QUESTIONS_SHADOWDRAWS_H
#define TICKER_TASKS_SHADOWS_QUESTIONS_SHADOWDRAWS_H

#include <grader/tasks/shadows/questions/ShadowQuestions.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/Surfaces.h>

#include <vector>

namespace ticker::tasks {

// Parts of the questions of T2.1.

/// A material whose spectra differ in every channel, so that ambient, diffuse and specular terms
/// cannot be confused.
[[nodiscard]] raytracer::Material drawMaterial(Draw& draw);

/// A light with an intensity such that about its own colour arrives at `distance`.
[[nodiscard]] raytracer::PointLight drawLight(Draw& draw, const Vector3& position, double distance);

/// The unit vector in the plane of two perpendiculars.
/// @param angle  From the first one, in radians.
[[nodiscard]] Vector3 sideAt(const Perpendiculars& sides, double angle);

/// A place in front of the camera.
[[nodiscard]] Vector3 drawPlace(Draw& draw);

/// A viewer near the mirrored direction, where the specular term is as large as the diffuse one.
[[nodiscard]] Vector3 drawViewer(Draw& draw, const Vector3& point, const Vector3& normal,
                                 const Vector3& light);

/// A viewer on the lens, as for a camera ray: finds code that treats camera rays and reflections
/// differently.
[[nodiscard]] Vector3 drawLensPoint(Draw& draw, const raytracer::RenderSettings& settings);

/// Where the shadow rays of accepted readings start, or near to it: off the surface by the
/// framework's shadow bias.
[[nodiscard]] Vector3 rayStart(const Vector3& point, const Vector3& normal);

/// The share of a ball's surface that is visible.
[[nodiscard]] double visibleShare(const Surfaces& surfaces, const Vector3& start,
                                  const Vector3& centre, double radius);

/// Zone of a point for each light. The lights are taken a third larger than `radius`, so that no
/// accepted sample and no accepted bias is near a decision.
[[nodiscard]] std::vector<Zone> zonesOf(const raytracer::SceneDescription& scene,
                                        const Surfaces& surfaces, const Vector3& point,
                                        const Vector3& normal, double radius);

/// A floor in front of the camera, seen from above, and nothing else.
[[nodiscard]] ShadowQuestion onFloor(Draw& draw, ShadowQuestion::Purpose purpose);

/// Adds a light in this direction from the middle of the floor.
/// @param share  Of the intensity that lights have in other questions.
void addLightTowards(Draw& draw, ShadowQuestion& drawn, const Vector3& towards, double distance,
                     double share = 1.0);

/// Adds points of the floor, all of them lit by every light, and sets the log's capacity. The
/// viewers are near the mirrored direction of the first light.
void addLitPoints(Draw& draw, ShadowQuestion& drawn, int count, double reach);

/// Sets the log's capacity, many times the number of rays that is asked for.
void setCapacity(ShadowQuestion& question);

/// Three lights, about at right angles to each other as seen from the floor. Two are far and have a
/// ball before them, the last is near and has one behind it, nearer than the far ones are.
[[nodiscard]] ShadowQuestion drawSeveralLights(Draw& draw);

/// A light with a sphere behind it, seen from a floor. Three more spheres stand behind and around
/// it, so near that rays past the light's centre meet them within a radius.
[[nodiscard]] ShadowQuestion drawBeyondLight(Draw& draw);

/// A floor under a light so far away, `towards` there, that its rays are almost parallel. The
/// viewers stand aside, in directions of their own.
[[nodiscard]] ShadowQuestion drawFarLight(Draw& draw, const Vector3& towards);

/// A floor under eight lights, all in plain sight.
[[nodiscard]] ShadowQuestion drawEightLights(Draw& draw);

/// A floor with two lights above it and one below, the second of three. Code that leaves the loop
/// over the lights there loses a light in either order.
[[nodiscard]] ShadowQuestion drawLightBehind(Draw& draw);

/// Two spheres, one behind the other, hide a light from the middle of a floor. Two more stand
/// behind the light, one before and one after these in the scene's list.
[[nodiscard]] ShadowQuestion drawInLine(Draw& draw);

/// A ball that rests on a floor, under a light about 25 away. The points lie in full shadow, where
/// the ball's surface is 0.006 to 0.008 above the floor.
[[nodiscard]] ShadowQuestion drawContact(Draw& draw);

/// A floor, and a light of which about a third is below it: rays to that part do not arrive.
[[nodiscard]] ShadowQuestion drawHorizon(Draw& draw);

/// The same behind a ball over the floor, which hides the upper part of the light: only rays to a
/// strip above the horizon arrive. Tells code that leaves out the rays below the horizon from code
/// that ignores hits on the floor, whose rays arrive there.
[[nodiscard]] ShadowQuestion drawHorizonBehindBall(Draw& draw);

/// A floor, and a light whose centre is below it, so that N.L is negative, and a part of it above.
/// The light is bright. The viewers see no highlight.
[[nodiscard]] ShadowQuestion drawSunkenLight(Draw& draw);

/// A floor under a low light, all of it in sight. The viewers and the eye are on its side: R.V is
/// below -0.5, and there is no highlight.
[[nodiscard]] ShadowQuestion drawLowLight(Draw& draw);

/// A floor under a light with a plane just before it, 1.2 to 1.3 times the light's radius from its
/// centre: no ray of any accepted reading arrives. The light is 20 to 30 away, so that a hit is
/// nearer than the light by only a few hundredths of the distance.
[[nodiscard]] ShadowQuestion drawNearLight(Draw& draw);

/// A floor with a colour in all channels under a red, a green and a blue light, all in plain sight.
[[nodiscard]] ShadowQuestion drawPureLights(Draw& draw);

/// A red, a green and a blue ball under a light with all channels, all in plain sight.
[[nodiscard]] ShadowQuestion drawPureSurfaces(Draw& draw);

/// A dark floor under a light in plain sight, of which about 0.001 arrives: less than one of 255
/// steps in every channel.
[[nodiscard]] ShadowQuestion drawFaintLight(Draw& draw);

/// A floor under a light with N.L of 0.07 to 0.1, all of it above the horizon and in plain sight.
[[nodiscard]] ShadowQuestion drawGrazingLight(Draw& draw);

/// A floor under a light 1.2 to 1.4 away, three of its radii or a little more.
[[nodiscard]] ShadowQuestion drawCloseLight(Draw& draw);

/// The same, 1.4 of its radii away, so that all of it is still above the floor.
[[nodiscard]] ShadowQuestion drawVeryCloseLight(Draw& draw);

/// A floor under a light in plain sight, which gets a single ray from each point.
[[nodiscard]] ShadowQuestion drawOneRay(Draw& draw);

/// A floor under a light in plain sight: one of radius 1.5 to 2, and one so small that it is
/// nearly a point. Of purpose `otherSettings`.
[[nodiscard]] std::vector<ShadowQuestion> drawOtherSizes(Draw& draw);

/// A floor with the light and the viewers behind it. R.V is below 0, for the eye as well.
[[nodiscard]] ShadowQuestion drawBackSide(Draw& draw);

/// Surfaces that show one term alone, or reflect like mirrors, each in plain sight of a light.
[[nodiscard]] std::vector<ShadowQuestion> drawMaterials(Draw& draw);

/// A floor under a light, with a ball around that, and with one around the points.
[[nodiscard]] std::vector<ShadowQuestion> drawEnclosed(Draw& draw);

/// Two lights, in either order, and a ball: it stands before one of them, and behind the other.
[[nodiscard]] std::vector<ShadowQuestion> drawBetweenLights(Draw& draw);

/// Two lights in one direction from a floor, the nearer one's ball before the other, in plain
/// sight.
[[nodiscard]] ShadowQuestion drawLightsInLine(Draw& draw);

/// A light behind a floor whose mirrored direction is near the viewer's: alone, and after a light
/// in front.
[[nodiscard]] std::vector<ShadowQuestion> drawBehindAfterLit(Draw& draw);

/// Points of a floor in plain sight of a light, and at either rim of a ball's penumbra, where about
/// 3 % of the light is visible or hidden. More rays are asked for than fit into a byte.
[[nodiscard]] ShadowQuestion drawManyRays(Draw& draw);

}  // namespace ticker::tasks

#endif

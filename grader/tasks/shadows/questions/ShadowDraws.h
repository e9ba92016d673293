#ifndef TICKER_TASKS_DISTRIBUTED_SHADOWDRAWS_H
#define TICKER_TASKS_DISTRIBUTED_SHADOWDRAWS_H

#include <grader/tasks/shadows/questions/ShadowQuestions.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/Surfaces.h>

#include <vector>

namespace ticker::tasks {

// The pieces of which the questions of T2.1 are made.

/// Spectra differ in every channel, so that ambient, diffuse and specular shares cannot be
/// confused.
[[nodiscard]] raytracer::Material drawMaterial(Draw& draw);

/// A light of which about its own colour arrives at `distance`.
[[nodiscard]] raytracer::PointLight drawLight(Draw& draw, const Vector3& position, double distance);

/// Somewhere in front of the camera.
[[nodiscard]] Vector3 drawPlace(Draw& draw);

/// A viewer near the mirrored direction, where the specular term is as large as the diffuse one.
[[nodiscard]] Vector3 drawViewer(Draw& draw, const Vector3& point, const Vector3& normal,
                                 const Vector3& light);

/// A point of the lens, seen as by a camera ray: whoever treats those apart from reflections has to
/// be found out, too.
[[nodiscard]] Vector3 drawLensPoint(Draw& draw, const raytracer::RenderSettings& settings);

/// What of each light a point sees, the lights taken a third larger than `radius`: no accepted
/// sample and no accepted bias is near a decision.
[[nodiscard]] std::vector<Zone> zonesOf(const raytracer::SceneDescription& scene,
                                        const Surfaces& surfaces, const Vector3& point,
                                        const Vector3& normal, double radius);

/// Sets how many rays the log has room for, many times what is asked for.
void setCapacity(ShadowQuestion& question);

/// A floor that two lights shine on, and one from below, which is the second: whoever leaves the
/// loop there loses a light, whichever end he begins at.
[[nodiscard]] ShadowQuestion drawLightBehind(Draw& draw);

/// Two spheres one behind the other keep a light from the middle of a floor; two more stand behind
/// the light, one listed before those and one after them.
[[nodiscard]] ShadowQuestion drawInLine(Draw& draw);

/// A floor, and a light of which about a third is below it: rays there do not arrive.
[[nodiscard]] ShadowQuestion drawHorizon(Draw& draw);

}  // namespace ticker::tasks

#endif

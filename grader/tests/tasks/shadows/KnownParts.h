#ifndef TICKER_TESTS_TASKS_SHADOWS_KNOWNPARTS_H
#define TICKER_TESTS_TASKS_SHADOWS_KNOWNPARTS_H

#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/answers/Phong.h>
#include <grader/tests/tasks/shadows/ShadowByHand.h>

namespace ticker::tasks {

/// Parts of the light at one point.
struct Parts {
    ColourRGB ambient;
    ColourRGB diffuse;
    ColourRGB specular;
};

inline Parts partsOf(const PointLog& point, const ShadowLog& log, std::size_t light = 0,
                     bool viewerIsEye = false) {
    const Vector3 towards = log.scene().pointLights[light].position() - point.point.position;
    const double distance = towards.magnitude();
    const Vector3 viewer = viewerIsEye ? Vector3{} : point.point.viewer;
    const auto terms = phongTerms(log.scene().planes[0].material, log.scene().pointLights[light],
                                  point.point.normal, (viewer - point.point.position).normalised(),
                                  towards / distance, distance);
    return {ambientPart(point, log.scene()), terms.diffuse, terms.specular};
}

}  // namespace ticker::tasks

#endif

#ifndef TICKER_TASKS_SHADOWS_MIXED_MIXEDSCENES_H
#define TICKER_TASKS_SHADOWS_MIXED_MIXEDSCENES_H

#include <grader/tasks/shadows/questions/ShadowQuestions.h>
#include <grader/tasks/support/Draw.h>

#include <vector>

namespace ticker::tasks {

/// Scenes whose every attribute is drawn independently, from usual and extreme values: the number
/// of lights and their distance, level and colour; the materials of the surface and of what stands
/// before a light or behind it; where the surface lies and where the viewer is. If `illuminate` has
/// a condition on one of them that it should not have, some scene is wrong.
///
/// Every light lies in front of the surface's tangent plane or behind it by more than its radius,
/// no object comes nearer to a light than 1.4 radii or to a point than 0.1, and a ray to any place
/// of a light is nearer in angle to its centre than to another light's. R.V is negative for every
/// place of a light behind, for the eye, too.
/// Half of the scenes have the handout's settings (`mixed`), the others smaller lights that may be
/// nearer (`mixedNear`).
[[nodiscard]] std::vector<ShadowQuestion> drawMixedScenes(Draw& draw);

/// More of purpose `mixed`: a bumpy ball before a light, one so large that its centre is farther
/// away than the light, and one that is more than 1000 away.
[[nodiscard]] std::vector<ShadowQuestion> drawOtherBalls(Draw& draw);

/// Three more: a light in plain sight, hundreds of units away and thousands.
[[nodiscard]] std::vector<ShadowQuestion> drawVeryFarLights(Draw& draw);

/// Of purpose `mixedNear`, with lights so small that they are nearly points: one in plain sight
/// less than half a unit away, one that shows a narrow highlight, one that a plane a few hundredths
/// before it hides, and one that shows the broadest highlight and a phongKD above 1.
[[nodiscard]] std::vector<ShadowQuestion> drawSmallLights(Draw& draw);

/// Of purpose `mixedNear`, too: points at both edges of a penumbra, where a few of some fifty rays
/// are blocked or arrive.
[[nodiscard]] std::vector<ShadowQuestion> drawPenumbraEdges(Draw& draw);

/// One more: 34 lights in plain sight, more than tables of 16 or 32 hold.
[[nodiscard]] std::vector<ShadowQuestion> drawManyLights(Draw& draw);

}  // namespace ticker::tasks

#endif

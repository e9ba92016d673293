#ifndef TICKER_TASKS_SHADOWS_CHECKS_SHADOWCHECKS_H
#define TICKER_TASKS_SHADOWS_CHECKS_SHADOWCHECKS_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/ShadowAims.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// The logs of T2.1 by purpose.
struct ShadowLogs {
    std::vector<const ShadowLog*> oneLight;
    std::vector<const ShadowLog*> severalLights;
    std::vector<const ShadowLog*> eightLights;
    std::vector<const ShadowLog*> beyondLight;
    std::vector<const ShadowLog*> planeShadow;
    std::vector<const ShadowLog*> farLight;
    std::vector<const ShadowLog*> lightBehind;
    std::vector<const ShadowLog*> inLine;
    std::vector<const ShadowLog*> otherSettings;
    std::vector<const ShadowLog*> contact;
    std::vector<const ShadowLog*> horizon;
    std::vector<const ShadowLog*> lowLight;
    std::vector<const ShadowLog*> nearLight;
    std::vector<const ShadowLog*> pureColours;
    std::vector<const ShadowLog*> oddCount;
    std::vector<const ShadowLog*> faintLight;
    std::vector<const ShadowLog*> closeLight;
    std::vector<const ShadowLog*> backSide;
    std::vector<const ShadowLog*> oneTerm;
    std::vector<const ShadowLog*> mirror;
    std::vector<const ShadowLog*> enclosed;
    std::vector<const ShadowLog*> betweenLights;
    std::vector<const ShadowLog*> behindAlone;
    std::vector<const ShadowLog*> behindAfter;
    std::vector<const ShadowLog*> lightsInLine;
    std::vector<const ShadowLog*> oneRay;
    std::vector<const ShadowLog*> manyRays;
    std::vector<const ShadowLog*> mixed;
    std::vector<const ShadowLog*> mixedNear;

    explicit ShadowLogs(const std::vector<ShadowLog>& logs);
    /// All questions except otherSettings, oddCount, oneRay, manyRays, mixedNear and horizon, where
    /// code may cast fewer rays, and those with checks of their own: contact, faintLight,
    /// closeLight, backSide, eightLights, oneTerm, mirror, enclosed, betweenLights, behindAlone,
    /// behindAfter, lightsInLine and mixed.
    [[nodiscard]] std::vector<const ShadowLog*> atHandoutSettings() const;
};

/// Each check looks at one property and returns a finding if it is wrong.
[[nodiscard]] std::optional<Finding> checkFinite(const ShadowLogs& logs);
/// Rays that start too far from the lit point.
[[nodiscard]] std::optional<Finding> checkStarts(const ShadowLogs& logs);
/// Rays that start away from the light.
[[nodiscard]] std::optional<Finding> checkBackwards(const ShadowLogs& logs);
/// Hard shadows, too few rays, or copies of rays, where a point has one light.
/// @param fixed  Points share their samples, which another finding reports.
[[nodiscard]] std::optional<Finding> checkRayCounts(const ShadowLogs& logs, bool fixed);
/// Too few rays, or copies of rays, to some of several lights. Lights without any ray are left out.
[[nodiscard]] std::optional<Finding> checkSeveralCounts(const ShadowLogs& logs, bool fixed);
/// Lights in front of the surface that get no ray.
[[nodiscard]] std::optional<Finding> checkEveryLight(const ShadowLogs& logs);
/// Whether each of several lights is as large as a single light.
[[nodiscard]] std::optional<Finding> checkSeveralSizes(const ShadowLogs& logs,
                                                       const AimVerdict& aims);
/// `checkSeveralCounts`, `checkEveryLight` and `checkSeveralSizes` with eight lights, and whether
/// each of these adds its light. A direction that is far off belongs to another light there, so
/// this is for rays that are right otherwise.
/// @param fixed  Points share their samples, which another finding reports.
[[nodiscard]] std::optional<Finding> checkEightLights(const ShadowLogs& logs,
                                                      const AimVerdict& aims, bool fixed);
/// Whether each of eight lights adds its light, for code whose rays are not visible.
/// @param reading  The one that fits all other questions.
[[nodiscard]] std::optional<Finding> checkEightValues(const ShadowLogs& logs,
                                                      const ShadowReading& reading);
/// The same aims at every point, ray by ray in the order of casting.
[[nodiscard]] std::optional<Finding> checkFixedSamples(const ShadowLogs& logs);
/// A few aims that all points share, each in an order of its own.
[[nodiscard]] std::optional<Finding> checkSmallPool(const AimVerdict& aims);
/// A light whose radius grows with its distance.
[[nodiscard]] std::optional<Finding> checkDirectionOffset(const ShadowLogs& logs);
/// Shape, size and density of the light, from the aims at far lights.
[[nodiscard]] std::optional<Finding> checkAims(const ShadowLogs& logs, const AimVerdict& aims);
/// Whether the number of rays and the light's radius are those of settings().
[[nodiscard]] std::optional<Finding> checkOtherSettings(const ShadowLogs& logs,
                                                        const AimVerdict& aims);
/// Whether all rays are cast if their number is odd, so that pairs or other groups leave some over.
[[nodiscard]] std::optional<Finding> checkOddCount(const ShadowLogs& logs);
/// Whether a light that adds little gets its rays and adds its light.
[[nodiscard]] std::optional<Finding> checkFaintLight(const ShadowLogs& logs);
/// Whether a light that adds little adds its light, for code whose rays are not visible.
/// @param reading  The one that fits all other questions.
[[nodiscard]] std::optional<Finding> checkFaintValues(const ShadowLogs& logs,
                                                      const ShadowReading& reading);
/// Whether a close light is as large as others.
[[nodiscard]] std::optional<Finding> checkCloseLight(const ShadowLogs& logs,
                                                     const AimVerdict& aims);
/// Whether a single ray goes to a random place of the light.
[[nodiscard]] std::optional<Finding> checkOneRay(const ShadowLogs& logs, const AimVerdict& aims);
/// Whether lights with one channel alone get their rays, and surfaces with one channel.
[[nodiscard]] std::optional<Finding> checkColourChannels(const ShadowLogs& logs);
/// The finding if a light or surface of one channel gets its rays, or no rays are visible, but its
/// colour is wrong.
[[nodiscard]] Finding channelsLost();
/// Whether rays below the surface's horizon count as blocked, and whether a light whose centre is
/// below it takes no light away.
/// @param reading  The reading that fits all other questions.
[[nodiscard]] std::optional<Finding> checkHorizon(const ShadowLogs& logs, const AimVerdict& aims,
                                                  const ShadowReading& reading);

/// Whether an object shades what is close to it. Hits nearer than 0.004 may be ignored.
[[nodiscard]] std::optional<Finding> checkContact(const ShadowLogs& logs);
/// Whether a light behind the surface adds nothing where the viewer is behind it, too.
[[nodiscard]] std::optional<Finding> checkBackSide(const ShadowLogs& logs);

/// Scenes whose colours follow from those of other questions: surfaces of one term, mirrors,
/// balls around the light or the points, a ball between two lights, two lights in one direction, a
/// light behind the surface after one in front.
/// @param reading   The one that fits all other questions.
/// @param raysSeen  Otherwise only what follows from geometry is compared.
[[nodiscard]] std::optional<Finding> checkKnownScenes(const ShadowLogs& logs,
                                                      const ShadowReading& reading, bool raysSeen);
/// Whether code that follows the number of rays does so beyond 255, too.
[[nodiscard]] std::optional<Finding> checkManyRays(const ShadowLogs& logs,
                                                   const ShadowReading& reading, bool raysSeen);

/// Result of replaying every value: the reading that fits, or the mistake.
struct ArithmeticVerdict {
    std::optional<ShadowReading> reading;
    std::optional<Finding> finding;
};
[[nodiscard]] ArithmeticVerdict checkArithmetic(const ShadowLogs& logs);

/// Whether light falls off over the distance of the light's near side, and of nothing else.
[[nodiscard]] std::optional<Finding> checkNearSide(const ShadowLogs& logs);
[[nodiscard]] Finding nearSideFalloff();

/// Judges values if no ray was logged: points in full light and in full shadow.
[[nodiscard]] ArithmeticVerdict checkValues(const ShadowLogs& logs);

}  // namespace ticker::tasks

#endif

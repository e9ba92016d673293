#ifndef TICKER_TASKS_BUMP_DIAGNOSIS_H
#define TICKER_TASKS_BUMP_DIAGNOSIS_H

#include <grader/result/FindingText.h>
#include <grader/tasks/bump/Examination.h>

#include <optional>
#include <vector>

namespace ticker::tasks::bump {

/// The faults of T1, in the order in which they are reported.
enum class Fault {
    threw,
    notFinite,
    notUnit,
    flat,
    longitudeDependent,
    swapped,
    inverted,
    invertedU,
    invertedV,
    upsideDown,
    wrong
};

/// The fault's row in the table of findings.
[[nodiscard]] const FindingText& textOf(Fault fault);

/// Why a submission is wrong, if no named fault applies. The first reason that applies is reported.
enum class WrongReason {
    chance,          ///< the same point of the same map gets another normal each time
    mapIgnored,      ///< another map gives the same normals
    remembers,       ///< the normal depends on the map of the question just before
    dependsOnOrder,  ///< the normal depends on the points before it
    normalMissing,   ///< a gentle slope lays the normal flat into the surface
    inward,
    flatTilted,
    normalsRounded,  ///< to a few values, which points share
    slopeUIgnored,
    slopeVIgnored,
    signLost,
    strangeParametrisation,
    smallSlopesLost,  ///< ramps tilt nothing, steps do
    patchy,
    strangeDirection,
    doesNotGrow,
    heightsBent,    ///< the same slope tilts otherwise where the map is bright
    pastHorizon,    ///< steep slopes turn the normal past the horizon
    steepDiffers,   ///< on a ramp from black to white
    regionsDiffer,  ///< in some rows or columns of a large map
    slopesDiffer,
    wallAtSeam,          ///< heights that the map does not have, beyond its last column
    coordinatesRounded,  ///< u or v, coarsely
    stepsLost,           ///< where the map falls, or where it rises
    fractionsMixed,      ///< the tilt across stripes changes along them
    lettersDiffer,
    dependsOnEye,        ///< the same sphere elsewhere has other normals
    turnedAtPoles,       ///< the tilt's direction is wrong near the poles alone
    stepsUneven,         ///< equal steps of grey tilt by different amounts
    fewTexelsDiffer,     ///< beside the first or last row or column of a small map
    sharpStepsTurned,    ///< white, or light grey, beside black tilts to the other side
    besidePlanes,        ///< another place of the map where x, y or z is nearly 0
    otherTexels,         ///< one slope is that of another column or row
    smallSphereDiffers,  ///< on a very small sphere
    smoothInPlaces       ///< a condition of the code's own keeps the normal smooth in places
};

/// What is wrong with a submission.
struct Diagnosis {
    std::vector<Fault> faults;         ///< the most important first; empty for a right submission
    std::optional<WrongReason> wrong;  ///< of Fault::wrong
};
[[nodiscard]] Diagnosis diagnose(const Examination& examination,
                                 const std::optional<Hints>& hints = {});

/// True if columns and rows are exchanged in the look-up. Such a look-up reads outside of the map
/// unless the map is square, so that it may show in the hints alone.
[[nodiscard]] bool isTransposed(const Examination& examination, const std::optional<Hints>& hints);

/// True if row 0 lies at the bottom of the sphere.
[[nodiscard]] bool standsOnItsHead(const Examination& examination);

/// True if nearly every normal points into the sphere. No other result then has its usual meaning.
[[nodiscard]] bool pointsInwards(const Examination& examination);

/// The first reason of Fault::wrong that applies; empty if none does.
[[nodiscard]] std::optional<WrongReason> findWrong(const Examination& examination);

}  // namespace ticker::tasks::bump

#endif

#include <grader/tasks/bump/words/GrowthWords.h>

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace ticker::tasks::bump {

Words smallSlopesWords() {
    return {"Steps of the map tilt the normal, but even slopes tilt nothing.",
            "Heights are fractions from 0 to 5: look for an int that cuts a difference off, for a "
            "threshold, or for a step that reads the same texel twice.",
            "Option 1: What to do, step 3"};
}

Words growthWords(const Examination& examination) {
    const std::string seen =
        examination.ladder.growsWithSlope
            ? fmt::format(
                  "Slopes that are {} times as steep tilt the normal only {:.2g} times as "
                  "far (median): gentle bumps look as steep as strong ones.",
                  ProportionPlan::kTimes, std::max(0.0, examination.proportion.growth))
            : "A slope that is 50 times as steep tilts the normal hardly more.";
    return {seen,
            "Bu and Bv are differences of heights as they are: do not normalise them, do not cut "
            "them off (clamp, min, max), and put no tanh or root over them. Only the sum of "
            "Equation (1) is normalised.",
            "Option 1: Theory"};
}

Words horizonWords(const Proportion& proportion) {
    return {
        fmt::format("Where the map is steep the normal leans 90 degrees or more, at {} of the "
                    "points of a rough map: the tilt grows faster than the slope, past the horizon "
                    "and into the sphere.",
                    percent(proportion.pastHorizon)),
        "A slope is no angle: do not turn the normal by it, and do not add it to the longitude or "
        "the polar angle. Add Bu and Bv times tangents to n and normalise the sum, Equation (1); "
        "or turn the normal by std::atan(slope).",
        "Option 1: Theory"};
}

Words normalMissingWords() {
    return {
        "Wherever the map slopes at all, the normal lies flat in the surface: however gentle "
        "the slope is, the normal turns by 90 degrees.",
        "n is missing from the sum, or hardly counts in it: return n - Bu Pu - Bv Pv, "
        "normalised, Equation (1), with a unit vector n and slopes that no large factor "
        "multiplies.",
        "Option 1: Theory; What to do, step 4"};
}

}  // namespace ticker::tasks::bump

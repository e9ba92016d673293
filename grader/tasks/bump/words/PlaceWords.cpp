#include <grader/tasks/bump/words/PlaceWords.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace ticker::tasks::bump {

Words seamWords(const MapEdges& edges) {
    return {
        fmt::format("On a map of a gentle wave that closes round the sphere the normal tilts {} "
                    "times as far at the seam, where the last column meets the first, as "
                    "anywhere else: a line runs down the sphere there.",
                    edges.seam < 100.0 ? fmt::format("{:.0f}", edges.seam) : "over 100"),
        "Columns go round the sphere: to the right of the last one lies column 0, "
        "(column + 1) % width(), not a height of 0 or of another place. Below the last row "
        "take that row again.",
        "Option 1: What to do, step 3"};
}

Words eyeWords(const Elsewhere& elsewhere) {
    return {
        fmt::format("The normal depends on where the eye is: the same map on the same sphere gives "
                    "other normals at {} of the points near the rim when the sphere stands on the "
                    "other side of the eye.",
                    percent(elsewhere.changed)),
        "A normal depends on position - centre() and the map alone. Take out what mirrors, turns, "
        "bends or weakens it where it faces away from the eye: normals of steep bumps do so at the "
        "rim, the light is then 0 there, and mirrors see the far side.",
        "Option 1: What to do, step 4"};
}

Words capWords(const Caps& caps) {
    const bool alongV = caps.goodU();
    return {fmt::format("Within eight degrees of the poles a slope along {} tilts the normal in "
                        "another direction than {}, unlike elsewhere: only {} of the points of the "
                        "worst ring lean the right way.",
                        alongV ? "v" : "u", alongV ? "Pv" : "Pu",
                        percent(alongV ? caps.alongV : caps.alongU)),
            "The tangents belong to u and v everywhere: near the poles, too, Pu leads to where the "
            "longitude grows and Pv to where the polar angle grows. Take out the condition that "
            "chooses another helper vector (another up) for the cross products, or other tangents, "
            "where the normal is nearly along the axis: only at the exact pole is the cross "
            "product 0. The row of the map must reach the poles, too: limit the argument of acos "
            "to -1 and 1 exactly.",
            "Option 1: What to do, step 2"};
}

namespace {

Words seamWords(const FewTexels& fewTexels) {
    return {fmt::format("On a map whose rows alone differ, the normal leans along u in the first "
                        "or the last column, {} as far as along v; elsewhere it does not.",
                        percent(fewTexels.aside)),
            "The neighbour of the last column is column 0 of the same row: wrap the column by "
            "itself, (column + 1) % width, not an index into all texels, which leads to the row "
            "below.",
            "Option 1: What to do, step 3"};
}

Words lastTexelWords(const FewTexels& fewTexels) {
    const bool inRows = fewTexels.beforeLastColumn >= FewTexels::kLeastBeforeLast;
    const std::string texel = inRows ? "row" : "column";
    return {
        fmt::format("On a map that is flat but for a higher last {0}, the normal does not lean "
                    "away from it in the {0} before; beside a higher {0} in the middle it does.",
                    texel),
        fmt::format("The neighbour of the last {0} but one is the last {0}, {1}() - 1. Look at "
                    "the limit of the neighbour's index: % {1}() begins again after the last {0}, "
                    "and % ({1}() - 1) leaves it out.",
                    texel, inRows ? "height" : "width"),
        "Option 1: What to do, step 3"};
}

Words farColumnWords() {
    return {fmt::format("On a map of {} columns, at the outer edge of the first or the last one, "
                        "the normal has the slope of a column far away from there.",
                        kFewColumns),
            "Before the first column lies the last one, width() - 1. -1 % width() is no column, "
            "and with an unsigned width it is another one unless the width is a power of two: add "
            "the width first, (column + width()) % width().",
            "Option 1: What to do, step 3"};
}

Words shortStepWords(const FewTexels& fewTexels, bool inRows) {
    return {
        fmt::format("On a map of {0} {1}s the slope along {2} is lost inside of most {1}s: only "
                    "{3} of the points there lean the right way.",
                    inRows ? kFewRows : kFewColumns, inRows ? "row" : "column", inRows ? "v" : "u",
                    percent(inRows ? fewTexels.insideV : fewTexels.insideU)),
        fmt::format("Compare neighbouring texels: the {0} of this point and the next {0}. A "
                    "fixed step of {1}, such as 0.01, stays inside of one texel where the map "
                    "is small. A factor {2}() / {3}() of whole numbers is 0 on a map with fewer "
                    "{0}s: leave it out, or divide doubles.",
                    inRows ? "row" : "column", inRows ? "v" : "u", inRows ? "height" : "width",
                    inRows ? "width" : "height"),
        "Option 1: What to do, step 3"};
}

}  // namespace

Words fewTexelWords(const FewTexels& fewTexels) {
    if (!fewTexels.goodSeam()) return farColumnWords();
    if (fewTexels.goodU() && fewTexels.goodV()) return seamWords(fewTexels);
    if (std::min(fewTexels.alongU, fewTexels.alongV) >= FewTexels::kLeast)
        return lastTexelWords(fewTexels);
    const bool inRows = fewTexels.goodU();
    const std::string texel = inRows ? "row" : "column";
    if ((inRows ? fewTexels.insideV : fewTexels.insideU) < FewTexels::kLeast)
        return shortStepWords(fewTexels, inRows);
    return {fmt::format("On a map of {3} {0}s, in the {0} beside the first or the last one, the "
                        "slope along {1} is lost or inverted: only {2} of the points there lean "
                        "the right way.",
                        texel, inRows ? "v" : "u",
                        percent(inRows ? fewTexels.alongV : fewTexels.alongU),
                        inRows ? kFewRows : kFewColumns),
            fmt::format("Look at the limit of the neighbour's index: the last {0} is {1}() - 1, "
                        "and only there does a neighbour need another rule (column 0 beyond the "
                        "last column, the last row again below the last row).",
                        texel, inRows ? "height" : "width"),
            "Option 1: What to do, step 3"};
}

Words unevenWords(const EvenSteps& steps) {
    return {fmt::format("On an even ramp, where each column is one grey step higher than the one "
                        "before, the tilt should be the same everywhere; at {} of the columns it "
                        "is not that of the columns around.",
                        percent(steps.uneven)),
            "heightMap().at(column, row) is a double: subtract the two heights as they are. A "
            "height divided by 5 and times 255 may be 30.999999 in place of 31, and a cast to int "
            "makes 30 of it.",
            "Option 1: What to do, step 3"};
}

Words sharpStepWords(const SharpSteps& steps) {
    return {fmt::format("Where a {} texel lies beside a black one the normal tilts to the wrong "
                        "side, at {} of these points; beside a {} one it is right.",
                        steps.isWhite ? "white" : "light grey", percent(steps.turned),
                        steps.isWhite ? "grey" : "dark grey"),
            steps.isWhite
                ? "heightMap().at(column, row) is a double: subtract the two heights as they are. "
                  "A difference of grey values from 0 to 255 does not fit into a signed char, and "
                  "that of two unsigned char is never negative."
                : "heightMap().at(column, row) is a double: subtract the two heights as they are. "
                  "A difference of fixed-point numbers does not fit into every integer type.",
            "Option 1: What to do, step 3"};
}

Words beltWords(const Belts& belts) {
    return {
        fmt::format("Beside the plane {0} = 0 through the centre, where {0} is 0.008 to 0.03 of "
                    "the radius, the normal leans as at another place of the map at {1} of the "
                    "points of some part: a stripe runs over the sphere there.",
                    belts.plane, percent(belts.wrong)),
        "Take out the condition for a coordinate that is nearly 0: std::atan2 takes any two "
        "numbers. Only at the exact poles, where both are 0, is there no longitude.",
        "Option 1: What to do, step 1"};
}

Words otherTexelWords(const OwnTexels& ownTexels) {
    const bool alongV = !ownTexels.column.good();
    return {fmt::format("On a map of random texels the slope along {0} is not that of the point's "
                        "own {1}, but that of a {1} {2} {1}s away.",
                        alongV ? "v" : "u", alongV ? "column" : "row",
                        std::abs(alongV ? ownTexels.column.away : ownTexels.row.away)),
            "Both slopes begin at the point's own texel, at(column, row): Bu is the difference to "
            "the next column of the same row, Bv that to the next row of the same column.",
            "Option 1: What to do, step 3"};
}

Words smallSphereWords(const SlopeAgreement& slopes) {
    return {fmt::format("On a sphere of radius 0.05 the tilt along {} follows other slopes than "
                        "those at the point; on a larger sphere it is right.",
                        slopes.smallU < slopes.smallV ? "u" : "v"),
            "The neighbour is the next texel, whatever the radius: column + 1 and row + 1, or u "
            "and v plus a thousandth. A step of a fixed length in the world is many texels long on "
            "a small sphere.",
            "Option 1: What to do, step 3"};
}

}  // namespace ticker::tasks::bump

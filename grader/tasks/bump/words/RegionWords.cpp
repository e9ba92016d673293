#include <grader/tasks/bump/words/RegionWords.h>

#include <fmt/format.h>

#include <optional>
#include <string>

namespace ticker::tasks::bump {
namespace {

/// ", mostly in columns 0 to 310"; empty if the points lie all over the map.
std::string rangeInWords(const char* what, const std::optional<TexelRange>& range) {
    if (!range) return {};
    return fmt::format(", mostly in {} {} to {}", what, range->first, range->last);
}

std::string strayInWords(const char* axis, const RegionShares& shares) {
    return fmt::format("along {} at {} of the points{}{}", axis, percent(1.0 - shares.asOnRamps),
                       rangeInWords("columns", shares.columns), rangeInWords("rows", shares.rows));
}

}  // namespace

Words regionWords(const RegionAgreement& regions) {
    const bool onU = !regions.u.good();
    const bool onV = !regions.v.good();
    std::string where;
    if (onU) where = strayInWords("u", regions.u);
    if (onU && onV) where += "; ";
    if (onV) where += strayInWords("v", regions.v);
    return {
        fmt::format("On a large map, {} x {} texels, the tilt is not everywhere what it is on "
                    "narrow ramps. It differs {}.",
                    regions.width, regions.height, where),
        "Look for a number that a column, a row or an angle is compared with, for a type that is "
        "too small for a column or a row, and for width(), or the larger of both, in the place of "
        "height() or the other way round. Bu and Bv compare neighbouring texels: look for a step "
        "of many texels (a fixed step in u and v), and for a mean over many of them.",
        "Option 1: What to do, step 3"};
}

Words mixedWords(const StripeAgreement& stripes) {
    const bool rows = !stripes.goodV();
    return {fmt::format("On a map whose {0} are each of one grey the tilt along {1} changes along "
                        "the {0}, where the heights do not. An interpolation between texels that "
                        "takes the fraction of the {2} for that of the {3} does this.",
                        rows ? "rows" : "columns", rows ? "v" : "u", rows ? "column" : "row",
                        rows ? "row" : "column"),
            "Each axis has a fraction of its own. Between columns weigh with fx = x - "
            "std::floor(x), between rows with fy = y - std::floor(y): look for an x where y "
            "belongs, or a y where x belongs. One texel without interpolation is enough, too.",
            "Option 1: What to do, step 3"};
}

}  // namespace ticker::tasks::bump

#include <grader/tasks/bump/words/SignWords.h>

#include <fmt/format.h>

#include <string>

namespace ticker::tasks::bump {
namespace {

constexpr const char* kOneSign =
    " Two cross products with the same sign before both always invert one axis: Equations (2) and "
    "(3) have a plus and a minus.";

constexpr const char* kRowZero =
    "Row 0 is the top of the picture: v must be 0 at the top of the sphere (the largest y) and 1 "
    "at the bottom";

/// The name of an inverted axis, and the edges of a letter that show it.
struct AxisNames {
    const char* axis;
    const char* other;
    const char* reversed;  ///< part of the hint: another place where the sign may be
    const char* rise;
    const char* wrongEdges;
    const char* rightEdges;
};
// `reversed` is for u only: to write v for 1 - v would turn a right map upside down.
constexpr AxisNames kAxisU{
    "u",
    "v",
    " Is there a 1 - u, so that columns run against Pu? Then write u instead of either.",
    "to the right",
    "left and right",
    "upper and lower"};
constexpr AxisNames kAxisV{"v", "u", "", "downwards", "upper and lower", "left and right"};

Words invertedAxisWords(const AxisNames& names) {
    return {
        fmt::format("Along {0} the bumps are inverted: where the map gets brighter {2}, the "
                    "normal leans that way instead of back against it. Along {1} it is right. So "
                    "the {3} edges of an H look lowered, and its {4} edges raised.",
                    names.axis, names.other, names.rise, names.wrongEdges, names.rightEdges),
        fmt::format("One sign is wrong: either in the difference that makes B{0}, or before the "
                    "term with B{0}. Change one of the two, and leave B{1} alone.{2}{3}",
                    names.axis, names.other, names.reversed, kOneSign),
        "Option 1: The sign trap; What to do, step 3"};
}

}  // namespace

Words invertedWords() {
    return {
        "The bumps are inverted along both axes: bright texels are lowered and dark ones "
        "raised, so that H sinks and L stands out.",
        "Both signs are wrong. If your slopes are the neighbour minus this texel, leave them and "
        "change the sign before both terms of the sum: Equation (1) subtracts Bu Pu and Bv Pv. "
        "With "
        "cross products take (2) in place of (3), or (3) in place of (2). If they are this "
        "texel minus the neighbour, turn both differences round instead.",
        "Option 1: Test it"};
}

Words invertedUWords() {
    return invertedAxisWords(kAxisU);
}

Words invertedVWords() {
    return invertedAxisWords(kAxisV);
}

Words upsideDownWords() {
    return {
        "The map stands on its head: its top row lies at the bottom of the sphere. Bumps and "
        "hollows are right.",
        std::string{kRowZero} +
            ": look for 1 - v. Then the sign of the term with Bv must turn round once. If your Pv "
            "points upwards and you use Equation (1), turn Pv. If it points downwards already, or "
            "with cross products, change the sign before the term with Bv.",
        "Option 1: What to do, step 1"};
}

Words signOnItsHeadWords(Words sign) {
    sign.message +=
        " The map stands on its head as well: its top row lies at the bottom of the "
        "sphere.";
    sign.hint = std::string{"Turn the map round first, and check again. "} + kRowZero +
                ". Pv points where v grows, so it turns round with v. That may mend the sign, too; "
                "if it does not: " +
                sign.hint;
    sign.section = "Option 1: What to do, steps 1 to 3; The sign trap";
    return sign;
}

}  // namespace ticker::tasks::bump

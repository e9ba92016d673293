#include <grader/tasks/bump/words/ParametrisationWords.h>

#include <fmt/format.h>

#include <string>

namespace ticker::tasks::bump {
namespace {

constexpr const char* kSection = "Option 1: What to do, step 1";
constexpr const char* kCheckAngles =
    "Check u and v: with the smooth unit normal n, the polar angle is acos(n.y) and the longitude "
    "an atan2 of n.x and n.z; u is the longitude over 2 pi, from 0 to 1 (plus 0.5 where atan2 "
    "gives -pi to pi), v the polar angle over pi.";

Words endWords(const std::string& axis, const std::string& what, const std::string& hint) {
    return {fmt::format("The last {} of the map lie nowhere on the sphere: {} does not go from 0 "
                        "to 1 over the whole of it.",
                        what, axis),
            hint, kSection};
}

Words lostSignWords() {
    return {
        "A falling slope was expected to tilt the normal the other way than a rising one "
        "does; it does not, or neither of them tilts it.",
        "Look for an abs, a square, a max or an unsigned type in the differences, and for a "
        "comparison that drops small ones. If there is none, the "
        "texel is not the point's: the column must be u times width(), the row v times "
        "height() of this very map, both of type int, and handed on in the same order in every "
        "call; & (width() - 1) is a modulo for powers of two alone: write % width().",
        "Option 1: What to do, step 3"};
}

std::string strayMessage(const RampJudgement& ramps) {
    std::string message =
        "The map does not lie on the sphere as spherical polar coordinates put it";
    if (ramps.fit)
        message += fmt::format(
            ": {} of the points read a texel that lies more than a twentieth of "
            "the map away from where it should be",
            percent(ramps.fit->strayShare));
    return message + ".";
}

std::string hintFromSpheres(const Hints& hints) {
    if (hints.unitSphere.response)
        return "On a sphere of radius 1 around the origin the map lies where it should: somewhere "
               "the centre is not subtracted, or the radius not divided out. ";
    if (hints.sceneSphere.response)
        return "On the exercise's own sphere the map lies where it should: use centre() and "
               "radius() (or Sphere::getNormalAt) instead of numbers. ";
    return {};
}

}  // namespace

bool isWrongAsideAlone(const std::optional<Hints>& hints) {
    return hints && hints->square.kind == RampKind::right &&
           hints->asideSphere.kind != RampKind::right;
}

Words asideWords() {
    return {
        "On a sphere ahead of the camera the map lies where it should, but not on one that lies "
        "far to the side and below: there texels are not read where they lie.",
        "Make u and v from the smooth normal, or from position - centre(), in x, y and z alike: "
        "somewhere position.x or position.y is used without the centre's.",
        kSection};
}

Words sizeWords() {
    return {
        "On square maps of about 400 texels a side the tilt is right, on maps that are much larger "
        "along "
        "one side it is not: there texels are not read where they lie.",
        "Columns go with width() and rows with height(): look for one in the place of the other "
        "(in the scaling of u and v, in a clamp, in a modulo), for a size that is written in as a "
        "number, and for one that is remembered from an earlier map (a static variable).",
        kSection};
}

Words landingWords(const Examination& examination, const std::optional<Hints>& hints) {
    const RampJudgement& ramps = examination.ramps();
    const bool lost = ramps.kind == RampKind::signLost;
    if (!hints) return lost ? lostSignWords() : Words{strayMessage(ramps), kCheckAngles, kSection};
    // The sphere that lies aside has the same square map, so that the map's size is not the cause.
    if (isWrongAsideAlone(hints)) return asideWords();
    if (hints->square.kind == RampKind::right) return sizeWords();
    const std::string spheres = hintFromSpheres(*hints);
    if (!spheres.empty()) return {strayMessage(ramps), spheres + kCheckAngles, kSection};
    if (!hints->lastRowsSeen)
        return endWords("v", "rows",
                        "v is the polar angle over pi, and the polar angle, acos(n.y) without an "
                        "abs, goes from 0 at the top to pi at the bottom. Keep v a fraction: "
                        "multiply by height() first, then make it an int.");
    if (!hints->lastColumnsSeen)
        return endWords("u", "columns",
                        "u is the longitude over 2 pi, and the longitude goes once round: an atan2 "
                        "of n.x and n.z, brought into 0 to 2 pi. Keep u a fraction: an int is 0 "
                        "nearly everywhere. Multiply by width() first, then make it an int.");
    return lost ? lostSignWords() : Words{strayMessage(ramps), kCheckAngles, kSection};
}

}  // namespace ticker::tasks::bump

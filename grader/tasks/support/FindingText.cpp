#include <grader/tasks/support/FindingText.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace ticker::tasks {
namespace {

struct Text {
    std::string_view id;
    std::string_view hint;
    std::string_view section;
};

constexpr std::string_view kShadow1 = "Soft shadows (T2.1), step 1";
constexpr std::string_view kShadow2 = "Soft shadows (T2.1), step 2";
constexpr std::string_view kShadow3 = "Soft shadows (T2.1), step 3";
constexpr std::string_view kLens1 = "Depth of field (T2.2), step 1";
constexpr std::string_view kLens2 = "Depth of field (T2.2), step 2";
constexpr std::string_view kLens3 = "Depth of field (T2.2), step 3";

// In the order of docs/findings.md: the first that applies is reported.
constexpr std::array kTexts{
    Text{"shadow.hard",
         "Cast settings().shadowRayCount rays at every point for every light, aim each at "
         "light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize, a new point "
         "for every ray, and divide the number of rays that arrive by that count.",
         kShadow1},
    Text{
        "shadow.too-few-rays",
        "Cast settings().shadowRayCount rays for every light, each to a new point within lightSize "
        "of that light, do not leave the loop early, and divide by the same number.",
        kShadow1},
    Text{"shadow.fixed-samples",
         "Draw a new point for every ray, inside of the loop over the rays, and keep none in a "
         "static variable. A generator must not be started again with the same seed for each "
         "point.",
         kShadow1},
    Text{"shadow.inverted",
         "The light that arrives is the share of rays that reach the light, not of those that are "
         "blocked.",
         kShadow2},
    Text{"shadow.all-or-nothing",
         "The share must be a fraction: the number of rays that arrive, divided by the number of "
         "rays. Dividing one int by another drops everything after the point; and a yes or no "
         "(any ray, all rays), or what the last ray met, is no number of rays.",
         kShadow2},
    Text{"shadow.ambient-scaled",
         "Scale the diffuse and the specular term only; the ambient term is there in full shadow, "
         "too.",
         kShadow3},
    Text{"shadow.specular-unshadowed", "Scale the specular term by the share, too.", kShadow3},
    Text{"shadow.diffuse-unshadowed", "Scale the diffuse term by the share, too.", kShadow3},
    Text{"shadow.lights-mixed",
         "Start counts and sums anew for each light, inside of the loop over the lights, aim at "
         "that light's own position, and divide by the number of its rays alone, not by that of "
         "the lights. Add to the colour with +=; no return before every light has had its turn. "
         "Every object of the scene may stand in the way: findClosestIntersection asks all.",
         kShadow2},
    Text{"shadow.beyond-light",
         "An object casts a shadow only if it is nearer than the light: compare the distance of "
         "the hit with that of the point that the ray aims at, (target - start).magnitude(). The "
         "distance of a hit counts in lengths of the ray's "
         "direction, so give that unit length; and ask with < or >, since two doubles are hardly "
         "ever equal (==).",
         kShadow1},
    Text{"shadow.point-jittered",
         "All shadow rays start at P + N * kShadowBias. The random offset belongs to their target: "
         "light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize.",
         kShadow1},
    Text{"shadow.direction-offset",
         "Aim at light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize: the "
         "offset belongs to the light's position, with lightSize as its radius, before the "
         "direction is normalised.",
         kShadow1},
    Text{"shadow.light-size",
         "A point in the light is light.position() + Vector3::randomInsideUnitSphere() * "
         "settings().lightSize: lightSize is the radius.",
         kShadow1},
    Text{"shadow.not-a-ball",
         "The light is a ball around light.position(): take Vector3::randomInsideUnitSphere() as "
         "it is, without normalised() and without adding anything, times settings().lightSize. "
         "Numbers of your own must go from -1 to 1 in x, y and z, not from 0 to 1, each drawn "
         "anew, and what lies outside of the unit ball is drawn again.",
         kShadow1},
    Text{"shadow.clustered",
         "Vector3::randomInsideUnitSphere() of this kit gives points that fill the ball evenly.",
         kShadow1},
    Text{"shadow.view-from-eye",
         "V points from P to O. At a mirrored surface O is not the camera, so reflections come "
         "out wrong.",
         kShadow3},
    Text{
        "shadow.threads-mixed",
        "forEachPixel works on several rows at the same time, and each calls illuminate. What "
        "illuminate counts, adds up or aims at must be its own: declare it inside of the loop over "
        "the lights, neither static nor outside of illuminate.",
        kShadow2},
    Text{"shadow.not-in-renders",
         "render sends its rays through trace, with the settings that it was given; trace calls "
         "illuminate, which casts settings().shadowRayCount rays to every light, always.",
         kShadow1},
    Text{"shadow.wrong",
         "Compare with the steps of the handout. A ray runs from the point to the light and is "
         "blocked if any object is nearer than its target. Diffuse and specular light are added "
         "once for each light (not for each ray), times one share: the number of rays that arrive, "
         "divided once by the number of rays that the loop casts. Nothing else depends on them.",
         kShadow3},
    Text{"dof.none",
         "Start every ray, in every pixel, at a random point of the aperture (x and y each from "
         "-dofAmount to dofAmount, z 0) and send it through the focal point.",
         kLens2},
    Text{"dof.too-few-rays",
         "Cast settings().dofRayCount rays for every pixel, and divide their sum by the same "
         "number.",
         kLens2},
    Text{"dof.shared-samples",
         "Draw the point of the aperture inside of the loop over the rays, a new one for each. If "
         "it is drawn there, look for a generator that is started again on the way (a seed set in "
         "the loop or in illuminate, a generator made anew): then the numbers repeat.",
         kLens2},
    Text{"dof.not-averaged",
         "Add, with +=, what trace returns for each of the dofRayCount lens rays, as it is: no "
         "std::min, pow or tone curve, and the background counts as well. Divide once by their "
         "number. The ray straight from the eye is none of them, and the sum is not static.",
         kLens3},
    Text{"dof.threads-mixed",
         "forEachPixel works on several rows at the same time. All that a pixel computes must be "
         "its own: declare focal point, sum and counters inside of the function that is given to "
         "forEachPixel, not before it, and neither static nor as members.",
         kLens3},
    Text{"dof.focal-distance",
         "The focal plane lies at z = settings().dofFocalPlane: go along the pinhole ray by "
         "dofFocalPlane / direction.z, not by dofFocalPlane.",
         kLens1},
    Text{"dof.focal-plane",
         "All rays of a pixel must meet the pinhole ray at z = settings().dofFocalPlane, in every "
         "pixel: aim each exactly at that point, with nothing random added to it.",
         kLens1},
    Text{"dof.off-centre",
         "The aperture is centred on the eye: random numbers between -1 and 1, not between 0 and "
         "1.",
         kLens2},
    Text{"dof.disc",
         "The aperture is a square in the xy-plane: x and y are two random numbers, each even over "
         "[-dofAmount, dofAmount] (no radius and angle, no product, no normal distribution), both "
         "drawn inside of the loop over the rays, and z is 0.",
         kLens2},
    Text{"dof.aperture-size",
         "The half-width of the aperture is settings().dofAmount (or half of it).", kLens2},
    Text{"dof.reused-pattern", "Draw new points of the aperture for every pixel.", kLens2},
    Text{
        "dof.antialiased",
        "The handout asks for one focal point for each pixel, found before the loop over its rays. "
        "Antialiasing on top of that is accepted.",
        kLens1},
    Text{"dof.picture-differs",
         "Look for what render and illuminate share, such as a generator that illuminate seeds "
         "anew, so that all rays of a pixel start at one point of the lens; and for anything that "
         "depends on the size of the picture or on the number of lights.",
         "Test and submit"},
    Text{"dof.wrong",
         "Compare with the steps of the handout: for every pixel dofRayCount calls of trace(scene, "
         "ray, settings().bounces), which adds the reflections, their mean, and one image.set.",
         kLens3},
    Text{"settings.hard-coded",
         "Take the numbers from settings(): shadowRayCount, lightSize, dofRayCount, "
         "dofFocalPlane, dofAmount, bounces.",
         ""}};

std::size_t rankOf(std::string_view id) {
    const auto at =
        std::find_if(kTexts.begin(), kTexts.end(), [&](const Text& text) { return text.id == id; });
    return static_cast<std::size_t>(at - kTexts.begin());
}

}  // namespace

Finding distributedFinding(std::string_view id, Severity severity, std::string seen) {
    Finding finding;
    finding.id = id;
    finding.severity = severity;
    finding.message = std::move(seen);
    if (const std::size_t rank = rankOf(id); rank < kTexts.size()) {
        finding.hint = kTexts.at(rank).hint;
        finding.section = kTexts.at(rank).section;
    }
    return finding;
}

bool hasFailure(const std::vector<Finding>& findings) {
    return std::ranges::find(findings, Severity::fail, &Finding::severity) != findings.end();
}

std::vector<Finding> mostImportantFirst(std::vector<Finding> findings) {
    std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
        if (a.severity != b.severity) return a.severity < b.severity;
        return rankOf(a.id) < rankOf(b.id);
    });
    std::vector<Finding> kept;
    std::string others;
    for (Finding& finding : findings) {
        const bool failed = !kept.empty() && kept.front().severity == Severity::fail;
        if (failed && finding.severity == Severity::fail) {
            if (others.find(finding.id) == std::string::npos)
                others += (others.empty() ? "" : ", ") + finding.id;
        } else {
            kept.push_back(std::move(finding));
        }
    }
    if (!others.empty()) kept.front().evidence.emplace_back("alsoSeen", others);
    return kept;
}

}  // namespace ticker::tasks

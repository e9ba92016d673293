#include <grader/tasks/bump/BumpFindings.h>
#include <grader/tasks/bump/BumpPicture.h>

#include <raytracer/image/ToneCurve.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ticker::tasks {
namespace {

using probe::NormalQuestion;
using raytracer::ColourRGB;
using raytracer::SceneDescription;
using raytracer::SphereDescription;
using raytracer::Vector3;

/// Ray of one pixel for the exercise's camera: from the origin along +z, field of view 45 degrees.
Vector3 rayOf(int x, int y, const raytracer::RenderSettings& settings) {
    const double pitch = 2.0 * std::tan(std::numbers::pi / 8.0) / settings.width;
    return Vector3{(x + 0.5 - 0.5 * settings.width) * pitch,
                   (0.5 * settings.height - y - 0.5) * pitch, 1.0}
        .normalised();
}

/// Where a ray from the origin first meets the sphere.
std::optional<Vector3> meet(const SphereDescription& sphere, const Vector3& direction) {
    const double along = direction.dot(sphere.centre);
    const double rest =
        along * along - sphere.centre.dot(sphere.centre) + sphere.radius * sphere.radius;
    if (rest < 0.0 || along < std::sqrt(rest)) return std::nullopt;
    return direction * (along - std::sqrt(rest));
}

/// Direct light on a sphere that no other object shadows. Mirrored light is left out: it is nearly
/// always the dark background, which is the same for any normal.
ColourRGB shade(const BumpPicture& plan, const Vector3& position, const Vector3& normal) {
    const SphereDescription& sphere = plan.scene.spheres[plan.sphere];
    const raytracer::Material& material = sphere.material;
    const Vector3 outwards = (position - sphere.centre).normalised();
    const Vector3 toViewer = (-position).normalised();
    ColourRGB colour = material.colour * plan.scene.ambientLighting;
    for (const raytracer::PointLight& light : plan.scene.pointLights) {
        const Vector3 toLight = (light.position() - position).normalised();
        if (!(outwards.dot(toLight) > 0.0)) continue;
        const ColourRGB arriving = light.illuminationAt((light.position() - position).magnitude());
        const double facing = std::max(0.0, normal.dot(toLight));
        const double mirrored = std::max(0.0, toLight.reflectIn(normal).dot(toViewer));
        colour += material.colour * arriving * (material.phongKD * facing);
        colour += light.colour() * arriving *
                  (material.phongKS * std::pow(mirrored, material.phongAlpha));
    }
    return colour * (1.0 - material.reflectivity);
}

double squaredDistance(const std::uint8_t* rgb, const ColourRGB& colour) {
    const std::array<std::uint8_t, 3> bytes = raytracer::toneMapped(colour);
    double sum = 0.0;
    for (std::size_t channel = 0; channel < bytes.size(); ++channel) {
        const double difference = static_cast<double>(rgb[channel]) - bytes[channel];
        sum += difference * difference;
    }
    return sum;
}

Finding doubt(const std::optional<double>& misfit) {
    Finding finding;
    finding.id = kBumpPictureDiffers.id;
    finding.severity = Severity::warn;
    finding.section = "Option 1: Test it";
    finding.hint =
        "Render scenes/bump-mapping.xml once more, as the handout says, and look whether "
        "the bumps are there.";
    if (!misfit) {
        finding.message =
            "Every question was answered rightly, but a picture of the handout's scenes did not "
            "come: the program left, crashed or ran out of time while it rendered.";
        return finding;
    }
    finding.message =
        "Every question was answered rightly, but a picture of the handout's scenes is no nearer "
        "to "
        "the answered normals than to a smooth sphere. Either the bumps are too weak to see, or "
        "other code drew it: a person has to look.";
    finding.evidence.emplace_back("distanceOverThatFromSmooth", *misfit);
    return finding;
}

}  // namespace

bool hasRelief(const raytracer::SceneDescription& scene) {
    return std::ranges::any_of(scene.spheres,
                               [](const auto& sphere) { return sphere.heightMap != nullptr; });
}

BumpPicture planBumpPicture(const SceneDescription& scene,
                            const raytracer::RenderSettings& settings) {
    constexpr int kStep = 3;  // pixels
    BumpPicture plan{scene, 0, {}, {}};
    const auto bumpy = std::ranges::find_if(
        scene.spheres, [](const SphereDescription& s) { return s.heightMap != nullptr; });
    if (bumpy == scene.spheres.end()) return plan;
    plan.sphere = static_cast<std::size_t>(bumpy - scene.spheres.begin());
    NormalQuestion& question = plan.question;
    question.centre = bumpy->centre;
    question.radius = bumpy->radius;
    question.material = bumpy->material;
    question.map = probe::describe(*bumpy->heightMap);
    question.company = scene;
    question.company.spheres.erase(question.company.spheres.begin() +
                                   (bumpy - scene.spheres.begin()));
    for (int y = 0; y < settings.height; y += kStep)
        for (int x = 0; x < settings.width; x += kStep)
            if (const auto position = meet(*bumpy, rayOf(x, y, settings))) {
                question.positions.push_back(*position);
                plan.pixels.push_back(static_cast<std::size_t>(y * settings.width + x));
            }
    return plan;
}

double bumpMisfit(const BumpPicture& plan, const probe::NormalAnswer& answer,
                  const std::vector<std::uint8_t>& rgb) {
    const SphereDescription& sphere = plan.scene.spheres[plan.sphere];
    double fromAnswered = 0.0;
    double fromSmooth = 0.0;
    for (std::size_t i = 0; i < plan.pixels.size(); ++i) {
        const Vector3& position = plan.question.positions[i];
        const Vector3& normal = answer.normals[i];
        if (!std::isfinite(normal.dot(normal))) continue;
        const std::uint8_t* pixel = rgb.data() + 3 * plan.pixels[i];
        const Vector3 smooth = (position - sphere.centre).normalised();
        fromAnswered += squaredDistance(pixel, shade(plan, position, normal));
        fromSmooth += squaredDistance(pixel, shade(plan, position, smooth));
    }
    if (fromSmooth > 0.0) return std::sqrt(fromAnswered / fromSmooth);
    return fromAnswered > 0.0 ? 1e9 : 1.0;
}

void doubtBumps(TaskReport& task, const std::optional<double>& misfit) {
    if (task.state != TaskState::passed || (misfit && *misfit < 1.0)) return;
    task.findings.push_back(doubt(misfit));
    task.needsReview = true;
}

}  // namespace ticker::tasks

#include <grader/tests/oracle/PlainRenderer.h>

#include <raytracer/scene/Camera.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ticker::oracle::test {

using raytracer::ColourRGB;
using raytracer::Ray;
using raytracer::RaycastHit;
using raytracer::Vector3;

PlainRenderer::PlainRenderer(const raytracer::Scene& scene,
                             const raytracer::RenderSettings& settings, const Reading& reading,
                             const Mistake& mistake, std::uint64_t seed)
    : scene_(scene), settings_(settings), reading_(reading), mistake_(mistake), engine_(seed) {}

Vector3 PlainRenderer::aimPoint() {
    const auto inCube = [&] {
        return Vector3{2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0};
    };
    Vector3 point = inCube();
    if (reading_.lightShape == LightShape::cube) return point;
    if (reading_.lightShape == LightShape::centre) return {};
    if (reading_.lightShape == LightShape::polarHelper) {
        const double r = uniform();
        const double theta = std::numbers::pi * uniform();
        const double phi = 2.0 * std::numbers::pi * uniform();
        return {r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi),
                r * std::cos(theta)};
    }
    if (reading_.lightShape == LightShape::disc) {
        while (point.x * point.x + point.y * point.y > 1.0)
            point = inCube();
        return {point.x, point.y, 0.0};
    }
    while (point.dot(point) > 1.0)
        point = inCube();
    switch (reading_.lightShape) {
        case LightShape::surface:
            return point.normalised();
        case LightShape::uniformRadius:
            return point.normalised() * uniform();
        case LightShape::halfBall:
            return {point.x, std::abs(point.y), point.z};
        default:
            return point;
    }
}

Vector3 PlainRenderer::lensPoint() {
    Vector3 point{2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0, 0.0};
    switch (mistake_.aperture) {
        case Mistake::Aperture::disc:
            while (point.dot(point) > 1.0)
                point = {2.0 * uniform() - 1.0, 2.0 * uniform() - 1.0, 0.0};
            break;
        case Mistake::Aperture::none:
            return {};
        case Mistake::Aperture::horizontal:
            point.y = 0.0;
            break;
        case Mistake::Aperture::diagonal:
            point.y = point.x;
            break;
        case Mistake::Aperture::square:
            break;
    }
    point += Vector3{mistake_.lensOffsetX, mistake_.lensOffsetY, 0.0};
    return point * (settings_.dofAmount * reading_.apertureFactor);
}

// Along one axis, in pixels from the middle.
double PlainRenderer::placeInPixel() {
    if (reading_.pixelSpread == 0.0) return 0.0;
    return (uniform() - 0.5) * reading_.pixelSpread;
}

ColourRGB PlainRenderer::lightOf(std::size_t light, const RaycastHit& hit,
                                 const Vector3& toViewer) {
    const raytracer::PointLight& lamp = scene_.pointLights()[light];
    const raytracer::SceneObject& object = *hit.object;
    const Vector3& P = hit.location;
    const Vector3& N = hit.normal;
    const double distance = (lamp.position() - P).magnitude();
    const Vector3 toLight = (lamp.position() - P).normalised();
    ColourRGB diffuse;
    ColourRGB specular;
    const auto shade = [&](const Vector3& towards, double falloffDistance) {
        const ColourRGB arriving = lamp.illuminationAt(falloffDistance);
        diffuse = object.colour() * arriving * (object.phongKD() * std::max(0.0, N.dot(towards)));
        const double mirrored = std::max(0.0, towards.reflectIn(N).dot(toViewer));
        specular =
            lamp.colour() * arriving * (object.phongKS() * std::pow(mirrored, object.phongAlpha()));
    };
    shade(toLight, distance);
    const double size = settings_.lightSize * mistake_.lightSizeFactor;
    const Vector3 offset =
        Vector3{mistake_.lightOffset[0], mistake_.lightOffset[1], mistake_.lightOffset[2]} *
        settings_.lightSize;
    ColourRGB sum;
    int reached = 0;
    for (int i = 0; i < settings_.shadowRayCount; ++i) {
        Vector3 start = P + (reading_.biasAlongLight ? toLight : N) * reading_.shadowBias;
        const Vector3 aim = lamp.position() + offset + aimPoint() * size;
        if (mistake_.pointJitter > 0.0) start += aimPoint() * mistake_.pointJitter;
        Vector3 towards = aim - start;
        double limit = towards.magnitude();
        if (mistake_.directionOffset) {
            towards = toLight + aimPoint() * size;
            limit = distance * towards.magnitude();
        }
        if (reading_.shadowReach == ShadowReach::toCentre) limit = distance;
        if (reading_.shadowReach == ShadowReach::endless)
            limit = std::numeric_limits<double>::infinity();
        const auto occluder = scene_.findClosestIntersection({start, towards.normalised()});
        const bool reaches = !occluder || occluder->distance > limit;
        reached += reaches ? 1 : 0;
        if (reading_.phong != PhongReading::central) {
            const bool own = reading_.phong == PhongReading::perSample;
            shade((aim - P).normalised(), own ? (aim - P).magnitude() : distance);
            if (reaches) sum += (diffuse + specular) / settings_.shadowRayCount;
        }
    }
    if (reading_.phong != PhongReading::central) return sum;
    double share = static_cast<double>(reached) / settings_.shadowRayCount;
    if (mistake_.allOrNothing) share = reached == settings_.shadowRayCount ? 1.0 : 0.0;
    if (mistake_.litIfAny) share = reached > 0 ? 1.0 : 0.0;
    if (mistake_.shadowInverted) share = 1.0 - share;
    const double times =
        mistake_.lightsMixed ? static_cast<double>(scene_.pointLights().size() - light) : 1.0;
    ColourRGB colour = diffuse * (mistake_.diffuseUnshadowed ? 1.0 : share) * times;
    colour += specular * (mistake_.specularUnshadowed ? 1.0 : share) * times;
    if (mistake_.ambientScaled)
        colour += object.colour() * scene_.ambientLighting() * (share - 1.0);
    return colour;
}

ColourRGB PlainRenderer::illuminate(const RaycastHit& hit, const Vector3& viewer) {
    const Vector3 from = reading_.viewerIsEye ? Vector3{} : viewer;
    const Vector3 toViewer = (from - hit.location).normalised();
    ColourRGB colour = hit.object->colour() * scene_.ambientLighting();
    for (std::size_t light = 0; light < scene_.pointLights().size(); ++light)
        colour += lightOf(light, hit, toViewer);
    return colour;
}

ColourRGB PlainRenderer::trace(const Ray& ray, int bouncesLeft) {
    const auto hit = scene_.findClosestIntersection(ray);
    if (!hit) return ColourRGB{0.001};
    const ColourRGB direct = illuminate(*hit, ray.origin);
    const double share = hit->object->reflectivity();
    if (bouncesLeft == 0 || share == 0.0) return direct;
    const Ray reflected{hit->location + hit->normal * 1e-4,
                        (-ray.direction).reflectIn(hit->normal)};
    return direct * (1.0 - share) + trace(reflected, bouncesLeft - 1) * share;
}

raytracer::Image PlainRenderer::render() {
    const raytracer::Camera camera{settings_};
    raytracer::Image image{settings_};
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const Ray pinhole = camera.castRay(x, y);
            const double focal = settings_.dofFocalPlane * mistake_.focalFactor;
            const Vector3 focalPoint =
                pinhole.evaluateAt(mistake_.focalByDistance ? focal : focal / pinhole.direction.z);
            const double pixel = 2.0 * std::tan(std::numbers::pi / 8.0) / settings_.width * focal;
            ColourRGB sum;
            for (int i = 0; i < settings_.dofRayCount; ++i) {
                const Vector3 lens = lensPoint();
                const double across = placeInPixel() * pixel;
                const Vector3 target = focalPoint + Vector3{across, placeInPixel() * pixel, 0.0};
                sum += trace({lens, (target - lens).normalised()}, settings_.bounces);
            }
            image.set(x, y, sum / settings_.dofRayCount * mistake_.pixelScale);
        }
    }
    return image;
}

}  // namespace ticker::oracle::test

#include <grader/tasks/maintick/mixed/Edges.h>

#include <grader/tasks/support/Channels.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ticker::tasks::maintick {
namespace {

constexpr double kCosine = 0.02;  ///< of N.L, R.V and D.N

/// Half the length of the chord of a ball on a line; 0 if the line misses the ball.
/// @param away  Distance of the line from the ball's centre.
double halfChord(double radius, double away) {
    return away < radius ? std::sqrt((radius - away) * (radius + away)) : 0.0;
}

double mirroredOf(const LitSetup& setup, const raytracer::PointLight& light) {
    const Vector3 towardsViewer = (setup.O - setup.P).normalised();
    return wayTo(setup, light).direction.reflectIn(setup.N).dot(towardsViewer);
}

double sineOf(double cosine) {
    return std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}

constexpr double kFloat = 6e-8;  ///< half a step of single precision, relative

/// How far the direction from P to another place turns if both are rounded.
double turnOf(const LitSetup& setup, const Vector3& to) {
    return kFloat * ((setup.P.magnitude() + to.magnitude()) / (to - setup.P).magnitude() + 2.0);
}

/// The largest error, in single precision, of what one light adds to the colour; 0 for a light
/// behind the surface. Near a cosine of 1 a turn of a direction hardly counts.
double errorOf(const LitSetup& setup, const raytracer::PointLight& light) {
    const raytracer::Material& material = setup.scene.spheres[0].material;
    const double distance = (light.position() - setup.P).magnitude();
    const double turn = turnOf(setup, light.position());
    const double facing = facingOf(setup, light);
    if (facing <= 0.0) return 0.0;
    const double arriving = largestChannel(light.illuminationAt(distance));
    const double ofI = 2.0 * turn + 6.0 * kFloat;
    const double error = material.phongKD * largestChannel(material.colour) * arriving *
                         (turn * sineOf(facing) + 4.0 * kFloat + facing * ofI);
    const double mirrored = mirroredOf(setup, light);
    if (mirrored <= 0.0) return error;
    const double ofCosine =
        ((turn + turnOf(setup, setup.O)) * sineOf(mirrored) + 6.0 * kFloat) / mirrored;
    return error + material.phongKS * largestChannel(light.colour()) * arriving *
                       std::pow(mirrored, material.phongAlpha) *
                       (material.phongAlpha * (ofCosine + kFloat) + ofI);
}

}  // namespace

Sight sightOf(const raytracer::SphereDescription& sphere, const Ray& ray, double reach,
              const Margin& margin) {
    const Vector3 way = sphere.centre - ray.origin;
    const double middle = way.dot(ray.direction);
    const double away = (way - ray.direction * middle).magnitude();
    const double edge = margin.least + margin.spread * std::max(0.0, middle);
    const double large = halfChord(sphere.radius + edge, away);
    if (large == 0.0 || middle + large < 0.0 || middle - large > reach + edge) return Sight::open;
    const double small = halfChord(sphere.radius - edge, away);
    if (small == 0.0) return Sight::unsure;
    const bool isAhead = middle - large > edge && middle - small < reach - edge;
    const bool isAround =
        middle - small < 0.0 && middle + small > 0.0 && middle + large < reach - edge;
    return isAhead || isAround ? Sight::blocked : Sight::unsure;
}

Sight sightOf(const raytracer::PlaneDescription& plane, const Ray& ray, double reach,
              const Margin& margin) {
    const Vector3 normal = plane.normal.normalised();
    const double rising = ray.direction.dot(normal);
    if (std::abs(rising) < kCosine + margin.spread) return Sight::unsure;
    const double distance = (plane.point - ray.origin).dot(normal) / rising;
    const double slack =
        (margin.least + margin.spread * std::max(0.0, distance)) / std::abs(rising);
    if (distance < -slack || distance > reach + slack) return Sight::open;
    return distance > slack && distance < reach - slack ? Sight::blocked : Sight::unsure;
}

Sight sightOf(const raytracer::SceneDescription& scene, const Ray& ray, double reach, int without,
              const Margin& margin) {
    Sight sight = Sight::open;
    int object = 0;
    const auto look = [&](const auto& each) {
        if (object++ == without || sight == Sight::unsure) return;
        const Sight own = sightOf(each, ray, reach, margin);
        if (own != Sight::open) sight = own;
    };
    for (const auto& sphere : scene.spheres)
        look(sphere);
    for (const auto& plane : scene.planes)
        look(plane);
    return sight;
}

Ray wayTo(const LitSetup& setup, const raytracer::PointLight& light) {
    return {setup.P, (light.position() - setup.P).normalised()};
}

double facingOf(const LitSetup& setup, const raytracer::PointLight& light) {
    return setup.N.dot(wayTo(setup, light).direction);
}

bool isOffEdges(const LitSetup& setup) {
    if ((setup.O - setup.P).normalised().dot(setup.N) < kCosine) return false;
    return std::ranges::all_of(setup.scene.pointLights, [&](const raytracer::PointLight& light) {
        const double facing = facingOf(setup, light);
        const double mirrored = mirroredOf(setup, light);
        if (std::abs(facing) < kCosine) return false;
        return facing > 0.0 ? std::abs(mirrored) > kCosine : mirrored < -kCosine;
    });
}

bool isRightInFloats(const LitSetup& setup) {
    double error = 0.0;
    for (const raytracer::PointLight& light : setup.scene.pointLights)
        error += errorOf(setup, light);
    return error <= kTolerance / 2.0 * std::max(largestChannel(phong(setup)), 1e-6);
}

}  // namespace ticker::tasks::maintick

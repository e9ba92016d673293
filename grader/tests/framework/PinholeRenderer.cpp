#include "PinholeRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ticker {
namespace {

using raytracer::ColourRGB;
using raytracer::Material;
using raytracer::PlaneDescription;
using raytracer::PointLight;
using raytracer::SceneDescription;
using raytracer::SphereDescription;
using raytracer::Vector3;

constexpr double kBias = 1e-4;
constexpr double kBackground = 0.001;

double inner(const Vector3& a, const Vector3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector3 unit(const Vector3& v) {
    const double length = std::hypot(v.x, v.y, v.z);
    return {v.x / length, v.y / length, v.z / length};
}

/// A hit of a ray; `distance` is negative for a miss.
struct Meeting {
    double distance = -1.0;
    Vector3 normal;
    const Material* material = nullptr;
};

// By the ray's closest approach to the centre and half the chord (the direction has unit length).
double meetSphere(const SphereDescription& sphere, const Vector3& from, const Vector3& direction) {
    const Vector3 offset = sphere.centre - from;
    const double closest = inner(offset, direction);
    const Vector3 across = offset - direction * closest;
    const double inside = sphere.radius * sphere.radius - inner(across, across);
    if (inside < 0.0) return -1.0;
    const double halfChord = std::sqrt(inside);
    return closest - halfChord > 0.0 ? closest - halfChord : closest + halfChord;
}

double meetPlane(const PlaneDescription& plane, const Vector3& from, const Vector3& direction) {
    const double approach = inner(direction, plane.normal);
    if (approach == 0.0) return -1.0;
    return inner(plane.point - from, plane.normal) / approach;
}

Meeting meetFirst(const SceneDescription& scene, const Vector3& from, const Vector3& direction) {
    Meeting first;
    const auto isFirst = [&](double distance) {
        return distance > 0.0 && (first.distance < 0.0 || distance < first.distance);
    };
    for (const SphereDescription& sphere : scene.spheres) {
        const double distance = meetSphere(sphere, from, direction);
        if (isFirst(distance))
            first = {distance, unit(from + direction * distance - sphere.centre), &sphere.material};
    }
    for (const PlaneDescription& plane : scene.planes) {
        const double distance = meetPlane(plane, from, direction);
        if (isFirst(distance)) first = {distance, unit(plane.normal), &plane.material};
    }
    return first;
}

// Ambient + kD I max(0, N.L) + kS I max(0, R.V)^alpha for each light that is not hidden.
ColourRGB directLight(const SceneDescription& scene, const Meeting& meeting, const Vector3& point,
                      const Vector3& viewer) {
    const Material& material = *meeting.material;
    const Vector3 toViewer = unit(viewer - point);
    ColourRGB sum = material.colour * scene.ambientLighting;
    for (const PointLight& light : scene.pointLights) {
        const Vector3 way = light.position() - point;
        const double squared = inner(way, way);
        const Vector3 toLight = unit(way);
        const Meeting between = meetFirst(scene, point + meeting.normal * kBias, toLight);
        if (between.distance > 0.0 && between.distance * between.distance < squared) continue;
        const double power = light.intensity() / (4.0 * std::numbers::pi * squared);
        const double facing = std::max(0.0, inner(meeting.normal, toLight));
        const Vector3 mirrored = meeting.normal * (2.0 * inner(meeting.normal, toLight)) - toLight;
        const double gleam =
            std::pow(std::max(0.0, inner(mirrored, toViewer)), material.phongAlpha);
        const ColourRGB& shade = light.colour();
        sum += material.colour * shade * (power * material.phongKD * facing);
        sum += shade * shade * (power * material.phongKS * gleam);
    }
    return sum;
}

ColourRGB lightAlong(const SceneDescription& scene, const Vector3& from, const Vector3& direction,
                     int bounces) {
    const Meeting meeting = meetFirst(scene, from, direction);
    if (meeting.material == nullptr) return ColourRGB{kBackground};
    const Vector3 point = from + direction * meeting.distance;
    const ColourRGB direct = directLight(scene, meeting, point, from);
    const double share = meeting.material->reflectivity;
    if (bounces == 0 || share == 0.0) return direct;
    const Vector3 onwards = direction - meeting.normal * (2.0 * inner(direction, meeting.normal));
    return direct * (1.0 - share) +
           lightAlong(scene, point + meeting.normal * kBias, onwards, bounces - 1) * share;
}

std::uint8_t toByte(double linear) {
    const double powered = std::pow(std::max(linear, 0.0), 1.3);
    const double display = powered / (powered + std::pow(0.25, 1.3));
    return static_cast<std::uint8_t>(std::clamp(255.0 * std::pow(display, 1.0 / 2.2), 0.0, 255.0));
}

}  // namespace

std::vector<std::uint8_t> renderPinhole(const SceneDescription& scene, int width, int height,
                                        int bounces) {
    // 45 degrees across the width; square pixels.
    const double halfWidth = std::tan(std::numbers::pi / 8.0);
    const double halfHeight = halfWidth * height / width;
    std::vector<std::uint8_t> bytes;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const double right = halfWidth * (2.0 * (column + 0.5) / width - 1.0);
            const double up = halfHeight * (1.0 - 2.0 * (row + 0.5) / height);
            const ColourRGB c = lightAlong(scene, {}, unit({right, up, 1.0}), bounces);
            for (const double component : {c.r, c.g, c.b})
                bytes.push_back(toByte(component));
        }
    }
    return bytes;
}

}  // namespace ticker

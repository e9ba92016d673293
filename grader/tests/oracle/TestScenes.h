#ifndef TICKER_TESTS_ORACLE_TESTSCENES_H
#define TICKER_TESTS_ORACLE_TESTSCENES_H

#include <raytracer/scene/SceneDescription.h>

#include <memory>
#include <utility>
#include <vector>

namespace ticker::oracle::test {

/// The colour #RRGGBB.
inline raytracer::ColourRGB hexColour(unsigned rgb) {
    return {((rgb >> 16U) & 255U) / 255.0, ((rgb >> 8U) & 255U) / 255.0, (rgb & 255U) / 255.0};
}

inline raytracer::SphereDescription sphere(const raytracer::Vector3& centre, double radius,
                                           unsigned rgb) {
    raytracer::SphereDescription result;
    result.centre = centre;
    result.radius = radius;
    result.material.colour = hexColour(rgb);
    return result;
}

inline raytracer::PlaneDescription plane(const raytracer::Vector3& point,
                                         const raytracer::Vector3& normal, unsigned rgb) {
    raytracer::PlaneDescription result;
    result.point = point;
    result.normal = normal;
    result.material.colour = hexColour(rgb);
    return result;
}

/// The handout's second scene.
inline raytracer::SceneDescription distributedScene() {
    raytracer::SceneDescription scene;
    scene.ambientLighting = hexColour(0x050505);
    scene.pointLights.emplace_back(raytracer::Vector3{-1.5, 4.5, 2.0}, hexColour(0xe1f2ef), 450.0);
    scene.spheres = {sphere({0.5, -0.26398, 3.51805}, 0.5, 0x051a34),
                     sphere({-0.2, 0.01504, 4.99187}, 0.5, 0x051a34),
                     sphere({-0.9, 0.29406, 6.46569}, 0.5, 0x051a34),
                     sphere({-1.6, 0.57308, 7.93951}, 0.5, 0x051a34)};
    scene.planes = {plane({0.0, -0.47623, 5.085}, {0.0, 0.9825, -0.186}, 0x82898f),
                    plane({0.0, 0.0, 12.0}, {0.0, 0.0, -1.0}, 0x516e7e)};
    return scene;
}

/// Two lights of different colours, a bumpy sphere, a mirror, a penumbra of two spheres, different
/// exponents, and a plane that lies between the lights.
inline raytracer::SceneDescription variedScene() {
    raytracer::SceneDescription scene;
    scene.ambientLighting = hexColour(0x101418);
    scene.pointLights.emplace_back(raytracer::Vector3{-1.5, 2.5, 2.0}, hexColour(0xffe0c0), 150.0);
    scene.pointLights.emplace_back(raytracer::Vector3{1.8, 1.6, 3.0}, hexColour(0xa0c0ff), 80.0);
    scene.spheres = {sphere({0.4, -0.1, 3.6}, 0.4, 0xd06020),
                     sphere({-0.5, 0.1, 4.2}, 0.45, 0x309050),
                     sphere({-0.45, 0.75, 3.6}, 0.2, 0x888888)};
    scene.spheres[1].material.phongAlpha = 23.0;
    scene.spheres[1].material.reflectivity = 0.6;
    scene.spheres[2].material.phongAlpha = 4.5;
    std::vector<double> heights;
    for (int row = 0; row < 16; ++row)
        for (int column = 0; column < 24; ++column)
            heights.push_back(0.03 * ((column * 7 + row * row * 3) % 11));
    scene.spheres[0].heightMap =
        std::make_shared<const raytracer::HeightMap>(24, 16, std::move(heights));
    scene.planes = {plane({0.0, -0.6, 0.0}, {0.0, 1.0, -0.1}, 0x808080),
                    plane({2.6, 0.0, 6.0}, {-1.0, 0.1, -0.3}, 0x606090)};
    scene.planes[0].material.phongKS = 0.3;
    scene.planes[1].material.reflectivity = 0.0;
    return scene;
}

/// Two small mirrors that show a third sphere to pixel (4, 12) of 24 x 18: each mirror enlarges the
/// error of the one before about twenty times.
inline raytracer::SceneDescription smallMirrorsScene() {
    raytracer::SceneDescription scene;
    scene.ambientLighting = raytracer::ColourRGB{1.0};
    scene.spheres = {sphere({-0.93034, -0.5107, 3.60624}, 0.21301, 0x6f4929),
                     sphere({-0.7783, 0.49851, 2.56915}, 0.14573, 0x1b72f3),
                     sphere({0.30704, 0.36298, 3.58625}, 0.15733, 0x17ea21)};
    scene.spheres[0].material.reflectivity = 0.8;
    scene.spheres[1].material.reflectivity = 0.8;
    scene.planes = {plane({0.0, 0.0, 12.0}, {0.0, 0.0, -1.0}, 0x516e7e)};
    return scene;
}

}  // namespace ticker::oracle::test

#endif

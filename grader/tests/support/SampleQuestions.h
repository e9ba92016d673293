#ifndef TICKER_TESTS_SUPPORT_SAMPLEQUESTIONS_H
#define TICKER_TESTS_SUPPORT_SAMPLEQUESTIONS_H

#include <grader/probe/Question.h>

#include <memory>

namespace ticker::tests {

/// One bumpy sphere above a plane under one light: every kind of object, a few pixels wide.
inline raytracer::SceneDescription smallScene() {
    raytracer::SceneDescription scene;
    scene.ambientLighting = raytracer::ColourRGB{0.05};
    scene.pointLights.emplace_back(raytracer::Vector3{1.0, 3.0, 2.0}, raytracer::ColourRGB{1.0},
                                   100.0);
    raytracer::SphereDescription sphere;
    sphere.centre = {0.0, 0.0, 3.5};
    sphere.radius = 0.7;
    sphere.material.colour = raytracer::ColourRGB{0.9, 0.3, 0.1};
    sphere.heightMap = std::make_shared<const raytracer::HeightMap>(
        raytracer::HeightMap::fromBytes(8, 4, std::vector<std::uint8_t>(32, 100)));
    scene.spheres.push_back(sphere);
    raytracer::PlaneDescription plane;
    plane.point = {0.0, -0.7, 0.0};
    plane.normal = {0.0, 1.0, 0.0};
    plane.material.colour = raytracer::ColourRGB{0.5};
    scene.planes.push_back(plane);
    return scene;
}

/// Settings of a picture of 8 x 6 pixels with few rays.
inline raytracer::RenderSettings smallSettings() {
    raytracer::RenderSettings settings;
    settings.width = 8;
    settings.height = 6;
    settings.dofRayCount = 3;
    settings.shadowRayCount = 2;
    settings.seed = 7;
    return settings;
}

/// Three positions on a sphere with a map of columns and rows.
inline probe::NormalQuestion normalQuestion() {
    probe::NormalQuestion question;
    question.centre = {0.0, 0.0, 3.5};
    question.radius = 1.0;
    question.material.colour = {0.2, 0.4, 0.6};
    question.company.spheres.push_back({{2.0, 0.0, 5.0}, 0.5, {}, nullptr});
    question.map.width = 4;
    question.map.height = 4;
    question.map.columns = {0.0, 1.0, 2.0, 0.5};
    question.map.rows = {0.0, 0.25, 0.5, 0.75};
    question.positions = {{0.0, 0.0, 2.5}, {1.0, 0.0, 3.5}, {0.6, 0.8, 3.5}};
    return question;
}

/// Two points of the plane, one of them in the sphere's shadow.
inline probe::IlluminateQuestion illuminateQuestion(std::uint32_t eventCapacity = 0) {
    probe::IlluminateQuestion question;
    question.scene = smallScene();
    question.settings = smallSettings();
    question.points = {{1, {0.0, -0.7, 2.0}, {0.0, 1.0, 0.0}, {}},
                       {1, {-0.3, -0.7, 3.9}, {0.0, 1.0, 0.0}, {}}};
    question.eventCapacity = eventCapacity;
    return question;
}

inline probe::RenderQuestion renderQuestion(std::uint32_t eventCapacity = 0) {
    probe::RenderQuestion question;
    question.scene = smallScene();
    question.settings = smallSettings();
    question.repetitions = 2;
    question.eventCapacity = eventCapacity;
    return question;
}

}  // namespace ticker::tests

#endif

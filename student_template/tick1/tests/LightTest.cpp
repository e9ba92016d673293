// M2, M3.2 and M4: colours of chosen points and rays. The grader asks the same kind of questions,
// in other scenes.
#include "MainTick.h"

#include <raytracer/render/Renderer.h>

namespace raytracer::tests {
namespace {

constexpr ColourRGB kAmbient{0.05, 0.05, 0.3};
constexpr ColourRGB kLit{1.95358, 0.525895, 0.668091};

std::string text(const ColourRGB& c) {
    return triple(c.r, c.g, c.b);
}

bool isNear(const ColourRGB& a, const ColourRGB& b) {
    const double slack = 5e-3 * std::max({b.r, b.g, b.b, 1e-3});
    return std::abs(a.r - b.r) <= slack && std::abs(a.g - b.g) <= slack &&
           std::abs(a.b - b.b) <= slack;
}

/// A mirroring floor at y = 0, to which tests add lights and objects.
class Room : public MainTick {
protected:
    Room(const char* task, const char* section, std::vector<const char*> needs)
        : MainTick(task, section, std::move(needs)) {
        scene_.ambientLighting = {0.1, 0.2, 0.3};
        Material floor;
        floor.colour = {0.5, 0.25, 1.0};
        floor.reflectivity = 0.5;
        scene_.planes.push_back({{}, {0.0, 1.0, 0.0}, floor});
    }

    void addLight(const Vector3& at) {
        scene_.pointLights.emplace_back(at, ColourRGB{1.0, 0.5, 0.25}, 100.0);
    }
    void addBall(const Vector3& at, double radius) {
        scene_.spheres.push_back({at, radius, {}, nullptr});
    }

    /// Of one point of the floor.
    [[nodiscard]] ColourRGB colour() const {
        const Scene& built = keptScene(scene_);
        return Renderer{RenderSettings{}}.illuminate(
            built, *built.objects().back(), {1.0, 0.0, 4.0}, {0.0, 1.0, 0.0}, {-0.5, 2.0, 4.5});
    }
    void askLight(const ColourRGB& expected, const Question& question) const {
        const ColourRGB got = colour();
        settle(isNear(got, expected), question, text(expected), text(got));
    }
    void askTrace(const Ray& ray, int bounces, const ColourRGB& expected,
                  const Question& question) const {
        const ColourRGB got = Renderer{RenderSettings{}}.trace(keptScene(scene_), ray, bounces);
        settle(isNear(got, expected), question, text(expected), text(got));
    }

    SceneDescription scene_;
};

class PhongIllumination : public Room {
protected:
    PhongIllumination() : Room("M2", "Phong illumination (M2)", {}) {}
};

TEST_F(PhongIllumination, AmbientLightIsAdded) {
    askLight(kAmbient, {"a point without any point light",
                        "Ambient light: object.colour() * scene.ambientLighting()."});
}
TEST_F(PhongIllumination, DiffuseLightIsAdded) {
    addLight({2.0, 2.0, 4.0});
    scene_.planes[0].material.phongKS = 0.0;
    askLight({0.61941, 0.192353, 0.584705},
             {"a dull point (ks = 0) in the light",
              "The diffuse term: max(0, N.L), with N and L of length 1, and kd."});
}
TEST_F(PhongIllumination, HighlightsAreAdded) {
    addLight({2.0, 2.0, 4.0});
    askLight(kLit, {"a glossy point in the light",
                    "The specular term: max(0, R.V) to the power alpha, V from P to O, and the "
                    "colour of the light twice."});
}
TEST_F(PhongIllumination, LightsAddUp) {
    addLight({2.0, 2.0, 4.0});
    addLight({0.0, 3.0, 2.0});
    askLight({2.13865, 0.572162, 0.759412},
             {"a glossy point in the light of two lamps", "Add the terms of every light."});
}

/// Compares with the colour that the same code gives with nothing in the way, so that a mistake of
/// M2 does not count here.
class Shadows : public Room {
protected:
    Shadows() : Room("M3.2", "Shadows (M3.2)", {"M1", "M2"}) { addLight({2.0, 2.0, 4.0}); }

    void SetUp() override {
        scene_.planes[0].point.y = -9.0;
        lit_ = colour();
        scene_.pointLights.clear();
        dark_ = colour();
        addLight({2.0, 2.0, 4.0});
        scene_.planes[0].point.y = 0.0;
        // Code that casts its shadow rays from the light may count a point as hidden if they miss
        // it.
        if (isNear(lit_, dark_)) lit_ = colour();
    }

    ColourRGB lit_;
    ColourRGB dark_;
};

TEST_F(Shadows, ABallBeforeTheLightShades) {
    addBall({1.5, 1.0, 4.0}, 0.3);
    askLight(dark_,
             {"a point with a ball before the light",
              "Cast a ray from P + N * kShadowBias towards the light; ambient light stays."});
}
TEST_F(Shadows, ABallBehindTheLightDoesNotShade) {
    addBall({3.0, 4.0, 4.0}, 0.5);
    askLight(lit_, {"a point with a ball behind the light",
                    "Only a hit that is nearer than the light shades."});
}
TEST_F(Shadows, ASurfaceDoesNotShadeItself) {
    askLight(lit_, {"a point with nothing but its own surface",
                    "The ray must start a little above the surface."});
}

class Reflections : public Room {
protected:
    Reflections() : Room("M4", "Reflections (M4)", {"M2", "M3.1"}) {
        Material wall;
        wall.colour = {0.0, 1.0, 0.0};
        wall.reflectivity = 0.5;
        scene_.planes.push_back({{0.0, 0.0, 6.0}, {0.0, 0.0, -1.0}, wall});
    }
    const Ray ray_{{0.0, 3.0, 0.0}, {0.0, -0.6, 0.8}};
};

TEST_F(Reflections, WithoutBouncesTheDirectLightStays) {
    // Without M3.1 no ray meets the floor: a ball makes sure that the stub of M4 is called.
    SceneDescription ball;
    ball.spheres.push_back({{0.0, 0.0, 5.0}, 1.0, {}, nullptr});
    static_cast<void>(Renderer{RenderSettings{}}.trace(keptScene(ball), {{}, {0.0, 0.0, 1.0}}, 1));
    askTrace(
        ray_, 0, kAmbient,
        {"a mirror without bounces left", "Without bounces left the direct light counts whole."});
}
TEST_F(Reflections, AMirrorIsBlendedIn) {
    askTrace(ray_, 1, {0.025, 0.125, 0.15},
             {"a mirror with one bounce left",
              "Mirror the direction that points back along the ray, hand bouncesLeft - 1 on, and "
              "blend: direct * (1 - rho) + reflected * rho, with rho = object.reflectivity()."});
}
TEST_F(Reflections, MirrorsShowMirrors) {
    askTrace(ray_, 2, {0.02525, 0.07525, 0.15025},
             {"a mirror in a mirror",
              "Hand bouncesLeft - 1 on; a mirrored ray that meets nothing shows the background."});
}
TEST_F(Reflections, TheBackgroundStays) {
    askTrace({{0.0, 3.0, 0.0}, {0.0, 0.6, -0.8}}, 2, kBackgroundColour,
             {"a ray that meets nothing", "Return kBackgroundColour."});
}

}  // namespace
}  // namespace raytracer::tests

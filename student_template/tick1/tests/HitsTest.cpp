// M1 and M3.1: what a sphere and a plane say of chosen rays. The grader asks the same kind of
// questions, of other objects.
#include "MainTick.h"

#include <raytracer/scene/Scene.h>

namespace raytracer::tests {
namespace {

std::string text(const Vector3& v) {
    return triple(v.x, v.y, v.z);
}

bool isNear(double a, double b) {
    return std::abs(a - b) <= 1e-3 * std::max(1.0, std::abs(b));
}
bool isNear(const Vector3& a, const Vector3& b) {
    return isNear(a.x, b.x) && isNear(a.y, b.y) && isNear(a.z, b.z);
}

class Hits : public MainTick {
protected:
    using MainTick::MainTick;

    /// Asks the scene's only object. A distance of 0 stands for no hit.
    void ask(const Ray& ray, double distance, const Vector3& normal,
             const Question& question) const {
        const Scene& built = keptScene(scene_);
        const auto hit = built.objects().front()->intersectionWith(ray);
        const auto words = [](double s, const Vector3& at, const Vector3& n) {
            return "a hit at distance " + inWords(s) + ", location " + text(at) + ", normal " +
                   text(n);
        };
        const Vector3 location = ray.evaluateAt(distance);
        const bool isRight = distance > 0.0 ? hit && isNear(hit->distance, distance) &&
                                                  isNear(hit->location, location) &&
                                                  isNear(hit->normal, normal)
                                            : !hit;
        settle(isRight, question, distance > 0.0 ? words(distance, location, normal) : "no hit",
               hit ? words(hit->distance, hit->location, hit->normal) : "no hit");
    }

    SceneDescription scene_;
};

class Spheres : public Hits {
protected:
    Spheres() : Hits("M1", "Spheres (M1)") {
        scene_.spheres.push_back({{1.0, 0.0, 5.0}, 2.0, {}, nullptr});
    }
    const Vector3 ahead_{0.0, 0.0, 1.0};
};

TEST_F(Spheres, ARayFromOutsideHits) {
    ask({{1.0, 1.2, 0.0}, ahead_}, 3.4, {0.0, 0.6, -0.8},
        {"a ray from outside",
         "Of the two roots the smaller positive one is the hit; check a, b and c."});
}
TEST_F(Spheres, ARayThatHasPassedMisses) {
    ask({{1.0, 1.2, 9.0}, ahead_}, 0.0, {},
        {"a ray with the sphere behind it", "Negative distances lie behind the ray."});
}
TEST_F(Spheres, ARayBesideMisses) {
    ask({{1.0, 2.5, 0.0}, ahead_}, 0.0, {},
        {"a ray that passes by", "A negative discriminant means no hit."});
}
TEST_F(Spheres, ARayFromInsideHits) {
    ask({{1.0, 0.0, 4.0}, ahead_}, 3.0, {0.0, 0.0, 1.0},
        {"a ray from inside",
         "From inside one root is negative; the other one is the hit. The normal points away from "
         "the centre."});
}

class Planes : public Hits {
protected:
    Planes() : Hits("M3.1", "Planes (M3.1)") {
        scene_.planes.push_back({{0.0, -1.0, 0.0}, {0.0, 2.0, 0.0}, {}});
    }
    const Vector3 up_{0.0, 0.6, 0.8};
};

TEST_F(Planes, ARayFromAboveHits) {
    ask({{3.0, 2.0, 1.0}, {0.0, -0.6, 0.8}}, 5.0, {0.0, 1.0, 0.0},
        {"a ray from above", "s = (Q - O).N / D.N"});
}
TEST_F(Planes, ARayFromBelowHits) {
    ask({{0.0, -4.0, 0.0}, up_}, 5.0, {0.0, 1.0, 0.0},
        {"a ray from below",
         "The sign of D.N alone says nothing: a positive s is a hit, from either side."});
}
TEST_F(Planes, ARayThatLeavesMisses) {
    ask({{0.0, 2.0, 0.0}, up_}, 0.0, {},
        {"a ray that leaves the plane behind", "A negative s lies behind the ray."});
}

}  // namespace
}  // namespace raytracer::tests

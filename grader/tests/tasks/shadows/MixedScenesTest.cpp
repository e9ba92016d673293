// Properties of the mixed scenes of T2.1, and the trait that is named where their answers are
// wrong.
#include <grader/tasks/shadows/mixed/MixedScenes.h>
#include <grader/tasks/shadows/mixed/ShadowTraits.h>

#include <questions/RayGeometry.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace ticker::tasks {
namespace {

using raytracer::PointLight;

constexpr std::uint64_t kSeeds = 40;

std::vector<ShadowQuestion> drawn(std::uint64_t seed) {
    Draw draw{seed, 77};
    std::vector<ShadowQuestion> scenes = drawMixedScenes(draw);
    for (const auto drawNext : {drawOtherBalls, drawVeryFarLights, drawManyLights})
        for (ShadowQuestion& scene : drawNext(draw))
            scenes.push_back(std::move(scene));
    return scenes;
}

template <typename Test>
void forEachScene(const Test& test) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
        for (const ShadowQuestion& scene : drawn(seed))
            test(scene);
}

template <typename Test>
void forEachPointAndLight(const Test& test) {
    forEachScene([&](const ShadowQuestion& drawn) {
        for (const probe::LitPoint& point : drawn.question.points)
            for (const PointLight& light : drawn.question.scene.pointLights)
                test(drawn, point, light);
    });
}

TEST(MixedScenes, HaveEachLightInFrontOfTheSurfaceOrBehindIt) {
    forEachPointAndLight(
        [](const ShadowQuestion& drawn, const probe::LitPoint& point, const PointLight& light) {
            const double height = (light.position() - point.position).dot(point.normal);
            EXPECT_GT(std::abs(height), 1.4 * drawn.question.settings.lightSize);
        });
}

// This holds for every place of a light, not only for its centre: some submissions give each ray a
// term of its own.
TEST(MixedScenes, ShowNoHighlightOfLightsBehindTheSurface) {
    Draw places{1, 78};
    forEachPointAndLight(
        [&](const ShadowQuestion& drawn, const probe::LitPoint& point, const PointLight& light) {
            if ((light.position() - point.position).dot(point.normal) > 0.0) return;
            for (int i = 0; i < 40; ++i) {
                const Vector3 place =
                    light.position() + places.direction() * drawn.question.settings.lightSize;
                const Vector3 R = (place - point.position).normalised().reflectIn(point.normal);
                EXPECT_LT(R.dot((point.viewer - point.position).normalised()), -0.04);
                EXPECT_LT(R.dot((-point.position).normalised()), -0.04);
            }
        });
}

// If a light were too near, the rays that are cast from it would count for another light.
TEST(MixedScenes, HaveNoPlaceOfALightNearAPoint) {
    forEachPointAndLight(
        [](const ShadowQuestion& drawn, const probe::LitPoint& point, const PointLight& light) {
            const Vector3 way = light.position() - point.position;
            const double size = drawn.question.settings.lightSize;
            EXPECT_GT(way.magnitude(), size + 0.52);
            const Vector3 nearest = light.position() - way.normalised() * size;
            const raytracer::Ray seen = raytracer::questions::seenFrom(
                point.position, point.normal, {nearest, -way.normalised()});
            EXPECT_GT(seen.direction.dot(way), 0.0);
        });
}

TEST(MixedScenes, HaveNoObjectNearALightOrAPoint) {
    forEachScene([](const ShadowQuestion& drawn) {
        const auto& scene = drawn.question.scene;
        for (const PointLight& light : scene.pointLights) {
            EXPECT_GT(Surfaces{scene}.distanceToNearest(light.position()),
                      1.35 * drawn.question.settings.lightSize);
        }
        for (const probe::LitPoint& point : drawn.question.points) {
            raytracer::SceneDescription others = scene;
            const auto index = static_cast<std::size_t>(point.object);
            if (index < scene.spheres.size())
                others.spheres.erase(others.spheres.begin() + point.object);
            else
                others.planes.erase(others.planes.begin() +
                                    (point.object - static_cast<int>(scene.spheres.size())));
            EXPECT_GT(Surfaces{others}.distanceToNearest(point.position), 0.09);
            EXPECT_LT(Surfaces{scene}.distanceToNearest(point.position), 1e-9);
        }
    });
}

TEST(MixedScenes, HaveRaysThatBelongToOneLight) {
    forEachScene([](const ShadowQuestion& drawn) {
        const auto& lights = drawn.question.scene.pointLights;
        const double size = drawn.question.settings.lightSize;
        for (const probe::LitPoint& point : drawn.question.points)
            for (std::size_t i = 0; i < lights.size(); ++i)
                for (std::size_t k = 0; k < i; ++k) {
                    const Vector3 one = lights[i].position() - point.position;
                    const Vector3 other = lights[k].position() - point.position;
                    const double angle = std::acos(one.normalised().dot(other.normalised()));
                    EXPECT_GT(angle, size / one.magnitude() + size / other.magnitude() + 0.1);
                }
    });
}

/// The points of one seed's scenes, without answers.
struct Points {
    explicit Points(std::uint64_t seed) : questions(drawn(seed)) {
        Draw draw{seed, 79};
        for (ShadowQuestion& small : drawSmallLights(draw))
            questions.push_back(std::move(small));
        for (const ShadowQuestion& question : questions)
            logs.push_back(readShadowLog(question, {}));
        for (const ShadowLog& log : logs)
            for (const PointLog& point : log.points)
                all.push_back({&log, &point});
    }
    std::vector<ShadowQuestion> questions;
    std::vector<ShadowLog> logs;
    std::vector<PointOfLog> all;
};

TEST(MixedScenes, HavePointsWithEachTraitAndWithout) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Points points{seed};
        ASSERT_GE(points.all.size(), 100U);
        for (const PointTrait& trait : pointTraits()) {
            const auto has = std::ranges::count_if(points.all, trait.holds);
            EXPECT_GE(has, 1) << trait.words << ", seed " << seed;
            EXPECT_LT(has, std::ssize(points.all)) << trait.words << ", seed " << seed;
        }
    }
}

// Another trait may hold at exactly the same points of a seed, and is then told instead. So only
// nine of ten traits must be told themselves.
TEST(MixedScenes, TellTheTraitThatAllWrongPointsShare) {
    int named = 0;
    int asked = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Points points{seed};
        for (const PointTrait& trait : pointTraits()) {
            std::vector<bool> isWrong;
            for (const PointOfLog& at : points.all)
                isWrong.push_back(trait.holds(at));
            if (std::ranges::count(isWrong, true) < 4) continue;
            const PointTrait* told = commonTrait(pointTraits(), points.all, isWrong);
            ++asked;
            ASSERT_NE(told, nullptr) << trait.words;
            for (std::size_t i = 0; i < isWrong.size(); ++i)
                EXPECT_EQ(told->holds(points.all[i]), isWrong[i]) << trait.words;
            if (told == &trait) ++named;
        }
    }
    EXPECT_GT(named, asked * 9 / 10);
}

TEST(MixedScenes, TellNothingWhereWrongPointsShareNothing) {
    const Points points{5};
    std::vector<bool> isWrong;
    for (std::size_t i = 0; i < points.all.size(); ++i)
        isWrong.push_back(i % 2 == 0);
    EXPECT_EQ(commonTrait(pointTraits(), points.all, isWrong), nullptr);
}

}  // namespace
}  // namespace ticker::tasks

#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/tasks/Tasks.h>
#include <grader/tasks/maintick/LitSetups.h>
#include <grader/tasks/maintick/mirrors/MirrorQuestions.h>
#include <grader/tasks/support/Surfaces.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/SlowRun.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ticker::tasks {
namespace {

using namespace maintick;

constexpr double kFarApart = 1e-2;

TEST(MainTickAnswer, MeetsASphereAheadFromOutsideAndFromInside) {
    const raytracer::SphereDescription sphere{{1.0, 0.0, 5.0}, 2.0, {}, nullptr};
    const auto outside = meet(sphere, {{1.0, 1.2, 0.0}, {0.0, 0.0, 1.0}});
    ASSERT_TRUE(outside);
    EXPECT_NEAR(outside->distance, 3.4, 1e-12);
    EXPECT_NEAR(outside->normal.y, 0.6, 1e-12);
    EXPECT_NEAR(meet(sphere, {{1.0, 0.0, 4.0}, {0.0, 0.0, 1.0}})->distance, 3.0, 1e-12);
    EXPECT_FALSE(meet(sphere, {{1.0, 0.0, 8.0}, {0.0, 0.0, 1.0}}));
    EXPECT_FALSE(meet(sphere, {{1.0, 2.5, 0.0}, {0.0, 0.0, 1.0}}));
}

TEST(MainTickAnswer, TracesTheChainOfTheHandout) {
    raytracer::SceneDescription scene;
    scene.spheres.push_back({{0.0, 0.0, 5.0}, 1.0, {{0.2, 0.0, 0.0}}, nullptr});
    scene.spheres[0].material.reflectivity = 0.3;
    scene.planes.push_back({{0.0, 0.0, -3.0}, {0.0, 0.0, 1.0}, {{0.0, 1.0, 0.0}}});
    scene.planes[0].material.reflectivity = 0.1;
    const std::vector<ColourRGB> direct{{0.2, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    const TraceModel trace{scene, direct};
    const Ray ray{{}, {0.0, 0.0, 1.0}};
    EXPECT_TRUE(isNear(trace.along(ray, 1), ColourRGB{0.14, 0.3, 0.0}));
    EXPECT_TRUE(isNear(trace.along(ray, 2), ColourRGB{0.146, 0.27, 0.0}));
    EXPECT_TRUE(isNear(trace.along(ray, 3), ColourRGB{0.1442, 0.279, 0.0}));
}

TEST(MainTickQuestions, SetEveryKnownMistakeOfPhongFarApart) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto asked = drawLitQuestions(seed);
        for (const PhongMistake& mistake : phongMistakes()) {
            const bool shows = std::any_of(asked.begin(), asked.end(), [&](const LitQuestion& one) {
                return !isNear(phong(one.setup, &mistake), phong(one.setup), kFarApart);
            });
            EXPECT_TRUE(shows) << mistake.finding->id << ": " << mistake.hint << " seed " << seed;
        }
    }
}

TEST(MainTickQuestions, LightTheFrontOfASurfaceThatIsSeenFromBehind) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        int count = 0;
        for (const LitQuestion& one : drawLitQuestions(seed)) {
            const auto& [scene, P, N, O] = one.setup;
            if (one.kind != LitKind::behind) continue;
            const Vector3 L = (scene.pointLights.at(0).position() - P).normalised();
            const Vector3 V = (O - P).normalised();
            if (L.dot(N) > 0.2 && V.dot(N) < -0.2 && L.reflectIn(N).dot(V) < -0.2) ++count;
        }
        EXPECT_EQ(count, 2) << seed;
    }
}

// Accepted readings differ in what a light behind the surface adds to a highlight.
TEST(MainTickQuestions, HaveLightsBehindTheSurfaceBeforeOnesInFront) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        int count = 0;
        for (const LitQuestion& one : drawLitQuestions(seed)) {
            if (one.kind != LitKind::several) continue;
            const auto& [scene, P, N, O] = one.setup;
            const Vector3 V = (O - P).normalised();
            bool isBehind = false;
            for (const raytracer::PointLight& light : scene.pointLights) {
                const Vector3 L = (light.position() - P).normalised();
                EXPECT_GT(std::abs(N.dot(L)), 0.2) << seed;
                if (N.dot(L) < 0.0) {
                    EXPECT_LT(L.reflectIn(N).dot(V), -0.1) << seed;
                    isBehind = true;
                } else if (isBehind) {
                    ++count;
                    EXPECT_GT(L.reflectIn(N).dot(V), 0.1) << seed;
                }
            }
        }
        EXPECT_EQ(count, 4) << seed;
    }
}

// Code that limits alpha, the coefficients or the number of lights shows only beyond its limit.
TEST(MainTickQuestions, AskOfShinySurfacesStrongCoefficientsAndManyLights) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto asked = drawLitQuestions(seed);
        const auto differs = [&](auto&& change) {
            return std::any_of(asked.begin(), asked.end(), [&](const LitQuestion& one) {
                LitSetup changed = one.setup;
                change(changed, changed.scene.spheres.at(0).material);
                return !isNear(phong(changed), phong(one.setup), 3.0 * kTolerance);
            });
        };
        using raytracer::Material;
        for (const double limit : {100.0, 128.0, 200.0, 255.0})
            EXPECT_TRUE(differs([&](LitSetup&, Material& material) {
                material.phongAlpha = std::min(material.phongAlpha, limit);
            })) << limit;
        for (const auto coefficient : {&Material::phongKD, &Material::phongKS})
            EXPECT_TRUE(differs([&](LitSetup&, Material& material) {
                material.*coefficient = std::min(material.*coefficient, 2.0);
            })) << seed;
        EXPECT_TRUE(differs([](LitSetup& setup, Material&) {
            auto& lights = setup.scene.pointLights;
            if (lights.size() > 16) lights.erase(lights.begin() + 16, lights.end());
        })) << seed;
    }
}

// The largest error of R.V in float, and a power that a loop multiplies out in float.
TEST(MainTickQuestions, LetHighlightsOfShinySurfacesBeWorkedOutInFloat) {
    constexpr double kErrorOfFloats = 4e-7;
    int shiny = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed)
        for (const LitQuestion& one : drawLitQuestions(seed)) {
            if (one.kind != LitKind::shiny) continue;
            ++shiny;
            const auto& [scene, P, N, O] = one.setup;
            const Vector3 L = (scene.pointLights.at(0).position() - P).normalised();
            const double mirrored = L.reflectIn(N).dot((O - P).normalised());
            const double alpha = scene.spheres.at(0).material.phongAlpha;
            for (const double error : {-kErrorOfFloats, kErrorOfFloats}) {
                float power = 1.0F;
                for (int i = 0; i < static_cast<int>(alpha); ++i)
                    power *= static_cast<float>(mirrored + error);
                EXPECT_NEAR(power / std::pow(mirrored, alpha), 1.0, kTolerance / 2.0) << seed;
            }
        }
    EXPECT_EQ(shiny, 200);
}

TEST(MainTickQuestions, SetEveryKnownMistakeOfMirrorsFarApart) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const MirrorQuestion asked = drawOpenScene(seed);
        std::vector<ColourRGB> direct;
        for (const probe::LitPoint& point : asked.direct.points)
            direct.push_back(asked.question.scene.ambientLighting *
                             materialOf(asked.question.scene, point.object).colour);
        EXPECT_GE(asked.question.rays.size(), 40U) << seed;
        const auto traced = [&](const TraceWay& way, const probe::CastRay& ray) {
            return TraceModel{asked.question.scene, direct, way}.along({ray.origin, ray.direction},
                                                                       ray.bounces);
        };
        std::vector<TraceMistake> mistakes{traceMistakes().begin(), traceMistakes().end()};
        mistakes.push_back(noMirrors());
        for (const TraceMistake& mistake : mistakes) {
            const auto& rays = asked.question.rays;
            const bool shows = std::any_of(rays.begin(), rays.end(), [&](const auto& ray) {
                return !isNear(traced(mistake.way, ray), traced({}, ray), kFarApart);
            });
            EXPECT_TRUE(shows) << mistake.finding->id << ": " << mistake.hint << " seed " << seed;
        }
    }
}

// Right code draws nothing at random: if it fails under one seed, a question is too near the edge
// of what is right.
TEST(MainTickQuestions, NeverFailTheReference) {
    const Exercise& exercise = exerciseNamed("tick1");
    const build::Kit kit = build::Kit::besideProgram(exercise);
    const sandbox::Sandbox sandbox = sandbox::Sandbox::best();
    const sandbox::Limits limits;
    const std::uint64_t end = tests::isSlowRun() ? 40 : 5;
    for (const std::string& file : exercise.files()) {
        const build::BuildResult built = build::buildProgram(
            kit, sandbox, limits, file, tests::readFile(exercise.reference + "/" + file));
        ASSERT_TRUE(built.program) << built.diagnostics;
        build::SandboxedExaminee examinee{*built.program, sandbox, limits};
        for (const Task& task : tasksOf(exercise.name)) {
            if (exercise.fileOf(task.id) != file) continue;
            for (std::uint64_t seed = 0; seed < end; ++seed) {
                const TaskJudgement judgement = task.judge(examinee, seed);
                EXPECT_EQ(judgement.state, TaskState::passed)
                    << task.id << ", seed " << seed << ": "
                    << (judgement.findings.empty() ? judgement.reason
                                                   : judgement.findings.front().message);
                EXPECT_TRUE(judgement.findings.empty()) << task.id << ", seed " << seed;
            }
        }
    }
}

}  // namespace
}  // namespace ticker::tasks

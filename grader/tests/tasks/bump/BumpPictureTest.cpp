// A picture compared with the normals that the same code returns. The shading is worked out by
// hand.
#include <grader/tasks/bump/BumpPicture.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <raytracer/geometry/HeightMap.h>
#include <raytracer/image/ToneCurve.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace ticker::tasks {
namespace {

using raytracer::ColourRGB;
using raytracer::Vector3;

/// A smooth ball, then a bumpy one of radius 1, lit from above; without highlights.
raytracer::SceneDescription ballAt(const Vector3& centre) {
    raytracer::SceneDescription scene;
    scene.ambientLighting = ColourRGB{0.1};
    scene.pointLights.emplace_back(Vector3{0.0, 8.0, 0.0}, ColourRGB{1.0}, 900.0);
    raytracer::Material material;
    material.colour = {0.8, 0.4, 0.2};
    material.phongKS = 0.0;
    material.reflectivity = 0.25;
    scene.spheres.push_back({{9.0, 9.0, 9.0}, 1.0, {}, nullptr});
    scene.spheres.push_back(
        {centre, 1.0, material,
         std::make_shared<const raytracer::HeightMap>(4, 4, std::vector<double>(16, 1.0))});
    return scene;
}

raytracer::RenderSettings smallFrame() {
    raytracer::RenderSettings settings;
    settings.width = 36;
    settings.height = 27;
    return settings;
}

const Vector3 kCentre{0.3, -0.2, 5.0};

BumpPicture planned() {
    return planBumpPicture(ballAt(kCentre), smallFrame());
}

ColourRGB shadedByHand(const BumpPicture& plan, const Vector3& position, const Vector3& normal) {
    const auto& material = plan.scene.spheres[1].material;
    const auto& light = plan.scene.pointLights[0];
    const Vector3 way = light.position() - position;
    ColourRGB colour = material.colour * plan.scene.ambientLighting;
    if ((position - kCentre).dot(way) > 0.0)
        colour += material.colour * light.illuminationAt(way.magnitude()) *
                  (material.phongKD * std::max(0.0, normal.dot(way.normalised())));
    return colour * 0.75;
}

using NormalAt = std::function<Vector3(const Vector3& smooth)>;

Vector3 smoothNormal(const Vector3& smooth) {
    return smooth;
}
Vector3 leaning(const Vector3& smooth) {
    return (smooth + Vector3{0.4, -0.3, 0.2}).normalised();
}

/// How badly a picture that shows the normals `drawn` fits the normals `answered`.
double misfitOf(const NormalAt& drawn, const NormalAt& answered) {
    const BumpPicture plan = planned();
    probe::NormalAnswer answer;
    std::vector<std::uint8_t> rgb(3 * 36 * 27, 0);
    for (std::size_t i = 0; i < plan.pixels.size(); ++i) {
        const Vector3& position = plan.question.positions[i];
        const Vector3 smooth = (position - kCentre).normalised();
        answer.normals.push_back(answered(smooth));
        const auto bytes = raytracer::toneMapped(shadedByHand(plan, position, drawn(smooth)));
        std::copy(bytes.begin(), bytes.end(),
                  rgb.begin() + static_cast<std::ptrdiff_t>(3 * plan.pixels[i]));
    }
    return bumpMisfit(plan, answer, rgb);
}

TEST(PlanBumpPicture, AsksWhereThePixelsOfTheBumpyBallMeetIt) {
    const BumpPicture plan = planned();
    EXPECT_EQ(plan.sphere, 1U);
    EXPECT_EQ(plan.question.company.spheres.size(), 1U);
    EXPECT_EQ(plan.question.company.spheres[0].centre.x, 9.0);
    ASSERT_GT(plan.pixels.size(), 15U);
    ASSERT_EQ(plan.pixels.size(), plan.question.positions.size());
    const double pitch = 2.0 * std::tan(std::acos(-1.0) / 8.0) / 36.0;
    for (std::size_t i = 0; i < plan.pixels.size(); ++i) {
        const Vector3& at = plan.question.positions[i];
        EXPECT_NEAR((at - kCentre).magnitude(), 1.0, 1e-9);
        EXPECT_LT((at - kCentre).dot(at), 0.0) << "the near side";
        const std::size_t row = plan.pixels[i] / 36;
        const auto x = static_cast<double>(plan.pixels[i] % 36);
        const auto y = static_cast<double>(row);
        EXPECT_NEAR(at.x / at.z, (x + 0.5 - 18.0) * pitch, 1e-9);
        EXPECT_NEAR(at.y / at.z, (13.5 - y - 0.5) * pitch, 1e-9);
    }
}

TEST(PlanBumpPicture, AsksNothingOfABallBehindTheCameraOrRoundIt) {
    EXPECT_TRUE(planBumpPicture(ballAt({0.0, 0.0, -5.0}), smallFrame()).pixels.empty());
    EXPECT_TRUE(planBumpPicture(ballAt({0.0, 0.0, 0.5}), smallFrame()).pixels.empty());
    EXPECT_TRUE(planBumpPicture({}, smallFrame()).pixels.empty());
}

TEST(BumpMisfit, IsSmallWhereThePictureShowsTheAnswersAndLargeWhereItIsSmooth) {
    EXPECT_LT(misfitOf(leaning, leaning), 1e-9);
    EXPECT_GT(misfitOf(smoothNormal, leaning), 1e6);
    EXPECT_EQ(misfitOf(smoothNormal, smoothNormal), 1.0) << "nothing to tell them apart";
    EXPECT_EQ(misfitOf(leaning, smoothNormal), 1.0);
}

TEST(BumpMisfit, LeavesOutNormalsThatAreNoNumbers) {
    const NormalAt upperHalf = [](const Vector3& smooth) {
        return smooth.y > 0.0 ? Vector3{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}
                              : leaning(smooth);
    };
    EXPECT_LT(misfitOf(leaning, upperHalf), 1e-9);
}

// Code must not be able to tell the sphere of a question from that of a picture. In 200 draws each
// kind is missing with a chance below 1e-20.
TEST(BumpQuestions, StandInScenesWithLightsAndSometimesOtherObjects) {
    bump::Questionnaire asked{8};
    int withSpheres = 0;
    int withPlanes = 0;
    int alone = 0;
    for (int i = 0; i < 200; ++i) {
        const std::size_t number = asked.add({{0.0, 0.0, 5.0}, 1.0}, bump::flatMap(4, 4, 0.5), {});
        const raytracer::SceneDescription& scene = asked.question(number).company;
        EXPECT_TRUE(!scene.pointLights.empty() && scene.pointLights.size() <= 3);
        withSpheres += scene.spheres.empty() ? 0 : 1;
        withPlanes += scene.planes.empty() ? 0 : 1;
        alone += scene.spheres.empty() && scene.planes.empty() ? 1 : 0;
    }
    EXPECT_GT(withSpheres, 0);
    EXPECT_GT(withPlanes, 0);
    EXPECT_GT(alone, 0);
}

TEST(DoubtBumps, SendsAPassedTaskToAPersonWhereThePictureIsSmoothOrMissing) {
    const auto doubted = [](TaskState state, const std::optional<double>& misfit) {
        TaskReport task;
        task.state = state;
        doubtBumps(task, misfit);
        EXPECT_EQ(task.findings.size(), task.needsReview ? 1U : 0U);
        return task.needsReview;
    };
    EXPECT_TRUE(doubted(TaskState::passed, std::nullopt));
    EXPECT_TRUE(doubted(TaskState::passed, 1.0));
    EXPECT_FALSE(doubted(TaskState::passed, 0.99));
    EXPECT_FALSE(doubted(TaskState::failed, std::nullopt));
    EXPECT_FALSE(doubted(TaskState::failed, 3.0));
}

}  // namespace
}  // namespace ticker::tasks

#include <grader/tasks/shadows/answers/AimViewer.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tests/support/SlowRun.h>
#include <grader/tests/tasks/shadows/answers/AimsByHand.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace ticker::tasks {
namespace {

/// An aim for a ray from a point, in radii of the light.
using SeenAim = std::function<Vector3(Draw&, const probe::LitPoint&, const Vector3& light)>;

AimLine lineTo(const Vector3& start, const Vector3& light, const Vector3& offset) {
    AimLine line;
    line.origin = start;
    line.direction = (light + offset - start).normalised();
    const Vector3 between = light - start;
    line.foot = line.direction * between.dot(line.direction) - between;
    line.miss = line.foot.magnitude();
    return line;
}

/// Ten rays from each point of the far-light questions of a seed.
class FarAims {
public:
    FarAims(std::uint64_t seed, const SeenAim& aim) : questions_(drawShadowQuestions(seed)) {
        Draw draw{seed, 77};
        std::erase_if(questions_, [](const ShadowQuestion& question) {
            return question.purpose != ShadowQuestion::Purpose::farLight;
        });
        logs_.resize(questions_.size());
        for (std::size_t i = 0; i < logs_.size(); ++i) {
            logs_[i].asked = &questions_[i];
            for (const probe::LitPoint& asked : questions_[i].question.points)
                logs_[i].points.push_back(cast(draw, asked, logs_[i], aim));
        }
        for (const ShadowLog& log : logs_) {
            far.push_back(&log);
            const raytracer::SceneDescription& scene = log.scene();
            directions.push_back(
                (scene.pointLights[0].position() - scene.planes[0].point).normalised());
        }
    }
    ~FarAims() = default;
    FarAims(const FarAims&) = delete;
    FarAims& operator=(const FarAims&) = delete;

    std::vector<const ShadowLog*> far;
    std::vector<Vector3> directions;

private:
    static PointLog cast(Draw& draw, const probe::LitPoint& asked, const ShadowLog& log,
                         const SeenAim& aim) {
        const Vector3 light = log.scene().pointLights[0].position();
        PointLog point;
        point.point = asked;
        point.lines.resize(1);
        for (int ray = 0; ray < log.settings().shadowRayCount; ++ray)
            point.lines[0].push_back(lineTo(asked.position + asked.normal * 1e-4, light,
                                            aim(draw, asked, light) * log.settings().lightSize));
        return point;
    }

    std::vector<ShadowQuestion> questions_;
    std::vector<ShadowLog> logs_;
};

Vector3 onDisc(Draw& draw, const Vector3& axis) {
    return facingDisc([](double u) { return std::sqrt(u); })(draw, axis.normalised());
}

Vector3 towardsViewer(Draw& draw, const probe::LitPoint& point, const Vector3&) {
    return onDisc(draw, point.viewer - point.position);
}

// Over 3000 seeds the spread is at least 11.9 standard deviations for one of these discs, and 9.1
// for the other; the limit is 6.6.
TEST(TurnsWithViewer, FindsDiscsThatFaceTheViewer) {
    const std::vector<SeenAim> wrong{
        towardsViewer, [](Draw& draw, const probe::LitPoint& point, const Vector3& light) {
            return onDisc(draw, point.viewer - light);
        }};
    for (const SeenAim& aim : wrong) {
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const FarAims made{seed, aim};
            EXPECT_LT(spreadTowardsViewer(made.far, made.directions), -6.6) << seed;
        }
        const AimVerdict verdict = judgeAims(FarAims{1, aim}.far);
        EXPECT_TRUE(verdict.turnsWithViewer);
        EXPECT_FALSE(verdict.shapeIsRight());
    }
}

/// Aims that do not depend on the viewer; some of them are mistakes.
std::vector<SeenAim> seenAlike() {
    const auto pattern = [](int ray) {
        const double angle = 2.4 * ray;
        return Vector3{std::cos(angle), std::sin(angle), 0.1 * ray - 0.45} * std::sqrt(0.08 * ray);
    };
    return {
        [](Draw& draw, const probe::LitPoint&, const Vector3&) { return ball(draw); },
        [](Draw& draw, const probe::LitPoint&, const Vector3&) { return draw.direction(); },
        [](Draw& draw, const probe::LitPoint&, const Vector3&) { return polarHelper(draw); },
        [](Draw& draw, const probe::LitPoint& point, const Vector3& light) {
            return onDisc(draw, light - point.position);
        },
        [](Draw& draw, const probe::LitPoint&, const Vector3&) {
            return onDisc(draw, {0.6, 0.8, 0.0});
        },
        [](Draw& draw, const probe::LitPoint& point, const Vector3&) {
            return onDisc(draw, point.normal);
        },
        [ray = 0, pattern](Draw&, const probe::LitPoint&, const Vector3&) mutable {
            return pattern(ray++ % 10);
        },
        [ray = 0, pattern](Draw& draw, const probe::LitPoint&, const Vector3&) mutable {
            return pattern(ray++ % 2 == 0 ? draw.whole(0, 9) : 3);
        },
        [ray = 0, last = Vector3{}](Draw& draw, const probe::LitPoint&, const Vector3&) mutable {
            return last = ray++ % 2 == 0 ? ball(draw) : -last;
        }};
}

// Each is named with a chance below 1e-9.
TEST(TurnsWithViewer, SaysNothingOfWhatDoesNotDependOnTheViewer) {
    const std::vector<SeenAim> alike = seenAlike();
    for (std::size_t i = 0; i < alike.size(); ++i)
        for (std::uint64_t seed = 1; seed <= (tests::isSlowRun() ? 40U : 10U); ++seed) {
            const FarAims made{seed, alike[i]};
            EXPECT_FALSE(turnsWithViewer(made.far, made.directions)) << i << ' ' << seed;
        }
}

TEST(TurnsWithViewer, NeedsViewersInSeveralDirections) {
    ShadowQuestion question;
    question.question.scene.pointLights.emplace_back(Vector3{0.0, 120.0, 0.0},
                                                     raytracer::ColourRGB{1.0}, 1.0);
    ShadowLog log;
    log.asked = &question;
    Draw draw{5, 3};
    for (int i = 0; i < 200; ++i) {
        log.points.emplace_back().point.viewer = {1.0, 2.0, 0.0};
        log.points.back().lines.resize(1);
        for (int ray = 0; ray < 10; ++ray)
            log.points.back().lines[0].push_back(
                lineTo({}, {0.0, 120.0, 0.0}, onDisc(draw, {1.0, 2.0, 0.0}) * 0.4));
    }
    EXPECT_EQ(spreadTowardsViewer({&log}, {{0.0, 1.0, 0.0}}), 0.0);
    for (PointLog& point : log.points)
        point.point.viewer = point.point.position;
    EXPECT_EQ(spreadTowardsViewer({&log}, {{0.0, 1.0, 0.0}}), 0.0);
    EXPECT_EQ(spreadTowardsViewer({}, {}), 0.0);
}

TEST(CheckAims, TellsADiscThatFacesTheViewerWhatItShouldFace) {
    const FarAims made{3, towardsViewer};
    ShadowLogs logs{{}};
    logs.farLight = made.far;
    const auto finding = checkAims(logs, judgeAims(made.far));
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->id, "shadow.not-a-ball");
    EXPECT_NE(finding->hint.find("face the point P"), std::string::npos) << finding->hint;
}

}  // namespace
}  // namespace ticker::tasks

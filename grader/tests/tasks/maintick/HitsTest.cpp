#include <grader/tasks/maintick/Hits.h>
#include <grader/tasks/maintick/JudgeMainTick.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

using maintick::meet;
using raytracer::Vector3;
using Asked = probe::HitQuestion;
/// Changes the right answer to a ray.
using Change = std::function<void(probe::Hit&, const Asked&, const probe::CastRay&)>;

bool isLong(const probe::CastRay& ray) {
    return ray.direction.magnitude() > 2.0;
}

class AltersHits final : public probe::Examinee {
public:
    explicit AltersHits(Change change) : change_(std::move(change)) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        const auto& asked = std::get<Asked>(questions.at(0));
        probe::HitAnswer answer;
        answer.state = probe::AnswerState::answered;
        for (const probe::CastRay& ray : asked.rays) {
            const auto object = static_cast<std::size_t>(ray.object);
            const raytracer::Ray line{ray.origin, ray.direction};
            const auto meeting = asked.scene.spheres.empty()
                                     ? meet(asked.scene.planes[object], line)
                                     : meet(asked.scene.spheres[object], line);
            probe::Hit hit;
            if (meeting)
                hit = {true, meeting->distance, ray.object, meeting->location, meeting->normal};
            if (change_) change_(hit, asked, ray);
            answer.hits.push_back(hit);
        }
        return {{answer}, {}};
    }

private:
    Change change_;
};

constexpr std::uint64_t kHitSeed = 6;

std::vector<Finding> ofSpheres(const Change& change) {
    AltersHits examinee{change};
    return judgeSpheres(examinee, kHitSeed).findings;
}
std::vector<Finding> ofPlanes(const Change& change) {
    AltersHits examinee{change};
    return judgePlanes(examinee, kHitSeed).findings;
}

void expectOne(const std::vector<Finding>& findings, const std::string& id,
               const std::string& hint = {}) {
    ASSERT_EQ(findings.size(), 1U) << id;
    EXPECT_EQ(findings[0].id, id) << findings[0].message;
    EXPECT_NE(findings[0].hint.find(hint), std::string::npos) << findings[0].hint;
}

TEST(JudgeHits, SaysNothingOfRightHits) {
    EXPECT_TRUE(ofSpheres({}).empty());
    EXPECT_TRUE(ofPlanes({}).empty());
}

// Single precision is right there; see JudgePlanes.cpp and JudgeSpheres.cpp.
TEST(JudgeHits, AsksTwoThousandAwayButNoFarther) {
    const auto farthestOf = [](auto judge) {
        double farthest = 0.0;
        static_cast<void>(judge([&](probe::Hit&, const Asked&, const probe::CastRay& ray) {
            farthest = std::max(farthest, ray.origin.magnitude());
        }));
        return farthest;
    };
    for (const double farthest : {farthestOf(ofSpheres), farthestOf(ofPlanes)}) {
        EXPECT_GT(farthest, 1500.0);
        EXPECT_LT(farthest, 4100.0);
    }
}

// Mirrors and lights look there, too.
TEST(JudgeHits, AsksOnBothSidesOfTheCameraUnderEverySeed) {
    const Change dropped = [](probe::Hit& hit, const Asked&, const probe::CastRay&) {
        if (hit.location.z < 0.0) hit.isHit = false;
    };
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        AltersHits examinee{dropped};
        expectOne(judgeSpheres(examinee, seed).findings, "sphere.missed", "behind the camera");
        expectOne(judgePlanes(examinee, seed).findings, "plane.missed", "behind the camera");
    }
}

// The near root of a ray that starts inside is a little below 0.
TEST(JudgeHits, AsksInsideNearTheSurfaceUnderEverySeed) {
    const auto behindCounts = [](bool isHit) {
        return [=](probe::Hit& hit, const Asked& asked, const probe::CastRay& ray) {
            const auto& sphere = asked.scene.spheres[static_cast<std::size_t>(ray.object)];
            const raytracer::Ray backwards{ray.origin, -ray.direction};
            const auto back = meet(sphere, backwards);
            if (!hit.isHit || !back || back->distance > 0.05) return;
            hit.isHit = isHit;
            hit.distance = -back->distance;
        };
    };
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
        for (const bool isHit : {false, true}) {
            AltersHits examinee{behindCounts(isHit)};
            expectOne(judgeSpheres(examinee, seed).findings, "sphere.inside", "limit below 0");
        }
}

// The far root of a ray that starts just past a sphere is a little below 0.
TEST(JudgeHits, AsksJustPastTheFarSideUnderEverySeed) {
    const Change behindCounts = [](probe::Hit& hit, const Asked& asked, const probe::CastRay& ray) {
        const auto& sphere = asked.scene.spheres[static_cast<std::size_t>(ray.object)];
        const Vector3 fromCentre = ray.origin - sphere.centre;
        const auto back = meet(sphere, {ray.origin, -ray.direction});
        if (fromCentre.magnitude() < sphere.radius || !back || back->distance > 0.05) return;
        hit.isHit = true;
        hit.distance = -back->distance;
    };
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        AltersHits examinee{behindCounts};
        expectOne(judgeSpheres(examinee, seed).findings, "sphere.behind", "limit below 0");
    }
}

TEST(JudgeHits, NotesOtherLocationsOfLongDirectionsWithoutFailing) {
    const Change moved = [](probe::Hit& hit, const Asked&, const probe::CastRay& ray) {
        if (isLong(ray)) hit.location = hit.location + Vector3{0.1, 0.0, 0.0};
    };
    expectOne(ofSpheres(moved), "sphere.direction-length");
    expectOne(ofPlanes(moved), "plane.direction-length");
    EXPECT_EQ(ofSpheres(moved)[0].severity, Severity::note);
    expectOne(ofSpheres([](probe::Hit& hit, const Asked&, const probe::CastRay& ray) {
                  if (isLong(ray)) hit.isHit = false;
              }),
              "sphere.direction-length");
    // Distances in lengths of the direction or in world units, and fields that are not judged.
    EXPECT_TRUE(ofSpheres([](probe::Hit& hit, const Asked&, const probe::CastRay& ray) {
                    if (isLong(ray)) hit.distance *= 2.5;
                    if (isLong(ray)) hit.object = -1;
                }).empty());
}

TEST(JudgeHits, NotesNormalsThatAreTurnedToTheRay) {
    const Change turned = [](probe::Hit& hit, const Asked&, const probe::CastRay& ray) {
        if (hit.normal.dot(ray.direction) > 0.0) hit.normal = -hit.normal;
    };
    expectOne(ofSpheres(turned), "sphere.turned-normal");
    expectOne(ofPlanes(turned), "plane.turned-normal");
}

TEST(JudgeHits, SaysWhatIsWrongWithANormal) {
    expectOne(ofSpheres([](probe::Hit& hit, const Asked&, const probe::CastRay&) {
                  hit.normal = -hit.normal;
              }),
              "sphere.normal", "wrong way");
    expectOne(ofPlanes([](probe::Hit& hit, const Asked&, const probe::CastRay&) {
                  hit.normal = hit.normal * 1.5;
              }),
              "plane.normal", "length 1.5");
    expectOne(ofPlanes([](probe::Hit& hit, const Asked&, const probe::CastRay&) {
                  hit.normal = hit.normal + Vector3{0.1, 0.2, 0.3};
              }),
              "plane.normal", "same normal everywhere");
    expectOne(ofPlanes([](probe::Hit& hit, const Asked&, const probe::CastRay&) {
                  hit.normal = hit.normal * std::numeric_limits<double>::quiet_NaN();
              }),
              "plane.normal", "same normal everywhere");
}

TEST(JudgeHits, NamesFieldsThatAreWrongWhereDistancesAreRight) {
    expectOne(ofSpheres([](probe::Hit& hit, const Asked&, const probe::CastRay& ray) {
                  hit.location = ray.direction * hit.distance;
              }),
              "sphere.location", "origin of the ray is left out");
    expectOne(ofSpheres([](probe::Hit& hit, const Asked&, const probe::CastRay&) {
                  hit.location = hit.location * 1.1;
              }),
              "sphere.location");
    expectOne(ofSpheres([](probe::Hit& hit, const Asked&, const probe::CastRay&) {
                  if (hit.isHit) ++hit.object;
              }),
              "sphere.object");
}

TEST(JudgeHits, NamesWhatIsAskedWhereNoKnownMistakeFits) {
    const auto changedBy = [](double factor) {
        return [=](probe::Hit& hit, const Asked&, const probe::CastRay& ray) {
            if (!isLong(ray)) hit.distance *= factor;
        };
    };
    expectOne(ofPlanes(changedBy(1.001)), "plane.distance");
    EXPECT_TRUE(ofPlanes(changedBy(1.0002)).empty());
    expectOne(ofSpheres([](probe::Hit& hit, const Asked&, const probe::CastRay& ray) {
                  if (ray.object == 1) hit.isHit = false;
              }),
              "sphere.missed");
    expectOne(ofPlanes([](probe::Hit& hit, const Asked&, const probe::CastRay&) {
                  hit = {true, hit.isHit ? hit.distance : 1.0, hit.object, {}, {}};
              }),
              "plane.behind");
}

Change answering(const maintick::HitMistake& mistake) {
    return [&](probe::Hit& hit, const Asked& asked, const probe::CastRay& ray) {
        const auto distance =
            mistake.distance(asked.scene, ray.object, {ray.origin, ray.direction});
        hit.isHit = distance.has_value();
        hit.distance = distance.value_or(0.0);
    };
}

TEST(JudgeHits, NamesEveryKnownMistakeThatExplainsAllAnswers) {
    for (const maintick::HitMistake& mistake : maintick::sphereMistakes()) {
        SCOPED_TRACE(mistake.hint);
        expectOne(ofSpheres(answering(mistake)), std::string{mistake.finding->id});
    }
    for (const maintick::HitMistake& mistake : maintick::planeMistakes()) {
        SCOPED_TRACE(mistake.hint);
        expectOne(ofPlanes(answering(mistake)), std::string{mistake.finding->id});
    }
}

}  // namespace
}  // namespace ticker::tasks

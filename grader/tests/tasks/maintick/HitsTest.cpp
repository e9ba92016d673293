#include <grader/tests/tasks/maintick/AltersHits.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace ticker::tasks {
namespace {

TEST(JudgeHits, SaysNothingOfRightHits) {
    EXPECT_TRUE(ofSpheres({}).empty());
    EXPECT_TRUE(ofPlanes({}).empty());
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

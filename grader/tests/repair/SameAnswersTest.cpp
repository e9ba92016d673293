#include <grader/repair/SameAnswers.h>

#include <gtest/gtest.h>

#include <limits>

namespace ticker::repair {
namespace {

using probe::CallAnswer;
using probe::Hit;
using probe::HitAnswer;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Answer>
probe::Run runOf(const Answer& answer) {
    probe::Run run;
    run.answers = {answer};
    return run;
}

HitAnswer hits() {
    HitAnswer answer;
    answer.hits = {{true, 2.0, 1, {1.0, 2.0, 3.0}, {0.0, 1.0, 0.0}}, {false, kNaN, -1, {}, {}}};
    return answer;
}

CallAnswer values() {
    CallAnswer answer;
    answer.values = {{1.0, 2.0, 3.0}, {kNaN, 0.0, 0.0}};
    return answer;
}

template <class Change>
bool isSeenInHits(Change change) {
    HitAnswer other = hits();
    change(other);
    return !sameAnswers(runOf(hits()), runOf(other));
}

TEST(SameAnswers, HitsAreTheSameWhereEveryFieldIs) {
    EXPECT_TRUE(sameAnswers(runOf(hits()), runOf(hits())));
}

TEST(SameAnswers, EveryFieldOfAHitCounts) {
    EXPECT_TRUE(isSeenInHits([](HitAnswer& answer) { answer.hits[0].isHit = false; }));
    EXPECT_TRUE(isSeenInHits([](HitAnswer& answer) { answer.hits[0].distance = 2.5; }));
    EXPECT_TRUE(isSeenInHits([](HitAnswer& answer) { answer.hits[0].object = 0; }));
    EXPECT_TRUE(isSeenInHits([](HitAnswer& answer) { answer.hits[0].location.z = 0.0; }));
    EXPECT_TRUE(isSeenInHits([](HitAnswer& answer) { answer.hits[1].normal.x = -0.0; }));
    EXPECT_TRUE(isSeenInHits([](HitAnswer& answer) { answer.exceptions = 1; }));
    EXPECT_TRUE(isSeenInHits([](HitAnswer& answer) { answer.hits.pop_back(); }));
}

TEST(SameAnswers, ValuesOfCallsAreComparedBitByBit) {
    EXPECT_TRUE(sameAnswers(runOf(values()), runOf(values())));
    CallAnswer other = values();
    other.values[1].y = -0.0;
    EXPECT_FALSE(sameAnswers(runOf(values()), runOf(other)));
    other = values();
    other.exceptions = 2;
    EXPECT_FALSE(sameAnswers(runOf(values()), runOf(other)));
}

TEST(SameAnswers, AnswersToDifferentQuestionsDiffer) {
    EXPECT_FALSE(sameAnswers(runOf(values()), runOf(hits())));
}

TEST(SameAnswers, ARunThatEndedEarlyDiffersFromOneThatFinished) {
    probe::Run crashed = runOf(values());
    crashed.end.kind = probe::ProcessEnd::Kind::crashed;
    EXPECT_FALSE(sameAnswers(runOf(values()), crashed));
}

}  // namespace
}  // namespace ticker::repair

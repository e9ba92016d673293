// Shadows inside of a render: the rays of a thread between the beginning and the end of a point's
// lighting must explain the point's colour.
#include <grader/tasks/shadows/checks/LitRender.h>
#include <grader/tests/support/LocalExaminee.h>
#include <grader/tests/tasks/support/AlteredExaminee.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace ticker::tasks {
namespace {

using probe::Event;

probe::RenderAnswer render(const probe::RenderQuestion& asked, probe::Examinee& examinee) {
    return std::get<probe::RenderAnswer>(examinee.ask({asked}).answers.at(0));
}

/// The reference's picture with changed events.
template <class Change>
std::optional<std::string> differenceAfter(const Change& change) {
    tests::LocalExaminee reference;
    const probe::RenderQuestion asked = drawLitQuestion(3, 1);
    probe::RenderAnswer answer = render(asked, reference);
    change(answer);
    return litDifference(readLitRender(asked, answer));
}

// Exact: no seed may differ.
TEST(LitRender, IsAsTheQuestionsWhereRenderIsRight) {
    tests::LocalExaminee reference;
    for (std::uint64_t seed = 1; seed <= 12; ++seed)
        for (const int threads : {1, 2}) {
            const probe::RenderQuestion asked = drawLitQuestion(seed, threads);
            const LitRender lit = readLitRender(asked, render(asked, reference));
            EXPECT_EQ(lit.answer.colours.size(), 1200U)
                << seed << ": every lens ray meets the wall";
            EXPECT_FALSE(litDifference(lit)) << seed << ' ' << *litDifference(lit);
        }
}

// Whether a colour depends on its own rays shows only if some rays arrive and some do not.
TEST(LitRender, HasManyPointsAtTheEdgesOfShadows) {
    tests::LocalExaminee reference;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const probe::RenderQuestion asked = drawLitQuestion(seed, 1);
        const LitRender lit = readLitRender(asked, render(asked, reference));
        const ShadowLog log = readShadowLog(lit.asked, lit.answer);
        const auto edges = std::ranges::count_if(log.points, [](const PointLog& point) {
            return std::ranges::any_of(point.lines, [](const std::vector<AimLine>& lines) {
                const auto open = std::ranges::count(lines, Sight::open, &AimLine::toLight);
                return open > 0 && open < static_cast<long>(lines.size());
            });
        });
        EXPECT_GT(edges, 100) << seed;
    }
}

TEST(LitRender, SaysThatRaysAreMissing) {
    tests::LocalExaminee reference;
    AlteredExaminee hard{reference, [](auto& settings) { settings.shadowRayCount = 1; }};
    const probe::RenderQuestion asked = drawLitQuestion(3, 1);
    EXPECT_EQ(litDifference(readLitRender(asked, render(asked, hard))),
              "some points get 1 of 10 shadow rays to a light");
}

TEST(LitRender, SaysThatAnotherThreadsRaysWereCounted) {
    const auto said = differenceAfter([](probe::RenderAnswer& answer) {
        for (Event& event : answer.events)
            if (event.kind == Event::Kind::illuminateEnded) event.a = event.a * 1.1;
    });
    ASSERT_TRUE(said);
    // How many lie in full shadow depends on the order in which a compiler draws.
    EXPECT_TRUE(
        said->ends_with(" of 1200 points have another colour than their own shadow rays give"))
        << *said;
}

TEST(LitRender, SaysThatRaysStartAtAnotherThreadsPoint) {
    Vector3 last;
    const auto said = differenceAfter([&](probe::RenderAnswer& answer) {
        bool first = true;
        for (Event& event : answer.events) {
            if (event.kind == Event::Kind::illuminateBegan) first = true;
            if (event.kind != Event::Kind::rayCast || !std::exchange(first, false)) continue;
            std::swap(event.a, last);
        }
    });
    ASSERT_TRUE(said);
    EXPECT_NE(said->find("start at another point"), std::string::npos) << *said;
}

// The code's own recursion, which lights points without `illuminate`.
TEST(LitRender, CountsTheRaysOfARecursionOfOnesOwn) {
    const auto unobserved = [](int kept) {
        return [=](probe::RenderAnswer& answer) {
            int ray = 0;
            std::erase_if(answer.events, [&](const Event& event) {
                if (event.kind == Event::Kind::traceBegan) ray = 0;
                if (event.kind == Event::Kind::rayCast) return ray++ > kept;
                return event.kind == Event::Kind::illuminateBegan ||
                       event.kind == Event::Kind::illuminateEnded;
            });
        };
    };
    EXPECT_FALSE(differenceAfter(unobserved(20)));
    EXPECT_EQ(differenceAfter(unobserved(2)),
              "a point gets 1 of 10 shadow rays to a light, in the mean");
    EXPECT_FALSE(differenceAfter(unobserved(0))) << "its shadow rays cannot be seen";
}

TEST(LitRender, SaysNothingOfRaysThatTheLogHadNoRoomFor) {
    EXPECT_FALSE(differenceAfter([](probe::RenderAnswer& answer) {
        answer.events.resize(answer.events.size() / 2);
        answer.eventsCut = true;
    }));
}

}  // namespace
}  // namespace ticker::tasks

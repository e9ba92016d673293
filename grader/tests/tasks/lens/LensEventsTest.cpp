// Which rays go through the lens, and to which pixel each belongs.
#include <grader/tests/tasks/lens/LensByHand.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace ticker::tasks {
namespace {

using probe::Event;
using Kind = probe::Event::Kind;

/// A picture of 4 x 2 pixels, twice, of a ball of radius 1 at z = 5; events of the first thread.
struct Events {
    probe::RenderQuestion asked;
    probe::RenderAnswer answer;
    std::uint32_t ask = 0;
    std::uint16_t thread = 0;

    Events() {
        asked.settings.width = 4;
        asked.settings.height = 2;
        asked.repetitions = 2;
        asked.scene.spheres.push_back({{0.0, 0.0, 5.0}, 1.0, {}, nullptr});
    }
    Event& add(Kind kind) {
        Event event;
        event.kind = kind;
        event.ask = ask;
        event.thread = thread;
        answer.events.push_back(event);
        return answer.events.back();
    }
    void began(const Vector3& origin, const Vector3& direction = {0.0, 0.0, 2.0}, int bounces = 2) {
        Event& event = add(Kind::traceBegan);
        event.a = origin;
        event.b = direction;
        event.bounces = bounces;
    }
    void ended(double grey) { add(Kind::traceEnded).a = {grey, grey, grey}; }
    void cast(const Vector3& origin, const Vector3& direction = {0.0, 0.0, 2.0}) {
        Event& event = add(Kind::rayCast);
        event.a = origin;
        event.b = direction;
    }
    void at(Kind kind, int x, int y) {
        Event& event = add(kind);
        event.x = x;
        event.y = y;
    }
    /// Calls `one(x, y)` for every pixel of both repetitions, rows from the top.
    template <typename One>
    void everywhere(const One& one) {
        for (ask = 0; ask < 2; ++ask)
            for (int y = 0; y < 2; ++y)
                for (int x = 0; x < 4; ++x)
                    one(x, y);
    }
    [[nodiscard]] LensLog read() const { return readLensLog(asked, answer); }
};

/// A lens point that identifies a ray.
Vector3 mark(std::uint32_t ask, int x, int y) {
    return {0.001 * x + 0.01 * y + 0.1 * ask, 0.0, 0.0};
}

/// Expects that every pixel has `count` rays with its own mark.
void expectOwnRays(const LensLog& log, std::size_t count = 1) {
    ASSERT_EQ(log.pixels.size(), 16U);
    EXPECT_EQ(log.rayCount(), 16 * count);
    for (std::size_t i = 0; i < 16; ++i) {
        ASSERT_EQ(log.pixels[i].rays.size(), count) << i;
        const auto at = static_cast<int>(i);
        EXPECT_EQ(log.pixels[i].repetition, at / 8);
        EXPECT_NEAR(log.pixels[i].rays[0].origin.x,
                    mark(static_cast<std::uint32_t>(at / 8), at % 4, at / 4 % 2).x, 1e-12)
            << i;
    }
}

TEST(LensEvents, GivesWhatWasTracedBeforeAPixelWasSetToThatPixel) {
    Events events;
    events.everywhere([&](int x, int y) {
        events.began(mark(events.ask, x, y), {0.0, 0.0, 2.0}, 3);
        events.began({0.0, 0.0, 4.0}, {0.0, 0.0, -1.0}, 2);  // a reflection
        events.cast({0.0, 0.0, 0.5});
        events.ended(0.9);
        events.ended(0.25);
        events.began(mark(events.ask, x, y));
        events.ended(0.5);
        events.at(Kind::pixelSet, x, y);
    });
    const LensLog log = events.read();
    expectOwnRays(log, 2);
    EXPECT_EQ(log.pixels[5].rays[0].value->g, 0.25);
    EXPECT_EQ(log.pixels[5].rays[1].value->g, 0.5);
    EXPECT_EQ(log.pixels[5].rays[0].bounces, 3);
    EXPECT_EQ(log.pixels[5].rays[0].direction.z, 1.0);
}

TEST(LensEvents, FollowsTheCameraRayWherePixelsAreSetLater) {
    Events events;
    events.everywhere([&](int x, int y) {
        events.at(Kind::cameraRayAsked, x, y);
        events.began(mark(events.ask, x, y));
        events.ended(0.5);
    });
    events.everywhere([&](int x, int y) { events.at(Kind::pixelSet, x, y); });
    expectOwnRays(events.read());
}

TEST(LensEvents, TakesThePixelOfTheNearestFocalPointWhereNothingElseTells) {
    Events events;
    events.asked.settings.dofFocalPlane = 3.0;
    const double pitch = 2.0 * std::tan(std::numbers::pi / 8.0) / 4.0;
    events.everywhere([&](int x, int y) {
        const Vector3 focal = Vector3{(x - 1.5) * pitch, (0.5 - y) * pitch, 1.0} * 3.0;
        const Vector3 origin = mark(events.ask, x, y);
        events.began(origin + Vector3{0.0, 0.0, 0.2}, focal - origin - Vector3{0.0, 0.0, 0.2});
        events.ended(0.5);
    });
    expectOwnRays(events.read());
}

TEST(LensEvents, KeepsThreadsApart) {
    Events events;
    events.everywhere([&](int x, int y) {
        events.thread = 0;
        events.began(mark(events.ask, x, y));
        events.thread = 1;
        events.at(Kind::pixelSet, 3 - x, 1 - y);
        events.thread = 0;
        events.ended(0.5);
        events.at(Kind::pixelSet, x, y);
    });
    expectOwnRays(events.read());
}

// Code may split the rays of each pixel among threads, std::async for example.
TEST(LensEvents, GivesRaysOfAHelpingThreadToThePixelOfTheirFocalPoint) {
    for (const bool setsAtOnce : {true, false}) {
        Events events;
        events.asked.settings.dofFocalPlane = 3.0;
        const double pitch = 2.0 * std::tan(std::numbers::pi / 8.0) / 4.0;
        std::uint16_t newest = 0;
        events.everywhere([&](int x, int y) {
            const Vector3 focal = Vector3{(x - 1.5) * pitch, (0.5 - y) * pitch, 1.0} * 3.0;
            const Vector3 origin = mark(events.ask, x, y);
            events.at(Kind::cameraRayAsked, x, y);
            for (const std::uint16_t thread : {std::uint16_t{0}, ++newest}) {
                events.thread = thread;
                events.began(origin, focal - origin);
                events.ended(0.5);
            }
            events.thread = 0;
            if (setsAtOnce) events.at(Kind::pixelSet, x, y);
        });
        if (!setsAtOnce) events.everywhere([&](int x, int y) { events.at(Kind::pixelSet, x, y); });
        expectOwnRays(events.read(), 2);
    }
}

TEST(LensEvents, TakesRaysThatWereCastWhereNoneWasTraced) {
    Events events;
    events.everywhere([&](int x, int y) {
        events.cast(mark(events.ask, x, y));
        events.cast({0.0, 0.0, 4.0 - 0.009});  // from the ball: not a lens ray
        events.at(Kind::pixelSet, x, y);
    });
    expectOwnRays(events.read());
    EXPECT_FALSE(events.read().pixels[0].rays[0].value);
    EXPECT_EQ(events.read().pixels[0].rays[0].bounces, -1);
    Events beside;
    beside.everywhere([&](int x, int y) {
        beside.cast({0.0, 0.0, 4.0 - 0.011});
        beside.at(Kind::pixelSet, x, y);
    });
    EXPECT_EQ(beside.read().rayCount(), 16U) << "off the ball";
}

TEST(LensEvents, LeavesOutWhatIsNoRay) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Events events;
    events.everywhere([&](int x, int y) {
        for (const Vector3& odd :
             {Vector3{nan, 0.0, 0.0}, Vector3{0.0, nan, 0.0}, Vector3{0.0, 0.0, nan}}) {
            events.began(odd);
            events.ended(0.9);
            events.began({}, odd + Vector3{0.0, 0.0, 1.0});
            events.ended(0.9);
            events.cast(odd);
        }
        events.began({}, {});
        events.ended(0.9);
        events.ended(0.9);
        events.began(mark(events.ask, x, y));
        events.ended(0.5);
        events.at(Kind::pixelSet, x, y);
    });
    events.ask = 2;
    events.began({});
    events.ended(0.9);
    const LensLog log = events.read();
    expectOwnRays(log);
    EXPECT_EQ(log.pixels[7].rays[0].value->r, 0.5);
}

TEST(LensEvents, TakesNoPixelOutsideOfThePicture) {
    const std::pair<int, int> outside[] = {{-1, 1}, {4, 0}, {0, -1}, {0, 2}};
    for (const Kind kind : {Kind::pixelSet, Kind::cameraRayAsked}) {
        Events events;
        events.everywhere([&](int x, int y) {
            events.began(mark(events.ask, x, y));
            events.ended(0.5);
            for (const auto& [left, top] : outside)
                events.at(kind, left, top);
            events.at(Kind::pixelSet, x, y);
        });
        expectOwnRays(events.read());
    }
}

TEST(LensEvents, HasTheColourAndThePinholeOfEachPixel) {
    Events events;
    events.answer.eventsCut = true;
    events.answer.images = {std::vector<ColourRGB>(8), std::vector<ColourRGB>(7)};
    events.answer.images[0][6] = {0.1, 0.2, 0.3};
    events.answer.images[1][6] = {0.4, 0.5, 0.6};
    const LensLog log = events.read();
    EXPECT_TRUE(log.cut);
    EXPECT_EQ(log.rayCount(), 0U);
    EXPECT_EQ(log.pixels[6].colour, (ColourRGB{0.1, 0.2, 0.3}));
    EXPECT_EQ(log.pixels[14].colour, (ColourRGB{0.4, 0.5, 0.6}));
    EXPECT_EQ(log.pixels[15].colour, ColourRGB{}) << "the picture ends before";
    const Vector3& pinhole = log.pixels[6].pinhole;  // third column, second row
    const double pitch = 2.0 * std::tan(std::numbers::pi / 8.0) / 4.0;
    EXPECT_NEAR(pinhole.magnitude(), 1.0, 1e-12);
    EXPECT_NEAR(pinhole.x / pinhole.z, 0.5 * pitch, 1e-12);
    EXPECT_NEAR(pinhole.y / pinhole.z, -0.5 * pitch, 1e-12);
}

}  // namespace
}  // namespace ticker::tasks

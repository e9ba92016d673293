#include <grader/tasks/lens/answers/LensLog.h>
#include <grader/tasks/lens/checks/LensChecks.h>

#include <gtest/gtest.h>

namespace ticker::tasks {
namespace {

using probe::Event;

const ColourRGB kBackground{0.001};
const ColourRGB kAmbient{2.0, 3.0, 4.0};

constexpr int kNothing = -1;
constexpr int kBall = 0;

/// The log of a frame of one pixel that asks for two rays; its scene is a ball on the right, kBall.
/// Every lens ray starts at a place x of the lens and goes through the middle of the focal plane.
struct OnePixel {
    probe::RenderQuestion question;
    probe::RenderAnswer answer;

    OnePixel() {
        question.settings.width = 1;
        question.settings.height = 1;
        question.settings.dofRayCount = 2;
        question.repetitions = 1;
        question.scene.ambientLighting = kAmbient;
        raytracer::Material material;
        material.colour = ColourRGB{0.5, 0.5, 0.5};
        question.scene.spheres.push_back({{2.0, 0.0, 5.0}, 1.0, material, nullptr});
    }
    /// Logs an event; see Event for what `a` and `b` are.
    void tell(Event::Kind kind, const Vector3& a, const Vector3& b = {}, int object = kNothing) {
        Event event;
        event.kind = kind;
        event.a = a;
        event.b = b;
        event.object = object;
        event.bounces = question.settings.bounces;
        answer.events.push_back(event);
    }
    /// A lens ray is cast and hits this object; the code may trace it or not.
    void cast(double x, int object) {
        tell(Event::Kind::rayCast, {x, 0.0, 0.0}, towardsFocus(x), object);
    }
    /// `trace` follows a lens ray, with this result.
    void trace(double x, const ColourRGB& colour) {
        tell(Event::Kind::traceBegan, {x, 0.0, 0.0}, towardsFocus(x));
        tell(Event::Kind::traceEnded, {colour.r, colour.g, colour.b});
    }
    /// Ends the frame with this colour of the pixel, and reads the log.
    LensLog setPixel(const ColourRGB& colour) {
        tell(Event::Kind::pixelSet, {colour.r, colour.g, colour.b});
        answer.images = {{colour}};
        return readLensLog(question, answer);
    }
    [[nodiscard]] Vector3 towardsFocus(double x) const {
        return {-x, 0.0, question.settings.dofFocalPlane};
    }
};

TEST(LensLog, CountsARayThatHitNothingAndWasNotTraced) {
    OnePixel frame;
    frame.cast(0.1, kNothing);
    frame.cast(-0.1, kBall);
    frame.trace(-0.1, kAmbient);
    const LensLog log = frame.setPixel((kAmbient + kBackground) / 2.0);
    ASSERT_EQ(log.pixels[0].rays.size(), 2U);
    EXPECT_EQ(log.pixels[0].rays[0].value, kBackground);
    EXPECT_EQ(log.pixels[0].rays[1].value, kAmbient);
    EXPECT_FALSE(checkAverage(log));
}

TEST(LensLog, SeesThatSuchRaysAreLeftOutOfTheMean) {
    OnePixel frame;
    frame.cast(0.1, kNothing);
    frame.cast(-0.1, kBall);
    frame.trace(-0.1, kAmbient);
    const auto finding = checkAverage(frame.setPixel(kAmbient));
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->id, "dof.not-averaged");
}

TEST(LensLog, CountsARayOnceThatWasAskedAboutAndThenTraced) {
    OnePixel frame;
    frame.cast(0.1, kNothing);
    frame.trace(0.1, kBackground);
    frame.cast(-0.1, kBall);
    EXPECT_EQ(frame.setPixel(kBackground).pixels[0].rays.size(), 1U);
}

TEST(LensLog, LeavesOutARayThatOnlyLookedBesidesAllThatWereTraced) {
    OnePixel frame;
    frame.cast(0.0, kNothing);
    frame.trace(0.1, kAmbient);
    frame.trace(-0.1, kAmbient);
    const LensLog log = frame.setPixel(kAmbient);
    EXPECT_EQ(log.pixels[0].rays.size(), 2U);
    EXPECT_FALSE(checkAverage(log));
}

TEST(LensLog, CountsSuchARayBesidesAsManyTracedOnesAsAskedIfTheColourIsTheMeanOfAll) {
    OnePixel frame;
    frame.cast(0.0, kNothing);
    frame.trace(0.1, kAmbient);
    frame.trace(-0.1, kAmbient);
    const LensLog log = frame.setPixel((kAmbient * 2.0 + kBackground) / 3.0);
    EXPECT_EQ(log.pixels[0].rays.size(), 3U);
    EXPECT_FALSE(checkAverage(log));
}

TEST(LensLog, RecomputesWhatRaysOfAnotherRecursionGave) {
    for (const bool leftOut : {false, true}) {
        OnePixel frame;
        frame.cast(0.1, kNothing);
        frame.cast(-0.1, kBall);
        const ColourRGB hit = kAmbient * 0.5;
        const auto finding =
            checkAverage(frame.setPixel(leftOut ? hit : (hit + kBackground) / 2.0));
        EXPECT_EQ(finding.has_value(), leftOut);
    }
}

TEST(LensLog, JoinsATracedRayWithThoseOfAnotherRecursionWhereBothGiveTheColour) {
    for (const bool counted : {false, true}) {
        OnePixel frame;
        frame.trace(0.1, kBackground);
        frame.cast(-0.1, kBall);
        const ColourRGB together = (kBackground + kAmbient * 0.5) / 2.0;
        const LensLog log = frame.setPixel(counted ? together : kBackground);
        EXPECT_EQ(log.pixels[0].rays.size(), counted ? 2U : 1U);
        EXPECT_FALSE(checkAverage(log).has_value());
    }
}

/// Two pixels, rendered in two passes over the picture; the second pass sets the pixels.
OnePixel twoPasses(bool asksCamera) {
    OnePixel frame;
    frame.question.settings.width = 2;
    for (const int pass : {1, 2})
        for (const int x : {0, 1}) {
            if (asksCamera) frame.tell(Event::Kind::cameraRayAsked, {});
            if (asksCamera) frame.answer.events.back().x = x;
            const Vector3 lens{0.01 * pass, 0.0, 0.0};
            const Vector3 pinhole = pinholeDirection(frame.question.settings, x, 0);
            const Vector3 focus = pinhole * (frame.question.settings.dofFocalPlane / pinhole.z);
            frame.tell(Event::Kind::traceBegan, lens, focus - lens);
            frame.tell(Event::Kind::traceEnded, {1.0 * pass, 0.0, 0.0});
            if (pass == 1) continue;
            frame.tell(Event::Kind::pixelSet, {});
            frame.answer.events.back().x = x;
        }
    frame.answer.images = {{ColourRGB{1.5, 0.0, 0.0}, ColourRGB{1.5, 0.0, 0.0}}};
    return frame;
}

TEST(LensLog, GivesEachPixelItsRaysIfTheLastOfSeveralPassesSetsThePixels) {
    for (const bool asksCamera : {true, false}) {
        const OnePixel frame = twoPasses(asksCamera);
        const LensLog log = readLensLog(frame.question, frame.answer);
        for (const LensPixel& pixel : log.pixels)
            EXPECT_EQ(pixel.rays.size(), 2U) << asksCamera;
        EXPECT_FALSE(checkLensCounts(log));
        EXPECT_FALSE(checkAverage(log));
    }
}

TEST(LensLog, DoesNotTakeAReflectionForALensRay) {
    OnePixel frame;
    frame.cast(0.1, kBall);
    frame.tell(Event::Kind::traceBegan, {1.0, 0.0, 5.0}, {-1.0, 0.0, 0.0});
    frame.answer.events.back().bounces = frame.question.settings.bounces - 1;
    frame.tell(Event::Kind::traceEnded, {0.0, 0.0, 0.0});
    frame.cast(-0.1, kBall);
    const LensLog log = frame.setPixel(kAmbient);
    ASSERT_EQ(log.pixels[0].rays.size(), 2U);
    EXPECT_FALSE(log.pixels[0].rays[0].value);
}

}  // namespace
}  // namespace ticker::tasks

#include <grader/build/Build.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/exercise/Exercise.h>
#include <grader/lab/selftest/OracleExaminee.h>
#include <grader/lab/selftest/ScreenshotCases.h>
#include <grader/lab/selftest/ScreenshotStudent.h>
#include <grader/sandbox/SandboxPolicy.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <array>
#include <memory>
#include <utility>

namespace ticker::selftest {
namespace {

using Case = ScreenshotCase;
using oracle::Reading;

// Small sizes are more frequent: a large picture of option 2 takes seconds.
constexpr std::array kWidths{320, 640, 800, 320, 640, 1280, 320, 640, 800, 320};
constexpr std::size_t kByOracle = 132;  // of each option
constexpr std::size_t kPicturesOfASource = 6;

template <class Value, std::size_t size>
Value pick(const std::array<Value, size>& values, std::size_t& number) {
    const Value value = values[number % size];
    number /= size;
    return value;
}

/// The accepted bump readings of the oracle, by number.
Reading bumpReading(std::size_t number) {
    using oracle::BumpReading;
    Reading reading;
    reading.bump.uOrigin = pick(std::array{0.5, 0.25, 0.75, 0.0}, number);
    reading.bump.difference =
        pick(std::array{BumpReading::Difference::forward, BumpReading::Difference::backward,
                        BumpReading::Difference::central},
             number);
    reading.bump.lookup =
        pick(std::array{BumpReading::Lookup::nearest, BumpReading::Lookup::bilinear}, number);
    reading.bump.longitudeGain =
        pick(std::array{BumpReading::LatitudeGain::constant, BumpReading::LatitudeGain::sine,
                        BumpReading::LatitudeGain::inverseSine},
             number);
    reading.bump.mirrored = pick(std::array{false, true}, number);
    return reading;
}

/// The accepted readings of light and lens, by number.
Reading distributedReading(std::size_t number) {
    using oracle::LightShape;
    using oracle::PhongReading;
    Reading reading;
    reading.apertureFactor = pick(std::array{1.0, 0.5}, number);
    reading.lightShape = pick(std::array{LightShape::ball, LightShape::surface,
                                         LightShape::uniformRadius, LightShape::polarHelper},
                              number);
    reading.phong = pick(std::array{PhongReading::central, PhongReading::perSample,
                                    PhongReading::perSampleDirection},
                         number);
    reading.viewerIsEye = pick(std::array{false, true}, number);
    reading.shadowBias = pick(std::array{1e-4, 1e-3}, number);
    return reading;
}

/// A sequence of seeds that are far apart.
class Seeds {
public:
    explicit Seeds(std::uint64_t first) : next_(first) {}
    std::uint64_t next() { return next_ += 1000; }

private:
    std::uint64_t next_;
};

Case byOracle(const ScreenshotBench& bench, bool isDeterministic, std::size_t number,
              std::uint64_t seed) {
    const int width = kWidths[number % kWidths.size()];
    const int rays = number % 7 == 6 ? 200 : 50;  // one student in seven uses more rays
    Case made;
    made.kind =
        isDeterministic ? "option 1, the oracle's readings" : "option 2, the oracle's readings";
    made.name = fmt::format("reading {}, {} pixels wide, {} rays", number, width, rays);
    made.judge = [&bench, isDeterministic, number, width, rays, seed](double& judgeMs) {
        OracleExaminee code{isDeterministic ? bumpReading(number) : distributedReading(number),
                            {},
                            isDeterministic};
        const ScreenshotStudent student{bench.scenes, isDeterministic, code};
        return student.handIn(student.render(width, seed, rays), seed + 1, judgeMs);
    };
    return made;
}

build::Program programOf(const ScreenshotBench& bench, const RightSource& source) {
    build::BuildResult built = build::buildProgram(
        bench.kit, bench.sandbox, sandbox::defaultPolicy().compile, source.file, source.text);
    if (!built.program)
        throw raytracer::Error(source.name + " does not compile: " + built.diagnostics);
    return *std::move(built.program);
}

/// A source that is compiled for its first picture.
struct LateProgram {
    const RightSource& source;
    std::optional<build::Program> program;
};

Case byProgram(const ScreenshotBench& bench, const std::shared_ptr<LateProgram>& late,
               std::size_t i, std::uint64_t seed) {
    const bool isDeterministic = late->source.file == defaultExercise().files().front();
    // A large picture of option 2 takes half a minute.
    const int width = isDeterministic ? kWidths[i % kWidths.size()] : kWidths.front();
    Case made;
    made.kind = isDeterministic ? "option 1, compiled" : "option 2, compiled";
    made.name = fmt::format("{}, {} pixels wide", late->source.name, width);
    made.judge = [&bench, late, isDeterministic, width, seed](double& judgeMs) {
        if (!late->program) late->program = programOf(bench, late->source);
        const sandbox::Limits limits = sandbox::defaultPolicy().run;
        build::SandboxedExaminee code{*late->program, bench.sandbox, limits};
        const ScreenshotStudent student{bench.scenes, isDeterministic, code};
        return student.handIn(student.render(width, seed), seed + 1, judgeMs);
    };
    return made;
}

}  // namespace

std::vector<ScreenshotCase> honestScreenshots(const ScreenshotBench& bench, std::uint64_t seed) {
    Seeds seeds{seed};
    std::vector<Case> cases;
    for (const bool isDeterministic : {true, false})
        for (std::size_t i = 0; i < kByOracle; ++i)
            cases.push_back(byOracle(bench, isDeterministic, i, seeds.next()));
    for (const RightSource& source : bench.sources) {
        const auto late = std::make_shared<LateProgram>(LateProgram{source, std::nullopt});
        for (std::size_t i = 0; i < kPicturesOfASource; ++i)
            cases.push_back(byProgram(bench, late, i, seeds.next()));
    }
    return cases;
}

}  // namespace ticker::selftest

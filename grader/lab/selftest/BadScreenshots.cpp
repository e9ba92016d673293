#include <grader/lab/selftest/OracleExaminee.h>
#include <grader/lab/selftest/PictureTricks.h>
#include <grader/lab/selftest/ScreenshotCases.h>
#include <grader/lab/selftest/ScreenshotStudent.h>
#include <grader/metrics/Alignment.h>
#include <grader/oracle/references/References.h>

#include <raytracer/io/ImageWriter.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ticker::selftest {
namespace {

using Case = ScreenshotCase;
using oracle::Mistake;
using oracle::Reading;
using Make = std::function<Picture(const ScreenshotStudent& honest, std::uint64_t seed)>;

/// A scene of option 1 as rendered by a student who has solved option 2 as well: not through a
/// pinhole.
Picture throughTheLens(const std::vector<pipeline::SpecScene>& scenes, const char* name,
                       std::uint64_t seed) {
    OracleExaminee code{{}, {}, false};
    const auto scene = std::ranges::find(scenes, name, &pipeline::SpecScene::name);
    return ScreenshotStudent{scenes, !scene->isRandom, code}.render(*scene, 640, 480, seed);
}

/// Collects pictures that come with right code of one option, but are not its renders.
class BadPictures {
public:
    BadPictures(const ScreenshotBench& bench, bool isDeterministic, std::uint64_t seed)
        : bench_(bench), isDeterministic_(isDeterministic), seed_(seed) {}

    [[nodiscard]] std::vector<Case> all() {
        isDeterministic_ ? addOtherReliefs() : addOtherLenses();
        addOtherScenes();
        addEdits();
        addMishaps();
        addRecolourings();
        addSizes();
        return std::move(cases_);
    }

private:
    void add(const char* expected, const char* kind, Make make) {
        Case made;
        made.kind = kind;
        made.name = isDeterministic_ ? "option 1" : "option 2";
        made.expected = expected;
        const std::uint64_t seed = seed_ += 1000;
        made.judge = [&bench = bench_, isDeterministic = isDeterministic_, seed,
                      make = std::move(make)](double& judgeMs) {
            OracleExaminee code{{}, {}, isDeterministic};
            const ScreenshotStudent student{bench.scenes, isDeterministic, code};
            return student.handIn(make(student, seed), seed + 1, judgeMs);
        };
        cases_.push_back(std::move(made));
    }

    template <class Change>
    void addStranger(const char* kind, Change change) {
        add("screenshot.not-from-this-code", kind,
            [&bench = bench_, isDeterministic = isDeterministic_, change](const ScreenshotStudent&,
                                                                          std::uint64_t seed) {
                Reading reading;
                Mistake mistake;
                change(reading, mistake);
                OracleExaminee code{reading, mistake, isDeterministic};
                return ScreenshotStudent{bench.scenes, isDeterministic, code}.render(640, seed);
            });
    }

    void addEdit(const char* kind, std::function<Picture(const ByteView&)> edit,
                 const char* expected = "screenshot.edited") {
        add(expected, kind,
            [edit = std::move(edit)](const ScreenshotStudent& student, std::uint64_t seed) {
                return edit(student.render(640, seed).view());
            });
    }

    void addOtherReliefs() {
        addStranger("another's: inverted",
                    [](Reading& r, Mistake&) { r.bump.gainU = r.bump.gainV = -1.0; });
        addStranger("another's: inverted along u",
                    [](Reading& r, Mistake&) { r.bump.gainU = -1.0; });
        addStranger("another's: smooth",
                    [](Reading& r, Mistake&) { r.bump.gainU = r.bump.gainV = 0.0; });
        addStranger("another's: right, other origin",
                    [](Reading& r, Mistake&) { r.bump.uOrigin = 0.25; });
    }

    void addOtherLenses() {
        addStranger("another's: hard shadows",
                    [](Reading& r, Mistake&) { r.lightShape = oracle::LightShape::centre; });
        addStranger("another's: everything sharp",
                    [](Reading&, Mistake& m) { m.aperture = Mistake::Aperture::none; });
        addStranger("another's: off-centre aperture",
                    [](Reading&, Mistake& m) { m.lensOffsetX = m.lensOffsetY = 1.0; });
        addStranger("another's: ambient light shadowed",
                    [](Reading&, Mistake& m) { m.ambientScaled = true; });
        addStranger("another's: right, other aperture",
                    [](Reading& r, Mistake&) { r.apertureFactor = 0.5; });
        add("screenshot.is-the-reference", "the reference itself",
            [](const ScreenshotStudent& student, std::uint64_t seed) {
                raytracer::RenderSettings settings;
                settings.width = 400;
                settings.height = 300;
                raytracer::ByteImage image = raytracer::toBytes(
                    oracle::renderWithOracle(student.scene().scene, settings, seed));
                return Picture{image.width, image.height, std::move(image.rgb)};
            });
    }

    void addOtherScenes() {
        for (const pipeline::SpecScene& scene : bench_.scenes) {
            if (scene.isHandedIn && scene.isRandom != isDeterministic_) continue;
            add("screenshot.not-this-scene", "another scene",
                [&scene, &bench = bench_](const ScreenshotStudent&, std::uint64_t seed) {
                    OracleExaminee code{{}, {}, !scene.isRandom};
                    return ScreenshotStudent{bench.scenes, !scene.isRandom, code}.render(scene, 640,
                                                                                         480, seed);
                });
        }
        if (isDeterministic_)
            add("screenshot.not-this-scene", "another scene, through the lens",
                [&bench = bench_](const ScreenshotStudent&, std::uint64_t seed) {
                    return throughTheLens(bench.scenes, "bumpmap-test", seed);
                });
        add("screenshot.not-this-scene", "a photograph",
            [](const ScreenshotStudent&, std::uint64_t seed) {
                return photograph(640, 480, seed);
            });
    }

    void addEdits() {
        using metrics::Mirror;
        for (const auto& [mirror, kind] :
             {std::pair{Mirror::leftRight, "mirrored left to right"},
              std::pair{Mirror::upDown, "mirrored upside down"}, std::pair{Mirror::both, "turned"}})
            addEdit(kind,
                    [side = mirror](const ByteView& p) { return metrics::mirrored(p, side); });
        addEdit("a pixel too low", [](const ByteView& p) { return moved(p, 0, 1); });
        addEdit("a note on it", withANote);
        addEdit("in a viewer's window", [](const ByteView& p) { return inAWindow(p, 672, 556); });
        addEdit("on a whole screen", [](const ByteView& p) { return inAWindow(p, 1600, 1200); });
        addEdit("cropped, other shape", [](const ByteView& p) {
            return metrics::cropped(p, {120, 60, 400, 380});
        });
        addEdit("cropped, same shape", [](const ByteView& p) {
            return metrics::cropped(p, {120, 60, 480, 360});
        });
    }

    // Harmless changes to honest pictures: review at most.
    void addMishaps() {
        addEdit(
            "a pixel cut off all round",
            [](const ByteView& p) {
                return metrics::cropped(p, {1, 1, p.width - 2, p.height - 2});
            },
            "screenshot.unverified");
        addEdit(
            "scaled by a quarter",
            [](const ByteView& p) {
                return metrics::resized(p, 5 * p.width / 4, 5 * p.height / 4);
            },
            isDeterministic_ ? "screenshot.unverified" : "");
    }

    void addRecolourings() {
        addEdit("grey", inGrey);
        addEdit("red for blue", withRedForBlue);
        addEdit("negative", [](const ByteView& p) {
            return recoloured(p, [](double v, int) { return 1.0 - v; });
        });
        addEdit("brightened", [](const ByteView& p) {
            return recoloured(p, [](double v, int) { return std::pow(v, 0.6); });
        });
        addEdit(
            "slightly other colours",
            [](const ByteView& p) {
                return recoloured(p, [](double v, int channel) {
                    return v * (channel == 0 ? 1.03 : channel == 1 ? 1.0 : 0.97);
                });
            },
            "");
    }

    void addSizes() {
        for (const auto& [width, height] :
             {std::pair{960, 540}, std::pair{600, 600}, std::pair{200, 150}})
            add("screenshot.wrong-size", "another shape, or too small",
                [across = width, down = height](const ScreenshotStudent& student,
                                                std::uint64_t seed) {
                    return student.render(student.scene(), across, down, seed);
                });
    }

    const ScreenshotBench& bench_;
    bool isDeterministic_;
    std::uint64_t seed_;
    std::vector<Case> cases_;
};

}  // namespace

std::vector<ScreenshotCase> badScreenshots(const ScreenshotBench& bench, std::uint64_t seed) {
    std::vector<Case> cases = BadPictures{bench, true, seed}.all();
    for (Case& one : BadPictures{bench, false, seed + 1}.all())
        cases.push_back(std::move(one));
    return cases;
}

}  // namespace ticker::selftest

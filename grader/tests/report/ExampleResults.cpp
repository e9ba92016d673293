#include "ExampleResults.h"

#include <raytracer/io/ImageWriter.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <tuple>

namespace ticker::report {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

/// A ball with ripples, lit from the left, over a floor; `relief` -1 turns bumps into dents.
std::string drawBall(double relief, double noise, std::uint64_t seed) {
    std::mt19937_64 generator{seed};
    std::normal_distribution<double> grain{0.0, noise};
    raytracer::ByteImage image{kWidth, kHeight, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double u = (x - 160.0) / 85.0;
            const double v = (y - 115.0) / 85.0;
            double light = y > 160 ? 0.35 : 0.02;
            if (u * u + v * v < 1.0) {
                const double z = std::sqrt(1.0 - u * u - v * v);
                const double slope = 0.5 * relief * std::cos(14.0 * u) * std::cos(9.0 * v);
                light = std::clamp(0.15 + 0.75 * (0.6 * z - 0.6 * u - 0.4 * v + slope), 0.03, 1.0);
            }
            light = std::clamp(light + grain(generator), 0.0, 1.0);
            for (const double tint : {1.0, 0.72, 0.35})
                image.rgb.push_back(static_cast<std::uint8_t>(255.0 * std::sqrt(light * tint)));
        }
    return raytracer::encodePng(image);
}

/// The same, drawn once.
const std::string& ballPng(double relief, double noise, std::uint64_t seed) {
    static std::map<std::tuple<double, double, std::uint64_t>, std::string> drawn;
    std::string& png = drawn[{relief, noise, seed}];
    if (png.empty()) png = drawBall(relief, noise, seed);
    return png;
}

/// In the pipeline's final form: a title, and a file among the result's pictures.
Raster reliefRaster(const std::string& file) {
    Raster raster;
    raster.title = "relief that your normals show";
    raster.image = file;
    return raster;
}

ResultPicture reliefPicture(const std::string& file) {
    raytracer::ByteImage image{96, 48, {}};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            image.rgb.insert(
                image.rgb.end(), 3,
                static_cast<std::uint8_t>(127.0 + 127.0 * std::sin(x / 6.0) * std::cos(y / 7.0)));
    return {file, "relief that your normals show", raytracer::encodePng(image)};
}

ScatterPlot lensPlot() {
    ScatterPlot plot;
    plot.title = "Where 600 lens rays began";
    plot.unit = "world units";
    plot.expectedHalfWidth = 0.2;
    plot.otherHalfWidth = 0.1;
    std::mt19937_64 generator{7};
    std::uniform_real_distribution<double> along{-0.2, 0.2};
    while (plot.points.size() < 600) {
        const PlotPoint point{along(generator), along(generator)};
        if (point.x * point.x + point.y * point.y < 0.04) plot.points.push_back(point);
    }
    RayDrawing drawing;
    drawing.about = "The rays of one pixel";
    drawing.words = {"50 camera rays of one pixel."};
    drawing.spheres = {{"sphere 1", {0.0, 0.0, 4.0}, 0.5}};
    drawing.lensHalfWidth = 0.2;
    drawing.focalPlane = 3.5;
    drawing.rays = {{RayDrawing::Kind::expected, {}, {0.0, 0.0, 3.5}, "the expected ray", -1}};
    for (std::size_t i = 0; i < 50; ++i)
        drawing.rays.push_back({RayDrawing::Kind::camera,
                                {plot.points[i].x, plot.points[i].y, 0.0},
                                {0.0, 0.0, 3.5},
                                "a camera ray",
                                -1});
    plot.drawing = drawing;
    return plot;
}

void addPair(SubmissionResult& result, const std::string& scene, double relief, double noise) {
    RenderScore render;
    render.scene = scene;
    render.width = kWidth;
    render.height = kHeight;
    render.flip = relief < 0.0 ? 0.214 : 0.021;
    render.ssim = relief < 0.0 ? 0.61 : 0.97;
    render.gmsd = 0.04;
    render.rmse = 11.5;
    if (noise > 0.0) {
        render.zMax = 3.7;
        render.zMap = "images/" + scene + ".zmap.png";
        result.pictures.push_back({render.zMap, scene + ", z-map", ballPng(0.5, noise, 4)});
    }
    render.errorMap = "images/flip-" + scene + ".png";
    result.pictures.push_back({render.errorMap, scene + ", FLIP", ballPng(0.0, noise, 5)});
    render.image = "images/" + scene + ".png";
    render.reference = "images/expected-" + scene + ".png";
    result.pictures.push_back({render.reference, scene + ", expected", ballPng(1.0, noise, 1)});
    result.pictures.push_back(
        {render.image, scene + ", from this code", ballPng(relief, noise, 2)});
    result.renders.push_back(render);
}

SubmissionResult base(const std::string& name) {
    SubmissionResult result;
    result.submission = name;
    result.seed = 20240917;
    result.sandboxLevel = "A";
    result.toolVersion = "0.1.0";
    result.timing = {3120.0, 840.0, 4410.0};
    result.options = {{"T1", {"T1"}, 1.0}, {"T2", {"T2.1", "T2.2"}, 1.0}};
    return result;
}

TaskReport task(const std::string& id, TaskState state, const std::string& reason = "") {
    const std::string title = id == "T1"     ? "Bump mapping"
                              : id == "T2.1" ? "Soft shadows"
                              : id == "T2.2" ? "Depth of field"
                                             : "Screenshot";
    return {{state, reason, {}}, id, title};
}

Finding invertedU() {
    Finding finding;
    finding.id = "bump.inverted-u";
    finding.message =
        "Along u (to the right) bumps come out inverted: where the map rises to the right the "
        "normal should lean left, and yours leans right. Along v all is well.";
    finding.hint =
        "Equations (2) and (3) have opposite signs, and each fits one handedness: look at the "
        "sign of the term with B_u.";
    finding.section = "Option 1: What to do, step 3";
    finding.evidence = {{"responseMatrix", std::vector<double>{-1.0, 0.0, 0.0, 1.0}},
                        {"uInverted", 0.98},
                        {"letterHAlongU", std::string{"3 of 212 right, 208 inverted, 1 lost"}},
                        {"mirrored", false}};
    finding.rasters = {reliefRaster("images/T1-1.png")};
    return finding;
}

Finding discLens() {
    Finding finding;
    finding.id = "dof.disc";
    finding.message =
        "Rays should begin anywhere on a square aperture of half-width 0.2; yours fill a disc: no "
        "ray began in any of the four corners.";
    finding.hint = "Draw x and y of the lens point independently, each from -0.2 to 0.2.";
    finding.section = "Depth of field (T2.2)";
    finding.evidence = {{"rays", 600.0}, {"inCorners", 0.0}, {"expectedInCorners", 128.8}};
    finding.plots = {lensPlot()};
    return finding;
}

Finding clustered() {
    Finding finding;
    finding.id = "shadow.clustered";
    finding.severity = Severity::warn;
    finding.message = "Aim points crowd at the light's centre. This is accepted.";
    finding.section = "Soft shadows (T2.1)";
    return finding;
}

Finding oneOf(const char* id, const char* message) {
    Finding finding;
    finding.id = id;
    finding.message = message;
    finding.hint = "Look once more.";
    return finding;
}

}  // namespace

SubmissionResult passedExample() {
    SubmissionResult result = base("Ada Lovelace");
    result.verdict = Verdict::awarded;
    result.score = 1.0;
    result.option = "both";
    result.tasks = {task("T1", TaskState::passed), task("T2.1", TaskState::passed),
                    task("T2.2", TaskState::passed), task("screenshot", TaskState::passed)};
    result.tasks[0].rasters = {reliefRaster("images/T1-1.png")};
    result.tasks[1].findings = {clustered()};
    result.tasks[2].plots = {lensPlot()};
    result.pictures.push_back(reliefPicture("images/T1-1.png"));
    addPair(result, "bump-mapping", 1.0, 0.0);
    addPair(result, "distributed", 1.0, 0.05);
    result.pictures.push_back(
        {"images/screenshot.png", "screenshot.png as handed in", ballPng(1.0, 0.05, 3)});
    return result;
}

SubmissionResult failedBumpExample() {
    SubmissionResult result = base("bump-u-inverted");
    result.verdict = Verdict::notAwarded;
    result.option = "T1";
    result.tasks = {task("T1", TaskState::failed),
                    task("T2.1", TaskState::notAttempted, "The stub still stands."),
                    task("T2.2", TaskState::notAttempted, "The stub still stands."),
                    task("screenshot", TaskState::passed)};
    result.tasks[0].findings = {invertedU()};
    result.pictures.push_back(reliefPicture("images/T1-1.png"));
    result.pictures.push_back(
        {"images/screenshot.png", "screenshot.png as handed in", ballPng(-1.0, 0.0, 3)});
    addPair(result, "bump-mapping", -1.0, 0.0);
    addPair(result, "bumpmap-test", -1.0, 0.0);
    result.notices = {"notes.txt was not read: only the two source files and the screenshot are."};
    return result;
}

SubmissionResult failedLensExample() {
    SubmissionResult result = base("aperture-is-a-disc");
    result.verdict = Verdict::notAwarded;
    result.option = "T2";
    result.tasks = {task("T1", TaskState::notAttempted, "The stub still stands."),
                    task("T2.1", TaskState::passed), task("T2.2", TaskState::failed),
                    task("screenshot", TaskState::notAttempted, "There is no screenshot.png.")};
    result.tasks[1].findings = {clustered()};
    result.tasks[2].findings = {discLens()};
    addPair(result, "distributed", 1.0, 0.05);
    return result;
}

SubmissionResult blockedExample() {
    SubmissionResult result = base("does-not-compile");
    result.verdict = Verdict::notAwarded;
    result.tasks = {task("T1", TaskState::blocked, "BumpySphere.cpp does not compile."),
                    task("T2.1", TaskState::notAttempted, "The stub still stands."),
                    task("T2.2", TaskState::notAttempted, "The stub still stands.")};
    Finding finding;
    finding.id = "build.failed";
    finding.message = "BumpySphere.cpp does not compile with the kit.";
    finding.hint = "Read the first error below; later ones often follow from it.";
    result.tasks[0].findings = {finding};
    result.diagnostics = {
        {"BumpySphere.cpp",
         "BumpySphere.cpp: In member function 'getNormalAt':\n"
         "BumpySphere.cpp:4:12: error: 'nromal' was not declared in this scope; did you mean "
         "'normal'?\n    4 |     return nromal.normalised();\n      |            ^~~~~~\n"
         "      |            normal\n"
         "BumpySphere.cpp:2:1: note: declared here\n"}};
    result.sources = {{"BumpySphere.cpp",
                       "#include <raytracer/geometry/BumpySphere.h>\n"
                       "Vector3 BumpySphere::getNormalAt(const Vector3& p) const {\n"
                       "    const Vector3 normal = Sphere::getNormalAt(p);\n"
                       "    return nromal.normalised();\n}\n"}};
    return result;
}

SubmissionResult hostileExample() {
    const std::string hostile =
        "</style></script><script>alert(1)</script>\"'><img src=x onerror="
        "alert(2)>\x1B[31m\xE2\x80\xAE=cmd()]]>\xFF";
    SubmissionResult result = base("=hostile<img src=x onerror=alert(3)>\"'&");
    result.verdict = Verdict::needsReview;
    result.option = "T1";
    result.tasks = {task("T1", TaskState::failed, hostile), task("screenshot", TaskState::failed)};
    Finding finding = discLens();
    finding.message = finding.hint = finding.section = hostile;
    finding.evidence = {{hostile, hostile}, {"notFinite", std::nan("")}};
    finding.plots[0].title = finding.plots[0].unit = hostile;
    finding.plots[0].points = {{std::nan(""), 0.0}, {1e300, -1e300}, {0.1, 0.1}};
    RayDrawing& drawing = *finding.plots[0].drawing;
    drawing.about = drawing.words[0] = drawing.spheres[0].name = drawing.rays[1].words = hostile;
    drawing.rays[1].to = {std::nan(""), 1e300, -1e300};
    finding.rasters = {reliefRaster("https://example.org/" + hostile)};
    finding.rasters[0].title = hostile;
    result.tasks[0].findings = {finding};
    result.diagnostics = {{hostile, hostile + ":1:1: error: " + hostile}};
    result.sources = {{hostile, hostile}};
    result.notices = {hostile};
    addPair(result, "bump-mapping", 1.0, 0.0);
    for (ResultPicture& picture : result.pictures)
        picture.caption = hostile;
    result.renders[0].scene = hostile;
    result.toolVersion = hostile;
    return result;
}

SubmissionResult notCheckedExample() {
    SubmissionResult result = saidTwiceExample();
    result.submission = "nothing-to-compare-with";
    result.tasks[2] = task("T2.2", TaskState::notAttempted, "the stub still stands");
    return result;
}

SubmissionResult saidTwiceExample() {
    SubmissionResult result = base("renderer-does-not-compile");
    result.verdict = Verdict::notAwarded;
    result.option = "T2";
    const std::string message = "Renderer.cpp does not compile: error: expected ';'";
    result.tasks = {task("T1", TaskState::notAttempted, "there is no BumpySphere.cpp"),
                    task("T2.1", TaskState::blocked, message),
                    task("T2.2", TaskState::blocked, message),
                    task("screenshot", TaskState::blocked,
                         "not checked: there is no code that runs to compare it with")};
    for (const std::size_t i : {1U, 2U})
        result.tasks[i].findings = {oneOf("build.failed", message.c_str())};
    result.diagnostics = {{"Renderer.cpp", "Renderer.cpp:7:3: error: expected ';'\n"}};
    return result;
}

SubmissionResult textOnlyExample() {
    SubmissionResult result = base("text-only");
    result.verdict = Verdict::needsReview;
    for (const char* id : {"T1", "T2.1", "T2.2", "screenshot"}) {
        const char* message = "There is a text, but no file.";
        result.tasks.push_back(task(id, TaskState::blocked, message));
        result.tasks.back().findings = {oneOf("intake.missing-file", message)};
        result.tasks.back().needsReview = true;
    }
    return result;
}

SubmissionResult reviewExample() {
    SubmissionResult result = passedExample();
    result.submission = "no-screenshot";
    result.verdict = Verdict::needsReview;
    result.score = 0.0;
    result.tasks[3] = task("screenshot", TaskState::failed);
    result.tasks[3].findings = {oneOf("screenshot.missing", "There is no screenshot.png.")};
    return result;
}

SubmissionResult notGradedExample() {
    SubmissionResult result = failedBumpExample();
    result.verdict = Verdict::notGraded;
    result.tasks[0] = task("T1", TaskState::notGraded, "no memory on this machine");
    return result;
}

SubmissionResult nothingGradedExample() {
    SubmissionResult result = base("no-memory");
    for (const char* id : {"T1", "T2.1", "T2.2", "screenshot"})
        result.tasks.push_back(task(id, TaskState::notGraded, "no memory on this machine"));
    return result;
}

std::vector<SubmissionResult> exampleClass(int count) {
    const std::function<SubmissionResult()> makers[] = {
        passedExample, failedBumpExample, failedLensExample, blockedExample, hostileExample};
    std::vector<SubmissionResult> results;
    for (int i = 0; i < count; ++i) {
        results.push_back(makers[static_cast<std::size_t>(i) % std::size(makers)]());
        if (i >= static_cast<int>(std::size(makers)))
            results.back().submission += " " + std::to_string(i);
    }
    return results;
}

}  // namespace ticker::report

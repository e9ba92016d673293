#include <grader/cli/Home.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/intake/Intake.h>
#include <grader/oracle/references/References.h>
#include <grader/pipeline/RenderSubmission.h>

#include <raytracer/io/ImageWriter.h>
#include <raytracer/io/SceneReader.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace ticker::cli {
namespace {

struct RenderOptions {
    std::string scene;
    std::string image;
    std::string size;
    std::string solution;
    std::string engine = "solution";
    std::string exercise;
    bool pinhole = false;
    int samples = 0;
    int threads = 0;
    std::optional<std::uint64_t> seed;
};

raytracer::RenderSettings settingsOf(const RenderOptions& options) {
    raytracer::RenderSettings settings;
    char x = 'x';
    std::istringstream size{options.size.empty() ? "640x480" : options.size};
    if (!(size >> settings.width >> x >> settings.height) || x != 'x' || !size.eof() ||
        settings.width < 1 || settings.height < 1)
        throw raytracer::InputError("", 0,
                                    fmt::format("-r {}: expected WIDTHxHEIGHT", options.size));
    settings.threads = options.threads > 0
                           ? options.threads
                           : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    if (options.samples > 0) settings.dofRayCount = options.samples;
    if (options.pinhole) {
        settings.dofRayCount = settings.shadowRayCount = 1;
        settings.dofAmount = settings.lightSize = 0.0;
    }
    return settings;
}

raytracer::ExitCode renderByOracle(const RenderOptions& options) {
    const Home home = Home::find();
    raytracer::checkWritable(options.image);
    const auto scene = raytracer::readScene(options.scene, home.assets());
    const raytracer::RenderSettings settings = settingsOf(options);
    raytracer::writePng(
        options.pinhole
            ? oracle::renderPinholeWithOracle(scene, settings)
            : oracle::renderWithOracle(scene, settings, options.seed.value_or(0), options.samples),
        options.image);
    return raytracer::ExitCode::success;
}

/// A picture by a submission's code, made in the sandbox.
raytracer::ExitCode renderBySubmission(const RenderOptions& options) {
    const Home home = Home::find();
    raytracer::checkWritable(options.image);
    const auto scene = raytracer::readScene(options.scene, home.assets());
    raytracer::RenderSettings settings = settingsOf(options);
    settings.seed = options.seed.value_or(std::random_device{}());
    const pipeline::Grader grader = makeGrader({.exercise = options.exercise});
    const raytracer::ByteImage picture = pipeline::renderSubmission(
        intake::readSubmission({"solution", options.solution}, {.exercise = grader.exercise}),
        grader, scene, settings);
    raytracer::writePng(picture, options.image);
    return raytracer::ExitCode::success;
}

/// The reference solution as a program; only the default exercise has one.
std::string referenceProgram(const Home& home, const std::string& exercise) {
    const std::string& known = defaultExercise().name;
    if (exercise != known)
        throw raytracer::InputError(
            "", 0,
            fmt::format("--exercise {0}: it has no reference program; give --solution FOLDER, "
                        "--engine oracle, or --exercise {1}, whose reference renders every scene",
                        exercise, known));
    return (home.programs / (known + "-reference")).string();
}

// Runs the reference in the program that students use, with its progress bar and Ctrl-C.
raytracer::ExitCode becomeReference(const RenderOptions& options, const GlobalOptions& global) {
    const Home home = Home::find();
    const std::string program = referenceProgram(home, options.exercise);
    std::vector<std::string> words{program,       "-i",       options.scene,         "-o",
                                   options.image, "--assets", home.assets().string()};
    const auto pass = [&](const char* name, const std::string& value) {
        if (!value.empty()) words.insert(words.end(), {name, value});
    };
    pass("-r", options.size);
    pass("--seed", options.seed ? std::to_string(*options.seed) : "");
    pass("--threads", options.threads > 0 ? std::to_string(options.threads) : "");
    pass("--dof-rays", options.samples > 0 ? std::to_string(options.samples) : "");
    if (options.pinhole) words.emplace_back("--pinhole");
    if (global.quiet) words.emplace_back("--quiet");
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv(program.c_str(), arguments.data());
    throw raytracer::Error(fmt::format("cannot run {}: {}; ./tick builds it", program,
                                       std::generic_category().message(errno)));
}

}  // namespace

Run addRender(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* verb = app.add_subcommand("render", "Render a scene");
    verb->add_option("scene", options->scene, "Scene file")->required();
    verb->add_option("-o,--output", options->image, "PNG file to write")->required();
    verb->add_option("-r,--resolution", options->size, "WIDTHxHEIGHT, 640x480 if not given");
    addExerciseOption(*verb, options->exercise);
    CLI::Option* samples =
        verb->add_option("--samples", options->samples, "Camera rays for each pixel")
            ->check(CLI::PositiveNumber);
    verb->add_flag("--pinhole", options->pinhole,
                   "Neither lens nor soft shadows: for scenes of option 1 and the main tick")
        ->excludes(samples);
    verb->add_option("--threads", options->threads, "Threads; the picture does not depend on them")
        ->check(CLI::PositiveNumber);
    verb->add_option("--seed", options->seed, "Whole number; the same seed, the same picture");
    verb->add_option("--solution", options->solution, "A submission's folder; else the reference");
    verb->add_option("--engine", options->engine, "solution, or the grader's own oracle")
        ->check(CLI::IsMember({"solution", "oracle"}));
    return [options, &global] {
        if (options->engine == "oracle") return renderByOracle(*options);
        if (!options->solution.empty()) return renderBySubmission(*options);
        return becomeReference(*options, global);
    };
}

}  // namespace ticker::cli

#include <grader/cli/Home.h>
#include <grader/cli/Verb.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <unistd.h>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ticker::cli {
namespace {

struct RenderOptions {
    std::string scene;
    std::string image;
    std::string size;
    std::string solution;
    std::string engine = "solution";
    int samples = 0;
    int threads = 0;
    std::string seed;
};

// tick1star is the renderer: the same program that students run, with its progress bar and Ctrl-C.
raytracer::ExitCode becomeTick1star(const RenderOptions& options, const Voice& voice) {
    const Home home = Home::find();
    const std::string program = (home.programs / "tick1star-reference").string();
    std::vector<std::string> words{program,       "-i",       options.scene,         "-o",
                                   options.image, "--assets", home.assets().string()};
    const auto pass = [&](const char* name, const std::string& value) {
        if (!value.empty()) words.insert(words.end(), {name, value});
    };
    pass("-r", options.size);
    pass("--seed", options.seed);
    pass("--threads", options.threads > 0 ? std::to_string(options.threads) : "");
    pass("--dof-rays", options.samples > 0 ? std::to_string(options.samples) : "");
    if (voice.quiet) words.emplace_back("--quiet");
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv(program.c_str(), arguments.data());
    throw raytracer::Error(fmt::format("cannot run {}; is it built?", program));
}

}  // namespace

Run addRender(CLI::App& app, const Voice& voice) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* verb = app.add_subcommand("render", "Render a scene with the reference solution");
    verb->add_option("scene", options->scene, "Scene file")->required();
    verb->add_option("-o,--output", options->image, "PNG file to write")->required();
    verb->add_option("-r,--resolution", options->size, "WIDTHxHEIGHT, 640x480 if not given");
    verb->add_option("--samples", options->samples, "Camera rays for each pixel")
        ->check(CLI::PositiveNumber);
    verb->add_option("--threads", options->threads, "Threads; the picture does not depend on them")
        ->check(CLI::PositiveNumber);
    verb->add_option("--seed", options->seed, "Whole number; the same seed, the same picture");
    return [options, &voice] { return becomeTick1star(*options, voice); };
}

}  // namespace ticker::cli

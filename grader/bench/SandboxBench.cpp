// What the sandbox costs: medians of interleaved pairs, once in it and once without.
// usage: ticker_bench_sandbox PROJECT [--level A|B|C] [--rounds N] [--json FILE]
#include <grader/build/Build.h>
#include <grader/picture/DecodePicture.h>
#include <grader/sandbox/HelperProgram.h>
#include <grader/sandbox/RunAt.h>
#include <grader/sandbox/SandboxPolicy.h>

#include <raytracer/base/Error.h>
#include <raytracer/io/ImageReader.h>

#include <fmt/format.h>

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace ticker {
namespace {

namespace fs = std::filesystem;

struct Options {
    fs::path project;
    std::string level;  ///< empty: the best
    int rounds = 30;
    std::string json;
};

struct Figure {
    std::string name;
    double value;
    std::string unit;
};

/// Milliseconds of the wall clock, and of CPU by us and all who ended (user and system).
struct Cost {
    double wall = 0.0;
    double cpu = 0.0;
};

double cpuMilliseconds(int who) {
    rusage usage{};
    getrusage(who, &usage);
    return 1e3 * static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-3 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

double cpuMilliseconds() {
    return cpuMilliseconds(RUSAGE_SELF) + cpuMilliseconds(RUSAGE_CHILDREN);
}

Cost costOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    const double before = cpuMilliseconds();
    work();
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    return {wall.count(), cpuMilliseconds() - before};
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// Medians of the same work in the sandbox and without, done in turns.
struct Pair {
    Cost inside;
    Cost outside;
};

Pair measured(int rounds, const std::function<void()>& inside,
              const std::function<void()>& outside) {
    std::vector<Cost> in;
    std::vector<Cost> out;
    inside();
    for (int round = 0; round < rounds; ++round) {
        in.push_back(costOf(inside));
        out.push_back(costOf(outside));
    }
    const auto medianOf = [](const std::vector<Cost>& costs, double Cost::*part) {
        std::vector<double> values;
        for (const Cost& cost : costs)
            values.push_back(cost.*part);
        return median(std::move(values));
    };
    return {{medianOf(in, &Cost::wall), medianOf(in, &Cost::cpu)},
            {medianOf(out, &Cost::wall), medianOf(out, &Cost::cpu)}};
}

void require(bool done, const char* what) {
    if (!done) throw raytracer::Error(fmt::format("{} failed", what));
}

void spawnDirectly(const std::vector<std::string>& command) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::string path = "PATH=/usr/bin:/bin";
    char* const environment[] = {path.data(), nullptr};
    pid_t child = 0;
    int status = 0;
    require(posix_spawn(&child, words[0].c_str(), nullptr, nullptr, arguments.data(),
                        environment) == 0 &&
                waitpid(child, &status, 0) == child && status == 0,
            "a command outside the sandbox");
}

std::string readAll(const fs::path& file) {
    std::ifstream stream{file, std::ios::binary};
    if (!stream) throw raytracer::InputError(file.string(), 0, "cannot be read");
    return {std::istreambuf_iterator<char>{stream}, {}};
}

std::vector<Figure> emptyRun(const sandbox::Sandbox& jail, int rounds) {
    const std::string program = sandbox::findProgram("ticker-jail").string();
    const Pair pair = measured(
        rounds, [&] { require(sandbox::runNothing(jail.level()).succeeded(), "a run of nothing"); },
        [&] {
            spawnDirectly({program, "nothing"});
        });
    return {{"a program that does nothing, in the sandbox, wall clock", pair.inside.wall, "ms"},
            {"the same, CPU", pair.inside.cpu, "ms"},
            {"more than without, wall clock", pair.inside.wall - pair.outside.wall, "ms"},
            {"more than without, CPU", pair.inside.cpu - pair.outside.cpu, "ms"}};
}

// As grader/build does it in the sandbox.
std::vector<std::string> compileCommand(const build::Kit& kit, const fs::path& source,
                                        const fs::path& program) {
    std::vector<std::string> words{kit.compiler()};
    const auto inKit = [&](const char* name) { return (kit.folder() / name).string(); };
    words.insert(words.end(), kit.compileFlags().begin(), kit.compileFlags().end());
    words.insert(words.end(),
                 {"-I" + inKit("include"), "-include", inKit("pch/Framework.h"), source.string(),
                  inKit("template/Renderer.o"), inKit("lib/probe.o"), "-Wl,--whole-archive",
                  inKit("lib/libkit.a"), "-Wl,--no-whole-archive", "-o", program.string()});
    words.insert(words.end(), kit.linkFlags().begin(), kit.linkFlags().end());
    return words;
}

std::vector<Figure> compiling(const sandbox::Sandbox& jail, const Options& options) {
    const build::Kit kit = build::Kit::besideProgram();
    const fs::path source = options.project / "reference_solution/exercise/BumpySphere.cpp";
    const std::string text = readAll(source);
    const build::JobFolder folder;
    const auto command = compileCommand(kit, source, folder.path() / "probe");
    const sandbox::Limits limits = sandbox::defaultPolicy().compile;
    const Pair pair = measured(
        options.rounds,
        [&] {
            const auto built =
                build::buildProgram(kit, jail, limits, build::SourceFile::bumpySphere, text);
            require(built.program.has_value(), "compiling in the sandbox");
        },
        [&] { spawnDirectly(command); });
    const auto more = [](double inside, double outside) {
        return 100.0 * (inside / outside - 1.0);
    };
    return {{"compiling and linking a solution, in the sandbox, CPU", pair.inside.cpu, "ms"},
            {"more than without, CPU", more(pair.inside.cpu, pair.outside.cpu), "%"},
            {"more than without, wall clock", more(pair.inside.wall, pair.outside.wall), "%"}};
}

std::vector<Figure> decoding(const sandbox::Sandbox& jail, const Options& options) {
    const std::string bytes =
        readAll(options.project / "grader/samples/awarded/reference-bump/screenshot.png");
    const sandbox::Limits limits = sandbox::defaultPolicy().decode;
    const Pair pair = measured(
        options.rounds,
        [&] {
            const picture::Decoded decoded = picture::decodePicture(bytes, jail, limits);
            require(std::holds_alternative<raytracer::ByteImage>(decoded), "decoding");
        },
        [&] { static_cast<void>(raytracer::decodeImage(bytes, "screenshot")); });
    return {{"decoding a screenshot in the sandbox, CPU", pair.inside.cpu, "ms"},
            {"more than in our own process, CPU", pair.inside.cpu - pair.outside.cpu, "ms"}};
}

Options parsed(int count, char** words) {
    if (count < 2)
        throw raytracer::InputError("", 0,
                                    "usage: ticker_bench_sandbox PROJECT [--level A|B|C] "
                                    "[--rounds N] [--json FILE]");
    Options options;
    options.project = words[1];
    for (int i = 2; i + 1 < count; i += 2) {
        const std::string name = words[i];
        if (name == "--level") options.level = words[i + 1];
        if (name == "--rounds") options.rounds = std::max(1, std::stoi(words[i + 1]));
        if (name == "--json") options.json = words[i + 1];
    }
    return options;
}

sandbox::Sandbox chosen(const std::string& level) {
    using sandbox::Level;
    for (const Level each : {Level::namespaces, Level::ownUser, Level::sameUser})
        if (sandbox::toString(each) == level) return sandbox::Sandbox::at(each);
    return sandbox::Sandbox::best();
}

void print(const std::vector<Figure>& figures, const std::string& json) {
    std::string lines;
    for (const Figure& figure : figures) {
        fmt::print("{:<58} {:>8.3g} {}\n", figure.name, figure.value, figure.unit);
        lines += fmt::format("{}  {{\"name\": \"{}\", \"value\": {:.6g}, \"unit\": \"{}\"}}",
                             lines.empty() ? "" : ",\n", figure.name, figure.value, figure.unit);
    }
    if (!json.empty()) std::ofstream{json} << "[\n" << lines << "\n]\n";
}

int run(int count, char** words) {
    const Options options = parsed(count, words);
    const sandbox::Sandbox jail = chosen(options.level);
    fmt::print("sandbox level {}, medians of {} pairs\n", sandbox::toString(jail.level()),
               options.rounds);
    std::vector<Figure> figures = emptyRun(jail, options.rounds);
    for (const std::vector<Figure>& more : {compiling(jail, options), decoding(jail, options)})
        figures.insert(figures.end(), more.begin(), more.end());
    print(figures, options.json);
    return raytracer::toInt(raytracer::ExitCode::success);
}

}  // namespace
}  // namespace ticker

int main(int count, char** words) {
    try {
        return ticker::run(count, words);
    } catch (const raytracer::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return raytracer::toInt(error.exitCode());
    }
}

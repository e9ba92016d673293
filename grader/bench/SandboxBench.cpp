// Overhead of the sandbox: medians of interleaved pairs of runs, inside and outside of it.
#include <grader/base/WholeFile.h>
#include <grader/bench/Harness.h>
#include <grader/build/Build.h>
#include <grader/exercise/Exercise.h>
#include <grader/picture/DecodePicture.h>
#include <grader/sandbox/HelperProgram.h>
#include <grader/sandbox/RunAt.h>
#include <grader/sandbox/SandboxPolicy.h>

#include <raytracer/base/Error.h>
#include <raytracer/io/ImageReader.h>

#include <fmt/format.h>

#include <string>
#include <vector>

namespace ticker::bench {
namespace {

namespace fs = std::filesystem;

struct Options {
    fs::path project;
    std::string level;  ///< empty: the best
    int rounds = 30;
};

void require(bool done, const char* what) {
    if (!done) throw raytracer::Error(fmt::format("{} failed", what));
}

std::vector<Figure> emptyRun(const sandbox::Sandbox& jail, int rounds) {
    const std::string program = sandbox::findProgram("ticker-jail").string();
    const Pair pair = measurePair(
        rounds, [&] { require(sandbox::runNothing(jail.level()).succeeded(), "a run of nothing"); },
        [&] {
            runProgram({program, "nothing"});
        });
    return {{"a program that does nothing, in the sandbox, wall clock", pair.first.wall, "ms"},
            {"the same, CPU", pair.first.cpu, "ms"},
            {"more than without, wall clock", pair.first.wall - pair.second.wall, "ms"},
            {"more than without, CPU", pair.first.cpu - pair.second.cpu, "ms"}};
}

// The compile command of grader/build, without the sandbox.
std::vector<std::string> compileCommand(const build::Kit& kit, const fs::path& source,
                                        const fs::path& program) {
    std::vector<std::string> words{kit.compiler()};
    const auto inKit = [&](const char* name) { return (kit.folder() / name).string(); };
    words.insert(words.end(), kit.compileFlags().begin(), kit.compileFlags().end());
    words.insert(words.end(),
                 {"-I" + inKit("include"), "-include", inKit("pch/Framework.h"), source.string(),
                  inKit(build::Kit::templateObject(kit.files().back())), inKit("lib/probe.o"),
                  "-Wl,--whole-archive", inKit("lib/libkit.a"), "-Wl,--no-whole-archive", "-o",
                  program.string()});
    words.insert(words.end(), kit.linkFlags().begin(), kit.linkFlags().end());
    return words;
}

std::vector<Figure> compiling(const sandbox::Sandbox& jail, const Options& options) {
    const build::Kit kit = build::Kit::besideProgram();
    const fs::path source = options.project / defaultExercise().reference / kit.files().front();
    const std::string text = readWhole(source);
    const sandbox::JobFolder folder;
    const auto command = compileCommand(kit, source, folder.path() / "probe");
    const sandbox::Limits limits = sandbox::defaultPolicy().compile;
    const Pair pair = measurePair(
        options.rounds,
        [&] {
            const auto built = build::buildProgram(kit, jail, limits, kit.files().front(), text);
            require(built.program.has_value(), "compiling in the sandbox");
        },
        [&] { runProgram(command); });
    const auto more = [](double inside, double outside) {
        return 100.0 * (inside / outside - 1.0);
    };
    return {{"compiling and linking a solution, in the sandbox, CPU", pair.first.cpu, "ms"},
            {"more than without, CPU", more(pair.first.cpu, pair.second.cpu), "%"},
            {"more than without, wall clock", more(pair.first.wall, pair.second.wall), "%"}};
}

std::vector<Figure> decoding(const sandbox::Sandbox& jail, const Options& options) {
    const std::string bytes =
        readWhole(options.project / "grader/corpus/samples/awarded/reference-bump/screenshot.png");
    const sandbox::Limits limits = sandbox::defaultPolicy().decode;
    const Pair pair = measurePair(
        options.rounds,
        [&] {
            const picture::Decoded decoded = picture::decodePicture(bytes, jail, limits);
            require(std::holds_alternative<raytracer::ByteImage>(decoded), "decoding");
        },
        [&] { static_cast<void>(raytracer::decodeImage(bytes, "screenshot")); });
    return {{"decoding a screenshot in the sandbox, CPU", pair.first.cpu, "ms"},
            {"more than in our own process, CPU", pair.first.cpu - pair.second.cpu, "ms"}};
}

sandbox::Sandbox chosen(const std::string& level) {
    using sandbox::Level;
    for (const Level each : {Level::namespaces, Level::ownUser, Level::sameUser})
        if (sandbox::toString(each) == level) return sandbox::Sandbox::at(each);
    return sandbox::Sandbox::best();
}

std::vector<Figure> measure(const Options& options) {
    const sandbox::Sandbox jail = chosen(options.level);
    fmt::print("sandbox level {}, medians of {} pairs\n", sandbox::toString(jail.level()),
               options.rounds);
    std::vector<Figure> figures = emptyRun(jail, options.rounds);
    for (const std::vector<Figure>& more : {compiling(jail, options), decoding(jail, options)})
        figures.insert(figures.end(), more.begin(), more.end());
    return figures;
}

}  // namespace
}  // namespace ticker::bench

int main(int count, char** words) {
    CLI::App app{"What the sandbox costs: once in it and once without, in turns",
                 "ticker_bench_sandbox"};
    ticker::bench::Options options;
    app.add_option("project", options.project, "The project's folder")->required();
    app.add_option("--level", options.level, "A, B or C; the best that this machine gives");
    app.add_option("--rounds", options.rounds, "Pairs")->check(CLI::PositiveNumber);
    return ticker::bench::runSuite(app, count, words,
                                   [&] { return ticker::bench::measure(options); });
}

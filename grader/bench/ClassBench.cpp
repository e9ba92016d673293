// Benchmark of grading a class, as ratios: CPU time of ticker and all its child processes, against
// a bare compiler that builds programs from the same files. Medians of interleaved rounds, two
// workers.
#include <grader/bench/Harness.h>
#include <grader/exercise/Exercise.h>

#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace ticker::bench {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr int kWorkers = 2;
constexpr int kCopies = 3;  // of each right submission in a round
const std::array<std::string, 3> kBump{"reference-bump", "bump-bilinear", "bump-z-up"};
const std::array<std::string, 3> kDistributed{"reference-distributed", "distributed-half-width",
                                              "distributed-phong-per-sample"};

struct Options {
    fs::path root;
    int submissions = 200;
    int rounds = 5;
};

/// A folder that is removed on destruction.
class Folder {
public:
    Folder() : path_(fs::temp_directory_path() / fmt::format("ticker-bench-{}", getpid())) {
        fs::create_directories(path_);
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// Runs the two sides of the comparison.
class Bench {
public:
    explicit Bench(Options options)
        : options_(std::move(options)),
          programs_(fs::read_symlink("/proc/self/exe").parent_path()),
          kit_(programs_.parent_path() / "kit" / defaultExercise().name) {}

    [[nodiscard]] std::vector<Figure> run() const {
        const double startUp = gradedSeconds("start", {"notAwarded/template-untouched"}, 1);
        std::vector<double> bare;
        std::vector<double> bump;
        std::vector<double> distributed;
        std::vector<double> ratio;
        for (int round = 0; round < options_.rounds; ++round) {
            bare.push_back((bareSeconds(kBump) + bareSeconds(kDistributed)) / 2.0);
            bump.push_back(perSubmission("bump", kBump, startUp));
            distributed.push_back(perSubmission("two tasks", kDistributed, startUp));
            ratio.push_back((bump.back() + distributed.back()) / 2.0 / bare.back());
        }
        std::vector<Figure> figures{
            {"bare g++ -O2: two files, compiled and linked, CPU", 1e3 * median(bare), "ms"},
            {"honest option 1, CPU", 1e3 * median(bump), "ms"},
            {"honest option 2, CPU", 1e3 * median(distributed), "ms"},
            {"honest submission / bare compile", median(ratio), "x"},
            {"start of ticker, once for a class, CPU", 1e3 * startUp, "ms"}};
        for (Figure& figure : wholeClass())
            figures.push_back(std::move(figure));
        return figures;
    }

private:
    /// CPU time of grading a class that consists of samples, each `copies` times.
    [[nodiscard]] double gradedSeconds(const std::string& name, const Words& samples,
                                       int copies) const {
        const fs::path folder = folder_.path() / name;
        fs::remove_all(folder);
        for (int copy = 0; copy < copies; ++copy)
            for (const std::string& sample : samples)
                copySample(sample,
                           folder / "class" /
                               fmt::format("{}-{}", fs::path{sample}.filename().string(), copy));
        const double before = childSeconds();
        grade(folder);
        return childSeconds() - before;
    }

    void copySample(const std::string& sample, const fs::path& target) const {
        fs::create_directories(target.parent_path());
        fs::copy(options_.root / "grader/corpus/samples" / sample, target,
                 fs::copy_options::recursive);
    }

    /// @return the output of ticker
    std::string grade(const fs::path& folder) const {
        const fs::path output = folder / "output.txt";
        finish(start({programs_ / "ticker", "grade", folder / "class", "-o", folder / "out",
                      "--jobs", std::to_string(kWorkers), "--seed", "1", "--verbose"},
                     output),
               output);
        return readIfThere(output).value_or("");
    }

    double perSubmission(const std::string& name, const std::array<std::string, 3>& samples,
                         double startUp) const {
        Words awarded;
        for (const std::string& sample : samples)
            awarded.push_back("awarded/" + sample);
        return (gradedSeconds(name, awarded, kCopies) - startUp) /
               static_cast<double>(samples.size() * kCopies);
    }

    /// CPU time of the compiler for one submission: its file and the template's other file, linked
    /// with the framework and the probe by the default linker.
    [[nodiscard]] double bareSeconds(const std::array<std::string, 3>& samples) const {
        const double before = childSeconds();
        for (std::size_t i = 0; i < samples.size(); i += kWorkers) {
            std::vector<std::pair<pid_t, fs::path>> running;
            for (std::size_t k = i; k < std::min(i + kWorkers, samples.size()); ++k) {
                const fs::path output = folder_.path() / fmt::format("bare-{}.txt", k);
                running.emplace_back(start(bareCommand(samples.at(k), k), output), output);
            }
            for (const auto& [child, output] : running)
                finish(child, output);
        }
        return (childSeconds() - before) / static_cast<double>(samples.size());
    }

    [[nodiscard]] Words bareCommand(const std::string& sample, std::size_t place) const {
        Words words{"/usr/bin/g++", "-O2", "-std=c++20", "-I" + (kit_ / "include").string()};
        for (const std::string& file : defaultExercise().files()) {
            const fs::path own = options_.root / "grader/corpus/samples/awarded" / sample / file;
            words.push_back((fs::exists(own) ? own : kit_ / "template" / file).string());
        }
        words.push_back((kit_ / "lib/probe.o").string());
        words.push_back((kit_ / "lib/libkit.a").string());
        words.push_back("-o");
        words.push_back((folder_.path() / fmt::format("bare-{}", place)).string());
        return words;
    }

    /// A class with all samples, under names with quotes, spaces and other unusual characters.
    [[nodiscard]] std::vector<Figure> wholeClass() const {
        const fs::path folder = folder_.path() / "whole";
        const std::vector<std::string> samples = mixedSamples();
        const std::array<const char*, 5> names{"J\xC3\xBCrgen, jr", "<b>Ann</b>", "O'Neill \"x\"",
                                               "=1+1", "\xE5\xBC\xA0 \xE4\xBC\x9F"};
        for (int i = 0; i < options_.submissions; ++i) {
            const auto place = static_cast<std::size_t>(i);
            copySample(samples.at(place % samples.size()),
                       folder / "class" / fmt::format("{}_{}", names.at(place % names.size()), i));
        }
        const auto begin = std::chrono::steady_clock::now();
        const double before = childSeconds();
        const std::string said = grade(folder);
        const double cpu = childSeconds() - before;
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
        return {{fmt::format("class of {}, two workers, wall clock", options_.submissions),
                 wall.count(), "s"},
                {fmt::format("class of {}, CPU", options_.submissions), cpu, "s"},
                {fmt::format("class of {}, memory of ticker itself", options_.submissions),
                 megabytesIn(said), "MB"}};
    }

    // All samples except the endless loop, which would only measure the CPU limit.
    [[nodiscard]] std::vector<std::string> mixedSamples() const {
        std::vector<std::string> samples;
        for (const char* verdict : {"awarded", "notAwarded", "needsReview"})
            for (const auto& entry :
                 fs::directory_iterator{options_.root / "grader/corpus/samples" / verdict})
                if (entry.is_directory() && entry.path().filename() != "loops-for-ever")
                    samples.push_back(std::string{verdict} + "/" +
                                      entry.path().filename().string());
        std::ranges::sort(samples);
        return samples;
    }

    // Parses "peak memory 123 MB", as printed by grade --verbose.
    static double megabytesIn(const std::string& said) {
        const std::string words = "peak memory ";
        const std::size_t at = said.find(words);
        return at == std::string::npos ? -1.0 : std::atof(said.c_str() + at + words.size());
    }

    Options options_;
    fs::path programs_;
    fs::path kit_;
    Folder folder_;
};

}  // namespace
}  // namespace ticker::bench

int main(int count, char** words) {
    CLI::App app{"What grading a class costs, against a bare compiler", "ticker_bench_class"};
    ticker::bench::Options options;
    app.add_option("project", options.root, "The project's folder")->required();
    app.add_option("--submissions", options.submissions, "In the whole class")
        ->check(CLI::PositiveNumber);
    app.add_option("--rounds", options.rounds, "Rounds")->check(CLI::PositiveNumber);
    return ticker::bench::runSuite(app, count, words,
                                   [&] { return ticker::bench::Bench{options}.run(); });
}

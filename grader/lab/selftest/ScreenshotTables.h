#ifndef TICKER_SELFTEST_SCREENSHOTTABLES_H
#define TICKER_SELFTEST_SCREENSHOTTABLES_H

#include <grader/build/Kit.h>
#include <grader/pipeline/SpecScenes.h>
#include <grader/sandbox/Sandbox.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ticker::selftest {

/// Source text of a right file.
struct RightSource {
    std::string name;
    std::string file;  ///< one of the exercise's files
    std::string text;
};

/// Inputs of the screenshots' tests.
struct ScreenshotBench {
    const std::vector<pipeline::SpecScene>& scenes;
    const build::Kit& kit;
    const sandbox::Sandbox& sandbox;
    /// Right sources that are compiled and asked, beside the oracle's readings.
    std::vector<RightSource> sources;
};

struct ScreenshotRun {
    double fraction =
        1.0;  ///< share of the honest and of the bad pictures, evenly picked; at least one of each
    std::uint64_t seed = 1;                                          ///< of pictures and windows
    std::function<void(std::size_t done, std::size_t of)> progress;  ///< or null
};

/// Pictures of one kind.
struct ScreenshotRow {
    std::string kind;
    std::string expected;  ///< expected finding; empty: none above a note
    int judged = 0;
    int asExpected = 0;
    double judgeMs = 0.0;  ///< mean CPU time of one judgement, without that of the student's code
};

/// What `./tick selftest --screenshots` prints.
struct ScreenshotSelfTest {
    std::vector<ScreenshotRow> honest;
    std::vector<ScreenshotRow> bad;
    std::vector<std::string> surprises;  ///< one line for each picture with an unexpected result

    /// True if no honest picture has a finding above a note, and every bad one has its own.
    [[nodiscard]] bool passed() const { return surprises.empty(); }
    [[nodiscard]] std::string table() const;
};

/// Judges 300 honest pictures of both scenes (four sizes, accepted readings, seeds, more rays than
/// asked for), and bad ones of every kind. Most of the code is the oracle, under all readings; the
/// rest are the compiled sources.
/// @throws raytracer::Error if a source does not compile.
[[nodiscard]] ScreenshotSelfTest runScreenshotTables(const ScreenshotBench& bench,
                                                     const ScreenshotRun& run);

}  // namespace ticker::selftest

#endif

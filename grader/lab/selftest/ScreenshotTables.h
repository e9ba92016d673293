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
    std::string file;  ///< which of the exercise's
    std::string text;
};

/// What screenshots are made of and judged with.
struct ScreenshotBench {
    const std::vector<pipeline::SpecScene>& scenes;
    const build::Kit& kit;
    const sandbox::Sandbox& sandbox;
    /// Compiled and asked, beside the oracle's readings.
    std::vector<RightSource> sources;
};

struct ScreenshotRun {
    double fraction = 1.0;   ///< share of the honest pictures, evenly picked; of the others, too
    std::uint64_t seed = 1;  ///< of pictures and windows
    std::function<void(std::size_t done, std::size_t of)> progress;  ///< or null
};

/// Pictures of one kind.
struct ScreenshotRow {
    std::string kind;
    std::string expected;  ///< finding; empty: none above a note
    int judged = 0;
    int asExpected = 0;
    double judgeMs = 0.0;  ///< CPU of one judgement without the code's own, mean
};

/// What `./tick selftest --screenshots` prints.
struct ScreenshotSelfTest {
    std::vector<ScreenshotRow> honest;
    std::vector<ScreenshotRow> bad;
    std::vector<std::string> surprises;  ///< one line for each picture that was not as expected

    /// No honest picture has a finding above a note; every bad one has its own.
    [[nodiscard]] bool passed() const { return surprises.empty(); }
    [[nodiscard]] std::string table() const;
};

/// Judges 300 honest pictures of both scenes (four sizes, accepted readings, seeds, more rays than
/// asked) and bad ones of every kind. Most students are the oracle, under all readings; the sources
/// are compiled and judge, and make, the rest.
/// @throws raytracer::Error where a source does not compile.
[[nodiscard]] ScreenshotSelfTest runScreenshotTables(const ScreenshotBench& bench,
                                                     const ScreenshotRun& run);

}  // namespace ticker::selftest

#endif

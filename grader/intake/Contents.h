#ifndef TICKER_INTAKE_CONTENTS_H
#define TICKER_INTAKE_CONTENTS_H

#include <grader/exercise/Exercise.h>
#include <grader/intake/Submission.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::intake {

/// What intake takes at most. The sizes are far above what honest work needs: a solution is about
/// 5 KiB, a screenshot of 640 x 480 about 500 KiB.
struct IntakeLimits {
    std::uint64_t sourceBytes = 256U << 10U;
    std::uint64_t screenshotBytes = 16U << 20U;
    std::uint64_t archiveBytes = 64U << 20U;  ///< of the archive itself
    std::uint64_t unpackedBytes = 256U << 20U;
    std::uint64_t members = 4096;
    int depth = 16;               ///< folders in folders
    double largestRatio = 100.0;  ///< unpacked to packed, above `ratioFreeBytes`
    std::uint64_t ratioFreeBytes = 16U << 20U;
    const Exercise* exercise = &theExercise();  ///< whose files are taken
};

/// A file that may be one of the parts.
struct Candidate {
    std::string part;                ///< its name
    std::string path;                ///< inside the submission
    std::string bytes;               ///< empty where it was not read
    std::optional<Finding> refusal;  ///< why it was not read
};

/// An archive among what was handed in.
struct Packed {
    std::string path;
    std::string bytes;
};

/// What is in a folder or an archive.
struct Contents {
    std::vector<Candidate> candidates;
    std::vector<Packed> archives;
    std::vector<std::string> others;  ///< paths of everything else
    std::vector<Finding> refusals;    ///< of the submission as a whole
};

/// The part that a file of this path may be: by its last component, whatever its case, also with
/// what browsers and systems add to a name ("File (1).cpp", "File.cpp.txt") or with another ending
/// of C++ ("File.cc"). The framework's own files do not count.
[[nodiscard]] std::optional<std::string> partOf(std::string_view path, const Exercise& exercise);

/// True for what systems leave behind: "__MACOSX/...", "._File.cpp", ".git/...".
[[nodiscard]] bool isLitter(std::string_view path);

/// A finding of severity fail.
[[nodiscard]] Finding refusal(std::string id, std::string message, std::string hint);

/// How many bytes of a part are taken.
[[nodiscard]] std::uint64_t byteLimitOf(std::string_view part, const IntakeLimits& limits);
/// intake.too-large, about one part.
[[nodiscard]] Finding tooLarge(std::string_view path, std::uint64_t limit);

/// True for the name of a zip or tar archive.
[[nodiscard]] bool isArchive(std::string_view path);

/// Reads a folder and what is below it. Links, pipes and devices are never opened.
/// @param owner  Whose part of a Moodle export to read; empty: all that is there.
/// @throws raytracer::InputError where the folder itself cannot be read.
[[nodiscard]] Contents readFolder(const std::filesystem::path& folder, const IntakeLimits& limits,
                                  const std::string& owner = {});

/// Reads a zip or tar archive in memory; nothing is unpacked to disk.
/// @param owner  As for readFolder.
/// @throws raytracer::InputError where the file cannot be read at all.
[[nodiscard]] Contents readArchive(const std::filesystem::path& file, const IntakeLimits& limits,
                                   const std::string& owner = {});
/// Likewise, of an archive that lay inside another or in a folder.
[[nodiscard]] Contents readArchive(const Packed& packed, const IntakeLimits& limits);

/// The paths of an archive's members; empty where it cannot be read.
[[nodiscard]] std::vector<std::string> listArchive(const std::filesystem::path& file);

}  // namespace ticker::intake

#endif

#ifndef TICKER_INTAKE_CONTENTS_H
#define TICKER_INTAKE_CONTENTS_H

#include <grader/exercise/Exercise.h>
#include <grader/intake/Submission.h>
#include <grader/result/FindingText.h>

#include <raytracer/base/Error.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::intake {

/// Upper limits of intake. They are far above honest work: a solution has about 5 KiB, a screenshot
/// of 640 x 480 about 500 KiB. `unpackedBytes`, `members` and `ratioFreeBytes` are of a
/// submission's archive and all archives inside together.
struct IntakeLimits {
    std::uint64_t sourceBytes = 256U << 10U;
    std::uint64_t screenshotBytes = 16U << 20U;
    std::uint64_t archiveBytes = 64U << 20U;  ///< of the archive itself
    std::uint64_t unpackedBytes = 256U << 20U;
    std::uint64_t members = 4096;
    std::uint64_t pathBytes = 4096;  ///< of a member; no system opens a longer path
    int depth = 16;                  ///< folders in folders
    double largestRatio = 100.0;  ///< unpacked size divided by packed size, above `ratioFreeBytes`
    std::uint64_t ratioFreeBytes = 16U << 20U;
    const Exercise* exercise = &defaultExercise();        ///< the exercise whose files are taken
    std::span<const Exercise> others = knownExercises();  ///< exercises that are told apart from it
};

/// A file that may be one of the parts.
struct Candidate {
    std::string part;                ///< its name
    std::string path;                ///< inside the submission
    std::string bytes;               ///< empty if it was not read
    std::optional<Finding> refusal;  ///< why it was not read
};

/// An archive inside a submission.
struct Packed {
    std::string path;
    std::string bytes;
};

/// What was read of a submission's archives so far. The archives inside one go on with its numbers:
/// many small ones cost as much as a large one.
struct Unpacked {
    std::uint64_t bytes = 0;
    std::uint64_t members = 0;
};

/// Contents of a folder or an archive.
struct Contents {
    std::vector<Candidate> candidates;
    std::vector<Packed> archives;
    std::vector<std::string> others;  ///< paths of everything else
    std::vector<Finding> refusals;    ///< of the submission as a whole
    Unpacked unpacked;                ///< to read it, and what was read before it
};

/// The part that a file of this path may be, by its last component, in any case. Additions of
/// browsers and systems ("File (1).cpp", "File.cpp.txt") and other endings of C++ ("File.cc") are
/// accepted. The framework's own files do not count.
[[nodiscard]] std::optional<std::string> partOf(std::string_view path, const Exercise& exercise);

/// True for files that operating systems and tools add: "__MACOSX/...", "._File.cpp", ".git/...".
[[nodiscard]] bool isLitter(std::string_view path);

/// A finding of severity fail.
[[nodiscard]] Finding refusal(const FindingText& text, std::string message, std::string hint);

/// Largest accepted size of a part.
[[nodiscard]] std::uint64_t byteLimitOf(std::string_view part, const IntakeLimits& limits);
/// The finding intake.too-large for one part.
[[nodiscard]] Finding tooLarge(std::string_view path, std::uint64_t limit,
                               const Exercise& exercise);

/// True for the name of a zip or tar archive.
[[nodiscard]] bool isArchive(std::string_view path);

/// The error for a file or folder that the system does not let us read: no student's fault.
/// @param error  errno
[[nodiscard]] raytracer::InputError unreadable(const std::filesystem::path& path, int error);

/// Reads a folder and all folders below it. Links, pipes and devices are never opened.
/// @param owner  The owner in a class export whose part is read; empty: everything.
/// @param out    A folder of results, which is no part of the submission; may be empty. Others are
///               recognised: see `isOut`.
/// @throws raytracer::InputError if the folder, or a file or folder in it that may be work, cannot
///         be read.
[[nodiscard]] Contents readFolder(const std::filesystem::path& folder, const IntakeLimits& limits,
                                  const std::string& owner = {},
                                  const std::filesystem::path& out = {});

/// Reads a zip or tar archive in memory; nothing is unpacked to disk.
/// @param owner  As for readFolder.
/// @throws raytracer::InputError if the file cannot be read, or is a damaged class export.
[[nodiscard]] Contents readArchive(const std::filesystem::path& file, const IntakeLimits& limits,
                                   const std::string& owner = {});
/// The same for an archive inside another or in a folder.
/// @param before  What was unpacked of the submission before.
[[nodiscard]] Contents readArchive(const Packed& packed, const IntakeLimits& limits,
                                   const Unpacked& before);

/// The paths of an archive's members.
struct MemberList {
    std::vector<std::string> paths;
    std::string damage;  ///< why it may have more members, or is no archive; empty: these are all
};

/// @param mostBytes  Of all paths together. By default enough for a class of thousands with their
///                   whole projects. An archive with more has that as damage.
/// @throws raytracer::InputError if the file cannot be read.
[[nodiscard]] MemberList listArchive(const std::filesystem::path& file,
                                     std::uint64_t mostBytes = 64U << 20U);

}  // namespace ticker::intake

#endif

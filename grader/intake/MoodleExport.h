#ifndef TICKER_INTAKE_MOODLEEXPORT_H
#define TICKER_INTAKE_MOODLEEXPORT_H

#include <grader/exercise/Exercise.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::intake {

/// A file of a Moodle export: whose it is, and where it lies in what he handed in.
struct MoodleFile {
    std::string owner;  ///< "Ann Lee_123", "Participant_123", "Default group": raw bytes
    std::string path;   ///< "src/File.cpp", "onlinetext/onlinetext.html"; may be empty
};

/// Takes a path of an export apart, whichever of Moodle's layouts it follows, also below one folder
/// that an unpacking program made; empty: no submission's path.
[[nodiscard]] std::optional<MoodleFile> readMoodlePath(std::string_view path);

/// Who and what is in an export, a zip or a folder.
struct MoodleExport {
    std::vector<std::string> owners;  ///< everybody, by name; empty: it is no export
    std::vector<std::string> others;  ///< first components of what may be work, but fits no layout
};

/// One name in Moodle's manner makes no export: most of what may be work has to fit.
[[nodiscard]] MoodleExport readMoodleExport(const std::filesystem::path& exported,
                                            const Exercise& exercise);

/// Stands for an owner, in Located, where "ann" is one of the others.
[[nodiscard]] std::string ownerOfOther(std::string_view other);

/// Where a path of an export lies in the work of one owner; empty: it is not his.
/// @param owner  Empty: all is his.
[[nodiscard]] std::optional<std::string> pathInWork(std::string_view owner, std::string_view path);

}  // namespace ticker::intake

#endif

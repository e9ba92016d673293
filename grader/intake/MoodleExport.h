#ifndef TICKER_INTAKE_MOODLEEXPORT_H
#define TICKER_INTAKE_MOODLEEXPORT_H

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::intake {

/// A file of a Moodle export: whose it is, and where it lies in what he handed in.
struct MoodleFile {
    std::string owner;  ///< "Ann Lee_123", "Participant_123", "Default group": raw bytes
    std::string path;   ///< "src/Renderer.cpp", "onlinetext/onlinetext.html"; may be empty
};

/// Takes a path of an export apart, whichever of Moodle's layouts it follows, also below one folder
/// that an unpacking program made; empty: no submission's path.
[[nodiscard]] std::optional<MoodleFile> readMoodlePath(std::string_view path);

/// Everybody in an export (a zip or a folder), by name; empty: it is no export.
[[nodiscard]] std::vector<std::string> moodleOwners(const std::filesystem::path& exported);

}  // namespace ticker::intake

#endif

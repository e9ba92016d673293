#ifndef TICKER_TESTS_SUPPORT_MOODLEEXPORT_H
#define TICKER_TESTS_SUPPORT_MOODLEEXPORT_H

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::tests {

/// A file with a path and bytes.
struct NamedBytes {
    std::string path;
    std::string bytes;
};

/// A participant or a team with a submission in Moodle.
struct MoodleStudent {
    std::string fullName;  ///< "Ann Lee"; a team's name in a team assignment
    int id = 0;  ///< what the worksheet calls "Participant 123"; 0: none, as Moodle's default team
    std::string group = {};  ///< empty: the course has no groups
    std::vector<NamedBytes> files = {};
    std::string onlineText = {};  ///< HTML typed into Moodle's own editor; empty: none
};

/// How Moodle wrote the export.
struct MoodleLayout {
    bool folders = true;              ///< one folder each (since 3.1), or all files in one place
    bool trailingUnderscore = false;  ///< "..._assignsubmission_file_/", before 4.1
    bool blind = false;               ///< names hidden: "Participant_123_..."
};

/// The files of the export, named as by mod/assign's download_submissions(), without the characters
/// that Moodle removes from file names.
[[nodiscard]] std::vector<NamedBytes> moodleExport(const std::vector<MoodleStudent>& students,
                                                   const MoodleLayout& layout = {});

/// Writes files as one zip, with names in UTF-8. @throws std::runtime_error
void writeZip(const std::filesystem::path& file, const std::vector<NamedBytes>& members);

/// Writes files below a folder, as unpacking the zip would.
void writeFolder(const std::filesystem::path& folder, const std::vector<NamedBytes>& members);

}  // namespace ticker::tests

#endif

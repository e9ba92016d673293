#ifndef TICKER_INTAKE_CLASSEXPORT_H
#define TICKER_INTAKE_CLASSEXPORT_H

#include <grader/intake/OutFolder.h>

#include <raytracer/base/Error.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::intake {

/// Owner of a file in an export of Moodle or Canvas, and its path inside the owner's submission.
struct ExportedFile {
    std::string owner;  ///< "Ann Lee_123", "Participant_123", "Default group": raw bytes
    std::string path;   ///< "src/File.cpp", "onlinetext/onlinetext.html"; may be empty
};

/// Splits a path of an export, in any layout of Moodle or Canvas, also below one folder that an
/// unpacking program added; empty if it is not a submission's path.
[[nodiscard]] std::optional<ExportedFile> readExportedPath(std::string_view path);

/// Owners and other contents of an export (a zip or a folder).
struct ClassExport {
    std::vector<std::string> owners;  ///< all owners, by name; empty if it is not an export
    /// First components of paths that may be work, but fit no layout.
    std::vector<std::string> others;
    std::string damage;  ///< of the zip: why owners may be missing; empty: none are
};

/// Reads an export. Most paths that may be work must fit one of these layouts: a single such name
/// does not make an export.
/// @throws raytracer::InputError if a zip cannot be read.
[[nodiscard]] ClassExport readClassExport(const std::filesystem::path& exported,
                                          const Wanted& wanted);

/// The error for an export that was not downloaded whole. Grading what is left of it would call
/// the rest missing, or charge the damage to its students.
[[nodiscard]] raytracer::InputError damagedDownload(const std::filesystem::path& exported,
                                                    const std::string& damage);

/// Name of the owner in Located for one of `others`.
[[nodiscard]] std::string ownerOfOther(std::string_view other);

/// Path inside the work of one owner; empty if it belongs to another.
/// @param owner  Empty: all paths belong to it.
[[nodiscard]] std::optional<std::string> pathInWork(std::string_view owner, std::string_view path);

}  // namespace ticker::intake

#endif

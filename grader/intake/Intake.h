#ifndef TICKER_INTAKE_INTAKE_H
#define TICKER_INTAKE_INTAKE_H

#include <grader/intake/Contents.h>
#include <grader/intake/Submission.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::intake {

/// A submission's place on disk.
struct Located {
    std::string name;                ///< unique in its class; valid as a folder name
    std::filesystem::path path;      ///< a folder or an archive
    std::string owner = {};          ///< owner of this part of `path`, if `path` is a class export
    std::filesystem::path out = {};  ///< where results go; no part of the submission if it is in it
};

/// All submissions below a path. A path is a submission if it contains one of the parts, or a
/// class: a folder of such folders and archives, over any number of levels. A folder with other
/// contents counts as a submission if its neighbours are submissions: the files may have wrong
/// names. An export of Moodle or Canvas, as downloaded or unpacked, gives every owner, as
/// "<name>_<id>", and everything else that may be work, by its own name. A folder that cannot be
/// read is a submission: reading it says why.
/// @param out  A folder of results, left out if it lies in the class; may be empty. Others are
///             recognised: see `isOut`.
/// @throws raytracer::InputError if the path does not exist, cannot be read, or is the zip of an
///         export that was not downloaded whole.
[[nodiscard]] std::vector<Located> findSubmissions(const std::filesystem::path& path,
                                                   const Exercise& exercise = defaultExercise(),
                                                   const std::filesystem::path& out = {});

/// Reads one submission; never throws because of its contents.
/// @throws raytracer::InputError if something of it cannot be read.
[[nodiscard]] Submission readSubmission(const Located& located, const IntakeLimits& limits = {});

}  // namespace ticker::intake

#endif

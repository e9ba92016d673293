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
    std::string name;            ///< unique among those found together; fit to name a folder
    std::filesystem::path path;  ///< a folder or an archive
    std::string owner = {};      ///< whose part of `path` it is, where that is a Moodle export
};

/// All submissions below a path: the folder itself where it holds one of the parts, an
/// archive, or a folder of such, also over several levels. A folder that holds something else
/// stands for a submission too, where its neighbours are submissions: somebody misnamed his files.
/// A Moodle export, as downloaded or unpacked, gives everybody in it, by "<name>_<id>", and what
/// else may be work in it, by its own name.
/// @throws raytracer::InputError where the path does not exist or cannot be read.
[[nodiscard]] std::vector<Located> findSubmissions(const std::filesystem::path& path,
                                                   const Exercise& exercise = theExercise());

/// Reads one submission; never throws for what is in it.
/// @throws raytracer::InputError where the folder or archive itself cannot be read.
[[nodiscard]] Submission readSubmission(const Located& located, const IntakeLimits& limits = {});

}  // namespace ticker::intake

#endif

#ifndef TICKER_PACKAGE_STUDENTPACKAGE_H
#define TICKER_PACKAGE_STUDENTPACKAGE_H

#include <grader/exercise/Exercise.h>

#include <filesystem>

namespace ticker::package {

/// Writes the students' package: the template, the public tests, the scenes and their maps, the
/// handout with its pictures if there is one, the licence. It contains no solution, oracle, mistake
/// or reference picture.
/// @param data  Contains student_template/, scenes/, assets/ and the handout (Home::data).
/// @throws raytracer::InputError if a part cannot be read or `file` cannot be written.
void writeStudentPackage(const std::filesystem::path& data, const Exercise& exercise,
                         const std::filesystem::path& file);

}  // namespace ticker::package

#endif

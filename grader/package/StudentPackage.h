#ifndef TICKER_PACKAGE_STUDENTPACKAGE_H
#define TICKER_PACKAGE_STUDENTPACKAGE_H

#include <filesystem>

namespace ticker::package {

/// What students get: the template, the public tests, the scenes and their maps, the handout with
/// its pictures where it is written, the licence. No solution, oracle, mistake or reference
/// picture.
/// @param data  Holds student_template/, scenes/, assets/ and docs/ (Home::data).
/// @throws raytracer::InputError where a part cannot be read or `file` not be written.
void writeStudentPackage(const std::filesystem::path& data, const std::filesystem::path& file);

}  // namespace ticker::package

#endif

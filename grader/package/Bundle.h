#ifndef TICKER_PACKAGE_BUNDLE_H
#define TICKER_PACKAGE_BUNDLE_H

#include <grader/package/Platforms.h>
#include <grader/zip/ZipWriter.h>

namespace ticker::package {

/// Adds ticker/: the grader with its own shared libraries, so that the platform has to provide only
/// a compiler; and ticker/prepare.sh, which installs that compiler and adapts the kit to it.
/// @throws raytracer::InputError if a part, or the kit's compiler, cannot be read.
void addBundle(zip::ZipWriter& zip, const Parts& parts);

/// The contents of a file of grader/integrations. In it the words EXERCISE, TITLE, UUID, HANDIN
/// (HTML) and PARTS, each between two at signs, are replaced by the exercise's name, title,
/// question id, sentence on what to hand in, and parts.
[[nodiscard]] std::string integration(const Parts& parts, const std::string& name);

}  // namespace ticker::package

#endif

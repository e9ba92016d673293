#ifndef TICKER_PACKAGE_BUNDLE_H
#define TICKER_PACKAGE_BUNDLE_H

#include <grader/package/Platforms.h>
#include <grader/zip/ZipWriter.h>

namespace ticker::package {

/// Adds ticker/: the grader with its own shared libraries, so that the platform has to provide only
/// a compiler; and ticker/prepare.sh, which installs that compiler and adapts the kit to it.
void addBundle(zip::ZipWriter& zip, const Parts& parts);

/// The contents of a file of grader/integrations. Three words between at signs are replaced:
/// EXERCISE by the exercise's name, FILES by its files (HTML), PARTS by the parts of a submission.
[[nodiscard]] std::string integration(const Parts& parts, const std::string& name);

}  // namespace ticker::package

#endif

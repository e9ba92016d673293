#ifndef TICKER_PACKAGE_BUNDLE_H
#define TICKER_PACKAGE_BUNDLE_H

#include <grader/package/Platforms.h>
#include <grader/zip/ZipWriter.h>

namespace ticker::package {

/// Adds ticker/: everything that grades, with its own shared libraries, so that the platform has to
/// bring a compiler only; and ticker/prepare.sh, which gets that compiler and makes the kit fit it.
void addBundle(zip::ZipWriter& zip, const Parts& parts);

/// A file of grader/integrations, as it stands there.
[[nodiscard]] std::string integration(const Parts& parts, const std::string& name);

}  // namespace ticker::package

#endif

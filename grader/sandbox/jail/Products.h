#ifndef TICKER_SANDBOX_JAIL_PRODUCTS_H
#define TICKER_SANDBOX_JAIL_PRODUCTS_H

#include <grader/sandbox/jail/Options.h>

#include <cstdint>

namespace ticker::jail {

/// Copies the command's products from its scratch folder to their descriptors: regular files with
/// one name, owned by the jail's uid, not larger than the file size limit. Links are not followed.
/// Call only when nothing of the command runs any more.
/// @returns how many were missing or unfit.
[[nodiscard]] std::uint32_t copyProducts(const Options& options);

}  // namespace ticker::jail

#endif

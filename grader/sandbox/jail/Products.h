#ifndef TICKER_SANDBOX_JAIL_PRODUCTS_H
#define TICKER_SANDBOX_JAIL_PRODUCTS_H

#include <grader/sandbox/jail/JailOptions.h>

#include <cstdint>

namespace ticker::jail {

/// Copies the command's products from its scratch folder to their descriptors. A product must be a
/// regular file with a single link, owned by the jail's uid and not larger than the file size
/// limit. Symbolic links are not followed. Call only after all processes of the command have ended.
/// @returns the number of products that were missing or refused.
[[nodiscard]] std::uint32_t copyProducts(const Options& options);

}  // namespace ticker::jail

#endif

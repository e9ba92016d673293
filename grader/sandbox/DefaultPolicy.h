#ifndef TICKER_SANDBOX_DEFAULTPOLICY_H
#define TICKER_SANDBOX_DEFAULTPOLICY_H

namespace ticker::sandbox {

/// The text of limits.json, in a source that CMake writes.
extern const char* const kDefaultPolicyText;

}  // namespace ticker::sandbox

#endif

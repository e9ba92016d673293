#ifndef TICKER_SANDBOX_DEFAULT_POLICY_H
#define TICKER_SANDBOX_DEFAULT_POLICY_H

namespace ticker::sandbox {

/// The text of limits.json, in a source that CMake writes.
extern const char* const kDefaultPolicyText;

}  // namespace ticker::sandbox

#endif

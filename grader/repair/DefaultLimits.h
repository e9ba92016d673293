#ifndef TICKER_REPAIR_DEFAULT_LIMITS_H
#define TICKER_REPAIR_DEFAULT_LIMITS_H

namespace ticker::repair {

/// The text of limits.json, in a source that CMake writes.
extern const char* const kDefaultLimitsText;

}  // namespace ticker::repair

#endif

#ifndef TICKER_REPAIR_DEFAULTLIMITS_H
#define TICKER_REPAIR_DEFAULTLIMITS_H

namespace ticker::repair {

/// The text of limits.json, in a source that CMake writes.
extern const char* const kDefaultLimitsText;

}  // namespace ticker::repair

#endif

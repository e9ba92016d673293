#ifndef TICKER_RESULT_RESULTINPUTS_H
#define TICKER_RESULT_RESULTINPUTS_H

#include <string>

namespace ticker {

/// Digests (lower-case hexadecimal digits) of everything on which a result depends. Two gradings
/// with equal inputs give equal results except for timing. Unknown digests are empty.
struct Inputs {
    std::string files;  ///< the submitted files
    std::string tool;   ///< the build of ticker and its kit
    std::string how;    ///< rubric, options, sandbox level, seed

    [[nodiscard]] bool areKnown() const { return !files.empty(); }
    friend bool operator==(const Inputs&, const Inputs&) = default;
};

}  // namespace ticker

#endif

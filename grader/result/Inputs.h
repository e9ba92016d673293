#ifndef TICKER_RESULT_INPUTS_H
#define TICKER_RESULT_INPUTS_H

#include <string>

namespace ticker {

/// What a result depends on, as digests (lower-case hexadecimal digits). Two gradings with equal
/// inputs give equal results but for timing. Empty strings where nobody knows.
struct Inputs {
    std::string files;  ///< what was handed in
    std::string tool;   ///< the build of ticker and its kit
    std::string how;    ///< rubric, options, sandbox level, seed

    [[nodiscard]] bool areKnown() const { return !files.empty(); }
    friend bool operator==(const Inputs&, const Inputs&) = default;
};

}  // namespace ticker

#endif

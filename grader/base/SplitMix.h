#ifndef TICKER_BASE_SPLITMIX_H
#define TICKER_BASE_SPLITMIX_H

#include <cstdint>

namespace ticker {

/// The next word of splitmix64 (Steele, Lea and Flood 2014): equal states give equal words on every
/// machine, which the standard library's distributions do not promise.
[[nodiscard]] inline std::uint64_t splitMix(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
}

}  // namespace ticker

#endif

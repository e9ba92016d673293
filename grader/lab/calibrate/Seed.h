#ifndef TICKER_CALIBRATE_SEED_H
#define TICKER_CALIBRATE_SEED_H

#include <cstdint>
#include <string_view>

namespace ticker::calibrate {

/// A seed that depends only on a name, so that new subjects, scenes and readings do not change the
/// records of the others. Below 2^60; the lowest 20 bits are free for counting. (FNV-1a, 64 bits:
/// Fowler, Noll, Vo.)
[[nodiscard]] constexpr std::uint64_t seedOf(std::string_view name) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char c : name)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    return hash >> 24U << 20U;
}

}  // namespace ticker::calibrate

#endif

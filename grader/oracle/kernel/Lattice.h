#ifndef TICKER_ORACLE_LATTICE_H
#define TICKER_ORACLE_LATTICE_H

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace ticker::oracle {

/// Generating vector of an embedded rank-1 lattice rule for up to 2^20 points: the first 2^m points
/// are a lattice rule for every m. R. Cools, F. Kuo and D. Nuyens, "Constructing embedded lattice
/// rules for multivariate integration", SIAM J. Sci. Comput. 28(6), 2006 (order-2 weights). Any odd
/// numbers would give unbiased estimates; these spread the points well.
inline constexpr std::array<std::uint32_t, 32> kGenerator{
    1,      182667, 469891, 498753, 110745, 446247, 250185, 118627, 245333, 283199, 408519,
    391023, 246327, 126539, 399185, 461527, 300343, 69681,  516695, 436179, 106383, 238523,
    413283, 70841,  47719,  300129, 113029, 123925, 410745, 211325, 17489,  511893};

/// The 32 bits of a number in reverse order (base-2 radical inverse).
[[nodiscard]] constexpr std::uint32_t reversedBits(std::uint32_t value) {
    value = ((value >> 1U) & 0x55555555U) | ((value & 0x55555555U) << 1U);
    value = ((value >> 2U) & 0x33333333U) | ((value & 0x33333333U) << 2U);
    value = ((value >> 4U) & 0x0F0F0F0FU) | ((value & 0x0F0F0F0FU) << 4U);
    value = ((value >> 8U) & 0x00FF00FFU) | ((value & 0x00FF00FFU) << 8U);
    return (value >> 16U) | (value << 16U);
}

/// Coordinate `dimension` of point `index`, shifted by `shift` / 2^32 modulo 1 (R. Cranley and T.
/// Patterson, SIAM J. Numer. Anal. 13(6), 1976).
[[nodiscard]] constexpr double latticePoint(std::uint32_t index, std::size_t dimension,
                                            std::uint32_t shift) {
    const std::uint32_t bits = reversedBits(index) * kGenerator[dimension] + shift;
    return static_cast<double>(bits) * 0x1p-32;
}

/// Mixes all bits of a number (the finaliser "lowbias32" of C. Wellons's search, 2018).
[[nodiscard]] constexpr std::uint32_t mixed(std::uint32_t value) {
    value = (value ^ (value >> 16U)) * 0x7feb352dU;
    value = (value ^ (value >> 15U)) * 0x846ca68bU;
    return value ^ (value >> 16U);
}

}  // namespace ticker::oracle

#endif

#ifndef RAYTRACER_SRC_SCENE_PAIR_H
#define RAYTRACER_SRC_SCENE_PAIR_H

#include <cstddef>
#include <cstdint>

#if !defined(__GNUC__)
#include <array>
#endif

namespace raytracer {

#if defined(__GNUC__)

// GCC and Clang compile arithmetic on these to SIMD instructions (SSE2, NEON), with the same
// results as arithmetic on single doubles.
using Pair = double __attribute__((vector_size(16)));
using BitsOfPair = std::int64_t __attribute__((vector_size(16)));

#else

/// The same arithmetic for other compilers, one number after the other.
template <typename Number>
struct TwoNumbers {
    std::array<Number, 2> numbers;

    constexpr Number& operator[](std::size_t i) { return numbers[i]; }
    constexpr Number operator[](std::size_t i) const { return numbers[i]; }

    friend TwoNumbers operator+(TwoNumbers a, TwoNumbers b) { return {{a[0] + b[0], a[1] + b[1]}}; }
    friend TwoNumbers operator-(TwoNumbers a, TwoNumbers b) { return {{a[0] - b[0], a[1] - b[1]}}; }
    friend TwoNumbers operator*(TwoNumbers a, TwoNumbers b) { return {{a[0] * b[0], a[1] * b[1]}}; }
    friend TwoNumbers operator-(TwoNumbers a, Number b) { return {{a[0] - b, a[1] - b}}; }
    friend TwoNumbers operator*(TwoNumbers a, Number b) { return {{a[0] * b, a[1] * b}}; }
    friend TwoNumbers operator*(Number a, TwoNumbers b) { return {{a * b[0], a * b[1]}}; }
    friend TwoNumbers operator|(TwoNumbers a, TwoNumbers b) { return {{a[0] | b[0], a[1] | b[1]}}; }
    friend TwoNumbers operator&(TwoNumbers a, TwoNumbers b) { return {{a[0] & b[0], a[1] & b[1]}}; }
    friend TwoNumbers operator~(TwoNumbers a) { return {{~a[0], ~a[1]}}; }
};

using Pair = TwoNumbers<double>;
using BitsOfPair = TwoNumbers<std::int64_t>;

#endif

}  // namespace raytracer

#endif

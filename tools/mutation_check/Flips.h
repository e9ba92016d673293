#ifndef TICKER_TOOLS_MUTATION_CHECK_FLIPS_H
#define TICKER_TOOLS_MUTATION_CHECK_FLIPS_H

// What mutation_check writes into the sources: every flip is a switch, so that one build has all of
// them. The environment variable FLIP holds the number of the one that is on. At its end a process
// adds the numbers that it came across to the file FLIPS_SEEN, if that is set.

#include <array>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <type_traits>

#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wunused-variable"

namespace flips {

inline constexpr std::size_t kMost = 20000;

class Switches {
public:
    Switches() {
        const char* number = std::getenv("FLIP");
        if (number != nullptr) on_ = std::atoi(number);
    }
    ~Switches() {
        const char* file = std::getenv("FLIPS_SEEN");
        if (file == nullptr) return;
        std::ofstream stream{file, std::ios::app};
        for (std::size_t flip = 0; flip < seen_.size(); ++flip)
            if (const int seen = seen_[flip]; seen != 0)
                stream << flip << (seen > 1 ? " none" : "") << '\n';
    }
    Switches(const Switches&) = delete;
    Switches& operator=(const Switches&) = delete;

    bool isOn(int flip) {
        seen_[static_cast<std::size_t>(flip)].store(1, std::memory_order_relaxed);
        return flip == on_;
    }
    // Marks a flip that has nothing to exchange; such flips are not tried.
    void leaveOut(int flip) {
        seen_[static_cast<std::size_t>(flip)].store(2, std::memory_order_relaxed);
    }

private:
    int on_ = -1;
    std::array<std::atomic<char>, kMost> seen_{};
};

// Made at its first use, which may be during the initialisation of static objects.
inline Switches& switches() {
    static Switches all;
    return all;
}

constexpr bool isOn(int flip) {
    return !std::is_constant_evaluated() && switches().isOn(flip);
}

/// Stands between two equal operators, `a < Flip{7} < b`, which keeps the precedence.
struct Flip {
    int number;
};

template <typename A>
struct Left {
    const A& a;
    int number;
};

// Whether A + B and A - B have the same type, so that one can replace the other. Other pairs stay
// as they are.
template <typename A, typename B>
constexpr bool kBothSigns = requires(const A& a, const B& b) {
    requires std::is_same_v<decltype(a + b), decltype(a - b)>;
};

#define TICKER_COMPARISON(OP, OTHER)                             \
    template <typename A>                                        \
    constexpr Left<A> operator OP(const A& a, Flip flip) {       \
        return {a, flip.number};                                 \
    }                                                            \
    template <typename A, typename B>                            \
    constexpr bool operator OP(Left<A> left, const B& b) {       \
        return isOn(left.number) ? left.a OTHER b : left.a OP b; \
    }
TICKER_COMPARISON(<, >=)
TICKER_COMPARISON(>, <=)
TICKER_COMPARISON(<=, >)
TICKER_COMPARISON(>=, <)
TICKER_COMPARISON(==, !=)
TICKER_COMPARISON(!=, ==)
#undef TICKER_COMPARISON

#define TICKER_SUM(OP, OTHER)                                                     \
    template <typename A>                                                         \
    constexpr Left<A> operator OP(const A& a, Flip flip) {                        \
        return {a, flip.number};                                                  \
    }                                                                             \
    template <typename A, typename B>                                             \
    constexpr auto operator OP(Left<A> left, const B& b)->decltype(left.a OP b) { \
        if constexpr (kBothSigns<A, B>) {                                         \
            if (isOn(left.number)) return left.a OTHER b;                         \
        } else if (!std::is_constant_evaluated()) {                               \
            switches().leaveOut(left.number);                                     \
        }                                                                         \
        return left.a OP b;                                                       \
    }
TICKER_SUM(+, -)
TICKER_SUM(-, +)
#undef TICKER_SUM

/// `value`, or if the flip is on ten times as much; 1 in place of 0.
inline double constant(int flip, double value) {
    if (!isOn(flip)) return value;
    return value == 0.0 ? 1.0 : 10.0 * value;
}

}  // namespace flips

#endif

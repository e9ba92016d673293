// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_SUMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_SUMS_INL_H
#undef TICKER_ORACLE_SUMS_INL_H
#else
#define TICKER_ORACLE_SUMS_INL_H
#endif

#include <grader/oracle/kernel/Kernel.h>
#include <grader/oracle/kernel/Vec3-inl.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

HWY_INLINE double total(VF value) {
    return double{hn::GetLane(hn::SumOfLanes(F(), value))};
}

HWY_INLINE Vec3 colourAt(const std::array<Lanes<float>, 3>& from, std::size_t at) {
    return {load(from[0], at), load(from[1], at), load(from[2], at)};
}

/// Sums of the colours of paths [first, end).
inline std::array<double, 3> coloursHere(const Workspace& work, std::size_t first,
                                         std::size_t end) {
    Vec3 sum = all3(0.0F, 0.0F, 0.0F);
    for (std::size_t at = first; at < end; at += width()) {
        const MF used = hn::FirstN(F(), end - at);
        sum = sum + select(used, colourAt(work.colour, at), all3(0.0F, 0.0F, 0.0F));
    }
    return {total(sum.x), total(sum.y), total(sum.z)};
}

/// Sums for moments, over paths [first, end). Colours are taken relative to the first one, so that
/// the squares do not lose digits by cancellation.
inline PathSums sumsHere(const Workspace& work, std::size_t first, std::size_t end, bool paired) {
    const auto& others = paired ? work.pairedColour : work.colour;
    const Vec3 pivot = all3(work.colour[0][first], work.colour[1][first], work.colour[2][first]);
    const Vec3 none = all3(0.0F, 0.0F, 0.0F);
    const VF zero = hn::Zero(F());
    Vec3 mean = none;
    VF second[6] = {zero, zero, zero, zero, zero, zero};
    VF noise[6] = {zero, zero, zero, zero, zero, zero};
    for (std::size_t at = first; at < end; at += width()) {
        const MF used = hn::FirstN(F(), end - at);
        const Vec3 a = select(used, colourAt(work.colour, at) - pivot, none);
        const Vec3 b = select(used, colourAt(others, at) - pivot, none);
        mean = mean + a + b;
        const VF products[6] = {hn::Mul(a.x, b.x),
                                hn::Mul(a.y, b.y),
                                hn::Mul(a.z, b.z),
                                hn::MulAdd(a.x, b.y, hn::Mul(a.y, b.x)),
                                hn::MulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
                                hn::MulAdd(a.y, b.z, hn::Mul(a.z, b.y))};
        for (std::size_t i = 0; i < 6; ++i) {
            second[i] = hn::Add(second[i], products[i]);
            if (paired)
                noise[i] = hn::Add(noise[i], hn::IfThenElseZero(used, load(work.noise[i], at)));
        }
    }
    PathSums sums;
    for (std::size_t c = 0; c < 3; ++c)
        sums.pivot[c] = double{work.colour[c][first]};
    sums.mean = {0.5 * total(mean.x), 0.5 * total(mean.y), 0.5 * total(mean.z)};
    for (std::size_t i = 0; i < 6; ++i) {
        sums.second[i] = (i < 3 ? 1.0 : 0.5) * total(second[i]);
        sums.noise[i] = total(noise[i]);
    }
    return sums;
}

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_VEC3_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_VEC3_INL_H
#undef TICKER_ORACLE_VEC3_INL_H
#else
#define TICKER_ORACLE_VEC3_INL_H
#endif

#include <grader/oracle/kernel/Workspace.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using U = hn::RebindToUnsigned<F>;
using I = hn::RebindToSigned<F>;
using VF = hn::Vec<F>;
using VU = hn::Vec<U>;
using VI = hn::Vec<I>;
using MF = hn::Mask<F>;

/// Number of lanes of a vector on this instruction set.
inline std::size_t width() {
    return hn::Lanes(F());
}

/// A 3-vector in each lane.
struct Vec3 {
    VF x, y, z;
};

HWY_INLINE VF all(float value) {
    return hn::Set(F(), value);
}
HWY_INLINE Vec3 all3(float x, float y, float z) {
    return {all(x), all(y), all(z)};
}
HWY_INLINE Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vec3 operator*(const Vec3& a, VF scale) {
    return {hn::Mul(a.x, scale), hn::Mul(a.y, scale), hn::Mul(a.z, scale)};
}
/// start + along * distance
HWY_INLINE Vec3 moved(const Vec3& start, const Vec3& along, VF distance) {
    return {hn::MulAdd(along.x, distance, start.x), hn::MulAdd(along.y, distance, start.y),
            hn::MulAdd(along.z, distance, start.z)};
}
HWY_INLINE VF dot(const Vec3& a, const Vec3& b) {
    return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}
HWY_INLINE Vec3 cross(const Vec3& a, const Vec3& b) {
    return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
            hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
HWY_INLINE VF squared(const Vec3& a) {
    return dot(a, a);
}
HWY_INLINE VF squared(VF a) {
    return hn::Mul(a, a);
}
/// 1 / sqrt(a): the processor's estimate and one Newton step (relative error below 4e-7 for
/// estimates of 12 bits or more).
HWY_INLINE VF inverseRoot(VF a) {
    const VF guess = hn::ApproximateReciprocalSqrt(a);
    const VF half = hn::Mul(all(0.5F), hn::Mul(a, guess));
    return hn::Mul(guess, hn::NegMulAdd(half, guess, all(1.5F)));
}
/// 1 / a, by the same method.
HWY_INLINE VF inverse(VF a) {
    const VF guess = hn::ApproximateReciprocal(a);
    return hn::Mul(guess, hn::NegMulAdd(a, guess, all(2.0F)));
}
HWY_INLINE Vec3 normalised(const Vec3& a) {
    return a * inverseRoot(squared(a));
}
HWY_INLINE Vec3 select(MF mask, const Vec3& yes, const Vec3& no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
            hn::IfThenElse(mask, yes.z, no.z)};
}
HWY_INLINE VF positive(VF a) {
    return hn::Max(a, hn::Zero(F()));
}

HWY_INLINE VF load(const Lanes<float>& from, std::size_t at) {
    return hn::LoadU(F(), from.data() + at);
}
HWY_INLINE VI load(const Lanes<std::int32_t>& from, std::size_t at) {
    return hn::LoadU(I(), from.data() + at);
}
HWY_INLINE VU load(const Lanes<std::uint32_t>& from, std::size_t at) {
    return hn::LoadU(U(), from.data() + at);
}
HWY_INLINE Vec3 load(const Lanes3& from, std::size_t at) {
    return {load(from.x, at), load(from.y, at), load(from.z, at)};
}
HWY_INLINE void store(VF value, Lanes<float>& to, std::size_t at) {
    hn::StoreU(value, F(), to.data() + at);
}
HWY_INLINE void store(VI value, Lanes<std::int32_t>& to, std::size_t at) {
    hn::StoreU(value, I(), to.data() + at);
}
HWY_INLINE void store(const Vec3& value, Lanes3& to, std::size_t at) {
    store(value.x, to.x, at);
    store(value.y, to.y, at);
    store(value.z, to.z, at);
}

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

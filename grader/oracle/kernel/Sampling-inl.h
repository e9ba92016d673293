// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_SAMPLING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_SAMPLING_INL_H
#undef TICKER_ORACLE_SAMPLING_INL_H
#else
#define TICKER_ORACLE_SAMPLING_INL_H
#endif

#include <grader/oracle/kernel/Kernel.h>
#include <grader/oracle/kernel/Lattice.h>
#include <grader/oracle/kernel/Vec3-inl.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

/// A number in [0, 1) from the upper 23 bits.
HWY_INLINE VF unit(VU bits) {
    const VU one = hn::Set(U(), 0x3F800000U);
    return hn::Sub(hn::BitCast(F(), hn::Or(hn::ShiftRight<9>(bits), one)), all(1.0F));
}

/// The hash of Lattice.h, on vectors.
HWY_INLINE VU mixed(VU value) {
    value = hn::Mul(hn::Xor(value, hn::ShiftRight<16>(value)), hn::Set(U(), 0x7feb352dU));
    value = hn::Mul(hn::Xor(value, hn::ShiftRight<15>(value)), hn::Set(U(), 0x846ca68bU));
    return hn::Xor(value, hn::ShiftRight<16>(value));
}

template <int kBits>
HWY_INLINE VU swapped(VU value, std::uint32_t mask) {
    const VU low = hn::Set(U(), mask);
    return hn::Or(hn::And(hn::ShiftRight<kBits>(value), low),
                  hn::ShiftLeft<kBits>(hn::And(value, low)));
}
HWY_INLINE VU reversedBits(VU value) {
    value = swapped<1>(value, 0x55555555U);
    value = swapped<2>(value, 0x33333333U);
    value = swapped<4>(value, 0x0F0F0F0FU);
    value = swapped<8>(value, 0x00FF00FFU);
    return hn::Or(hn::ShiftRight<16>(value), hn::ShiftLeft<16>(value));
}

/// Sample numbers in [0, 1) computed from a path's own numbers, so that they do not depend on the
/// lane or vector of the path: lattice points with a shift for each pixel, or plain hashes.
class PathNumbers {
public:
    PathNumbers(const Workspace& work, bool lattice) : work_(work), lattice_(lattice) {}

    /// Input from which the sample numbers of one vector of paths are computed.
    struct Own {
        VU sample, randomisation;
    };
    HWY_INLINE Own from(std::size_t at) const {
        return {load(work_.sample, at), load(work_.randomisation, at)};
    }
    HWY_INLINE Own of(VU slot) const {
        const VI where = hn::BitCast(I(), slot);
        return {hn::GatherIndex(U(), work_.sample.data(), where),
                hn::GatherIndex(U(), work_.randomisation.data(), where)};
    }

    HWY_INLINE VF at(const Own& own, std::size_t dimension) const {
        const auto number = static_cast<std::uint32_t>(dimension);
        const VU shift = mixed(hn::Add(own.randomisation, hn::Set(U(), number * 0x9E3779B9U)));
        if (!lattice_ || dimension >= kGenerator.size())
            return unit(mixed(hn::Add(shift, own.sample)));
        const VU point = hn::Mul(reversedBits(own.sample), hn::Set(U(), kGenerator[dimension]));
        return tent(unit(hn::Add(point, shift)));
    }

private:
    // Baker's (tent) transform: makes every smooth function periodic, which lattice rules integrate
    // best (F. Hickernell, "Obtaining O(N^(-2+e)) Convergence for Lattice Quadrature Rules", 2002).
    static HWY_INLINE VF tent(VF value) {
        return hn::Min(hn::Add(value, value), hn::Sub(all(2.0F), hn::Add(value, value)));
    }

    const Workspace& work_;
    bool lattice_;
};

/// Marsaglia's xorshift (J. Stat. Softw. 8(14), 2003), one generator in each lane.
class LaneGenerator {
public:
    explicit LaneGenerator(LaneSeeds& seeds)
        : seeds_(seeds), state_(hn::LoadU(U(), seeds.lane.data())), common_(seeds.common) {}
    ~LaneGenerator() {
        hn::StoreU(state_, U(), seeds_.lane.data());
        seeds_.common = common_;
    }
    LaneGenerator(const LaneGenerator&) = delete;
    LaneGenerator& operator=(const LaneGenerator&) = delete;

    HWY_INLINE VU bits() {
        state_ = hn::Xor(state_, hn::ShiftLeft<13>(state_));
        state_ = hn::Xor(state_, hn::ShiftRight<17>(state_));
        state_ = hn::Xor(state_, hn::ShiftLeft<5>(state_));
        return state_;
    }
    /// One random number, the same in all lanes, below 2^32.
    HWY_INLINE std::uint32_t commonBits() {
        common_ = common_ * 6364136223846793005U + 1442695040888963407U;
        return static_cast<std::uint32_t>(common_ >> 32U);
    }

private:
    LaneSeeds& seeds_;
    VU state_;
    std::uint64_t common_;
};

/// sin and cos of 2 pi t for t in [0, 1), from Taylor polynomials on a quarter turn (error below
/// 1e-6).
HWY_INLINE VF sineOfQuarter(VF turn) {
    const VF x = hn::Mul(turn, all(6.28318531F));
    const VF y = hn::Mul(x, x);
    VF sum = all(-2.50521084e-8F);
    sum = hn::MulAdd(sum, y, all(2.75573192e-6F));
    sum = hn::MulAdd(sum, y, all(-1.98412698e-4F));
    sum = hn::MulAdd(sum, y, all(8.33333333e-3F));
    sum = hn::MulAdd(sum, y, all(-1.66666667e-1F));
    return hn::MulAdd(hn::Mul(sum, y), x, x);
}
HWY_INLINE VF cosineOfTurn(VF turn) {
    return sineOfQuarter(hn::Sub(hn::Abs(hn::Sub(turn, all(0.5F))), all(0.25F)));
}
HWY_INLINE VF sineOfTurn(VF turn) {
    const VF half = hn::Sub(all(0.5F), turn);  // sin(2 pi t) = sin(2 pi (1/2 - t))
    const VF folded = hn::Min(hn::Abs(half), hn::Sub(all(0.5F), hn::Abs(half)));
    return hn::CopySign(sineOfQuarter(folded), half);
}

/// Cube root of u in [0, 1]: a first guess from the exponent, then three Newton steps.
HWY_INLINE VF cubeRoot(VF u) {
    const VF safe = hn::Max(u, all(1e-12F));
    const VI third =
        hn::ConvertTo(I(), hn::Mul(hn::ConvertTo(F(), hn::BitCast(I(), safe)), all(1.0F / 3.0F)));
    VF root = hn::BitCast(F(), hn::Add(third, hn::Set(I(), 0x2A514067)));
    for (int i = 0; i < 3; ++i)
        root = hn::Mul(all(1.0F / 3.0F),
                       hn::MulAdd(all(2.0F), root, hn::Div(safe, hn::Mul(root, root))));
    return root;
}

/// The functions of BallPool.cpp with the same names, on vectors.
HWY_INLINE Vec3 onSphere(VF radius, VF height, VF turn) {
    const VF across = hn::Mul(radius, hn::Sqrt(positive(hn::NegMulAdd(height, height, all(1.0F)))));
    return {hn::Mul(across, cosineOfTurn(turn)), hn::Mul(across, sineOfTurn(turn)),
            hn::Mul(radius, height)};
}
HWY_INLINE Vec3 aimPoint(LightShape shape, VF u, VF v, VF w) {
    const VF around = hn::MulSub(all(2.0F), v, all(1.0F));
    switch (shape) {
        case LightShape::ball:
            return onSphere(cubeRoot(u), around, w);
        case LightShape::surface:
            return onSphere(all(1.0F), around, w);
        case LightShape::uniformRadius:
            return onSphere(u, around, w);
        case LightShape::polarHelper:
            return onSphere(u, cosineOfTurn(hn::Mul(all(0.5F), v)), w);
        case LightShape::cube:
            return {hn::MulSub(all(2.0F), u, all(1.0F)), around,
                    hn::MulSub(all(2.0F), w, all(1.0F))};
        case LightShape::disc:
            return onSphere(hn::Sqrt(u), hn::Zero(F()), w);
        case LightShape::halfBall: {
            const Vec3 point = onSphere(cubeRoot(u), v, w);
            return {point.x, point.z, point.y};
        }
        case LightShape::centre:
            break;
    }
    return all3(0.0F, 0.0F, 0.0F);
}

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

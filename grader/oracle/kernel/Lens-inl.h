// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_LENS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_LENS_INL_H
#undef TICKER_ORACLE_LENS_INL_H
#else
#define TICKER_ORACLE_LENS_INL_H
#endif

#include <grader/oracle/Setup.h>
#include <grader/oracle/kernel/Kernel.h>
#include <grader/oracle/kernel/Sampling-inl.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

struct Vec2 {
    VF x, y;
};

/// Maps two numbers in [0, 1) to a point of the lens.
HWY_INLINE Vec2 lensPoint(const Setup& setup, VF u, VF v) {
    const VF one = all(1.0F);
    Vec2 point{hn::MulSub(all(2.0F), u, one), hn::MulSub(all(2.0F), v, one)};
    switch (setup.mistake.aperture) {
        case Mistake::Aperture::disc: {
            const VF radius = hn::Sqrt(u);
            point = {hn::Mul(radius, cosineOfTurn(v)), hn::Mul(radius, sineOfTurn(v))};
            break;
        }
        case Mistake::Aperture::horizontal:
            point.y = hn::Zero(F());
            break;
        case Mistake::Aperture::diagonal:
            point.y = point.x;
            break;
        case Mistake::Aperture::square:
        case Mistake::Aperture::none:
            break;
    }
    return {hn::MulAdd(point.x, all(setup.lensHalf), all(setup.lensOffsetX)),
            hn::MulAdd(point.y, all(setup.lensHalf), all(setup.lensOffsetY))};
}

/// Maps two numbers in [0, 1) to a place in a pixel, in pixels from its middle.
HWY_INLINE Vec2 pixelPlace(const Setup& setup, VF u, VF v) {
    const VF half = all(0.5F);
    return {hn::Mul(hn::Sub(u, half), all(setup.pixelSpread)),
            hn::Mul(hn::Sub(v, half), all(setup.pixelSpread))};
}

/// Lens points of student renders.
class StudentLens {
public:
    StudentLens(const Setup& setup, LaneGenerator& generator, const LaneSeeds& seeds)
        : setup_(setup), generator_(generator), frameLens_(seeds.frameLens) {}

    HWY_INLINE Vec2 point(std::size_t /*at*/) {
        if (setup_.mistake.lensSharedByFrame)
            return lensPoint(setup_, all(frameLens_[0]), all(frameLens_[1]));
        const VF u = unit(generator_.bits());
        const VF v = unit(generator_.bits());
        return lensPoint(setup_, u, v);
    }
    HWY_INLINE Vec2 place(std::size_t /*at*/) {
        const VF u = unit(generator_.bits());
        const VF v = unit(generator_.bits());
        return pixelPlace(setup_, u, v);
    }

private:
    const Setup& setup_;
    LaneGenerator& generator_;
    std::array<float, 2> frameLens_;
};

/// Lens points for moments, computed from the numbers of each path.
class NumberedLens {
public:
    NumberedLens(const Setup& setup, const PathNumbers& numbers)
        : setup_(setup), numbers_(numbers) {}

    HWY_INLINE Vec2 point(std::size_t at) {
        const PathNumbers::Own own = numbers_.from(at);
        const VF u = numbers_.at(own, 0);
        const VF v = numbers_.at(own, 1);
        return lensPoint(setup_, u, v);
    }
    HWY_INLINE Vec2 place(std::size_t at) {
        const PathNumbers::Own own = numbers_.from(at);
        const VF u = numbers_.at(own, 2);
        const VF v = numbers_.at(own, 3);
        return pixelPlace(setup_, u, v);
    }

private:
    const Setup& setup_;
    const PathNumbers& numbers_;
};

/// Starts one vector of paths: from the lens, through the point where the pixel's pinhole ray meets
/// the focal plane, or beside it (`pixelSpread`).
template <typename Lens>
HWY_INLINE void beginVector(const Setup& setup, Lens& lens, std::size_t at, bool paired,
                            Workspace& work) {
    const VF zero = hn::Zero(F());
    const VF one = all(1.0F);
    VF x = hn::ConvertTo(F(), load(work.column, at));
    VF y = hn::ConvertTo(F(), load(work.row, at));
    if (setup.pixelSpread > 0.0F) {
        const Vec2 place = lens.place(at);
        x = hn::Add(x, place.x);
        y = hn::Add(y, place.y);
    }
    const Vec3 towards{hn::MulAdd(x, all(setup.pitch), all(setup.leftmost)),
                       hn::NegMulAdd(y, all(setup.pitch), all(setup.topmost)), one};
    const VF scale = setup.mistake.focalByDistance ? inverseRoot(squared(towards)) : one;
    const Vec3 focalPoint = towards * hn::Mul(scale, all(setup.focal));
    const Vec2 start = lens.point(at);
    const Vec3 origin{start.x, start.y, zero};
    store(origin, work.origin, at);
    store(normalised(focalPoint - origin), work.direction, at);

    const MF used = hn::FirstN(F(), work.paths - at);
    store(hn::IfThenElseZero(used, one), work.weight, at);
    store(hn::Set(I(), -1), work.object, at);
    store(zero, work.clearance, at);
    for (Lanes<float>& channel : work.colour)
        store(zero, channel, at);
    if (!paired) return;
    for (Lanes<float>& channel : work.pairedColour)
        store(zero, channel, at);
    for (Lanes<float>& entry : work.noise)
        store(zero, entry, at);
}

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

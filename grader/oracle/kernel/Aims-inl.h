// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_AIMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_AIMS_INL_H
#undef TICKER_ORACLE_AIMS_INL_H
#else
#define TICKER_ORACLE_AIMS_INL_H
#endif

#include <grader/oracle/kernel/Cones-inl.h>
#include <grader/oracle/kernel/Sampling-inl.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

/// The ball that shadow rays from `start` aim at.
HWY_INLINE Aim aimAt(const Setup& setup, const SceneSoA::Light& light, const Vec3& start) {
    const float x = light.position[0] + setup.aimOffset[0];
    const float y = light.position[1] + setup.aimOffset[1];
    const float z = light.position[2] + setup.aimOffset[2];
    Aim aim;
    aim.centre = all3(x, y, z) - start;
    const VF distance2 = squared(aim.centre);
    aim.inverseDistance = inverseRoot(distance2);
    aim.distance = hn::Mul(distance2, aim.inverseDistance);
    // An offset added to the unit direction acts like a ball whose radius grows with the distance.
    aim.spread = setup.mistake.directionOffset ? aim.distance : all(1.0F);
    aim.bound = hn::Mul(aim.spread, all(setup.aimBound));
    aim.reach = setup.reading.shadowReach == ShadowReach::endless
                    ? all(kNowhere)
                    : hn::Add(aim.distance, aim.bound);
    return aim;
}

/// Longest distance at which objects cast shadows along a ray, in lengths of the ray's direction.
/// @param length2         Squared length of that direction.
/// @param centreDistance  Of the light's centre from the lit point, or from the start just above
///                        it.
HWY_INLINE VF reachOf(const Setup& setup, VF length2, VF centreDistance) {
    switch (setup.reading.shadowReach) {
        case ShadowReach::toCentre:
            return hn::Mul(centreDistance, inverseRoot(length2));
        case ShadowReach::endless:
            return all(kNowhere);
        case ShadowReach::toSample:
            break;
    }
    return all(1.0F);
}

/// Aim points of student renders, from the pool: all lanes read the same row, with random signs for
/// each lane.
class PoolAims {
public:
    PoolAims(const Setup& setup, LaneGenerator& generator)
        : pool_(setup.pool), generator_(generator) {}

    HWY_INLINE void begin(VU /*slot*/, std::size_t /*light*/, std::size_t /*depth*/) {}

    /// Point number `i` of the present hit, relative to the aim's centre, scaled by the light's
    /// radius.
    HWY_INLINE Vec3 point(std::size_t i) {
        constexpr std::size_t kSignsInWord = 10;
        constexpr std::uint32_t kRows = BallPool::kSize / BallPool::kRow;
        if (i % kSignsInWord == 0) signs_ = generator_.bits();
        const std::size_t at = generator_.commonBits() % kRows * BallPool::kRow;
        const Vec3 point{flipped(pool_.x, at, pool_.flipX), flipped(pool_.y, at, pool_.flipY),
                         flipped(pool_.z, at, pool_.flipZ)};
        return point;
    }

private:
    HWY_INLINE VF flipped(const std::vector<float>& from, std::size_t at, std::uint32_t flip) {
        const VU value = hn::BitCast(U(), hn::LoadU(F(), from.data() + at));
        const VU result = hn::Xor(value, hn::And(signs_, hn::Set(U(), flip)));
        signs_ = hn::ShiftLeft<1>(signs_);
        return hn::BitCast(F(), result);
    }

    const BallPool& pool_;
    LaneGenerator& generator_;
    VU signs_ = hn::Zero(U());
};

/// Aim points for moments, computed from the numbers of each path.
class NumberedAims {
public:
    /// @param paired  Two points for each hit and light, which use the lattice's own dimensions;
    ///                otherwise `shadowRays` points, which use the dimensions after those.
    NumberedAims(const Setup& setup, const PathNumbers& numbers, bool paired)
        : setup_(setup), numbers_(numbers), paired_(paired) {}

    HWY_INLINE void begin(VU slot, std::size_t light, std::size_t depth) {
        own_ = numbers_.of(slot);
        const std::size_t hit = depth * setup_.scene.lights.size() + light;
        const auto rays = static_cast<std::size_t>(paired_ ? 2 : setup_.shadowRays);
        dimension_ = (paired_ ? setup_.lensDimensions : kGenerator.size()) + 3 * rays * hit;
    }

    HWY_INLINE Vec3 point(std::size_t i) {
        const std::size_t first = dimension_ + 3 * i;
        const VF u = numbers_.at(own_, first);
        const VF v = numbers_.at(own_, first + 1);
        const VF w = numbers_.at(own_, first + 2);
        return aimPoint(setup_.reading.lightShape, u, v, w) * all(setup_.lightRadius);
    }

private:
    const Setup& setup_;
    const PathNumbers& numbers_;
    bool paired_;
    PathNumbers::Own own_{hn::Zero(U()), hn::Zero(U())};
    std::size_t dimension_ = 0;
};

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_CONES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_CONES_INL_H
#undef TICKER_ORACLE_CONES_INL_H
#else
#define TICKER_ORACLE_CONES_INL_H
#endif

#include <grader/oracle/Setup.h>
#include <grader/oracle/kernel/Intersect-inl.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

/// The ball that a point's shadow rays aim into. Seen from the start of the rays it is a cone.
struct Aim {
    Vec3 centre;  ///< relative to the start
    VF distance;
    VF inverseDistance;
    VF spread;  ///< aim points are drawn around the centre and scaled by this
    VF bound;   ///< no aim point is farther from the centre
    VF reach;   ///< objects shade up to this distance at most
};

/// Result of the cone tests for one point and one light, one bit for each object.
struct Occluders {
    MF shaded;        ///< one object hides the whole ball
    VU nearSpheres;   ///< may shade; nearer than every aim point, so that distances need no test
    VU otherSpheres;  ///< may shade
    VU planes;        ///< may shade
};

/// Bit of an object in `Occluders`; objects with the index 31 or more share the last bit.
HWY_INLINE std::uint32_t bitOf(std::size_t object) {
    return 1U << (object < 31 ? object : 31);
}

HWY_INLINE VU marked(MF mask, std::size_t object) {
    return hn::IfThenElseZero(hn::RebindMask(U(), mask), hn::Set(U(), bitOf(object)));
}

/// Angles seen from the start: a is the ball's half-angle, b the sphere's, g lies between their
/// centres. Some ray may hit the sphere only if g < a + b; every ray does if g + a < b. Squared
/// distances across and along the axis decide the same without computing angles. All tests are
/// conservative by `kSlack`, far more than the rounding of single precision.
class SphereTest {
public:
    explicit SphereTest(const Aim& aim)
        : aim_(aim),
          axis_(aim.centre * aim.inverseDistance),
          sine_(hn::Min(hn::Mul(aim.bound, aim.inverseDistance), all(1.0F))),
          sine2_(squared(sine_)),
          cosine2_(hn::Sub(all(1.0F), sine2_)),
          tube_(hn::Mul(aim.reach, sine_)) {}

    HWY_INLINE void look(const SceneSoA& scene, std::size_t sphere, const Start& start,
                         Occluders& found) const {
        const VF zero = hn::Zero(F());
        const VF radius = all(scene.spheres.radius[sphere]);
        const VF wider = all(scene.spheres.radius[sphere] * (1.0F + kSlack) + kSlack);
        const Vec3 toCentre = centreOf(scene, sphere) - start.point;
        const VF along = dot(toCentre, axis_);
        if (hn::AllFalse(F(), reachesTube(toCentre, along, wider))) return;

        const VF power = powerOf(scene, sphere, toCentre, start);
        const VF distance2 = hn::MulAdd(radius, radius, power);
        const VF along2 = squared(along);
        const VF across2 = hn::Max(hn::Sub(distance2, along2), zero);
        const VF aside2 = hn::Mul(across2, cosine2_);
        const VF spread2 = hn::Mul(distance2, sine2_);

        const MF ahead =
            hn::Or(hn::Ge(along, zero),
                   hn::Le(along2, hn::MulAdd(spread2, all(1.0F + kSlack), all(kSlack))));
        const MF beside = hn::Le(aside2, squared(hn::MulAdd(along, sine_, wider)));
        const MF within = hn::Lt(distance2, squared(hn::Add(aim_.reach, wider)));
        const MF inside = hn::Le(power, zero);
        const MF may = hn::Or(inside, hn::And(hn::And(ahead, beside), within));
        if (hn::AllFalse(F(), may)) return;

        const VF nearest = hn::Sub(aim_.distance, aim_.bound);
        const MF nearer = hn::AndNot(
            inside, hn::And(hn::Gt(nearest, zero),
                            hn::Lt(hn::Mul(distance2, all(1.0F + kSlack)), squared(nearest))));
        const VF inner =
            hn::Sub(all(scene.spheres.radius[sphere] * (1.0F - kSlack)), hn::Mul(along, sine_));
        const MF covered = hn::And(hn::And(hn::Gt(inner, zero), hn::Lt(aside2, squared(inner))),
                                   hn::And(hn::Gt(along, zero), hn::Gt(hn::Mul(along2, cosine2_),
                                                                       hn::Mul(across2, sine2_))));
        const MF whole = hn::And(hn::And(may, nearer), covered);
        found.shaded = hn::Or(found.shaded, whole);
        found.nearSpheres = hn::Or(found.nearSpheres, marked(hn::And(may, nearer), sphere));
        found.otherSpheres = hn::Or(found.otherSpheres, marked(hn::AndNot(nearer, may), sphere));
    }

private:
    static constexpr float kSlack = 1e-4F;

    /// Whether a sphere reaches the tube around the cone's axis that is as wide as the cone at the
    /// farthest distance where objects shade. This takes half of the operations of the cone's own
    /// test, and is enough for most spheres.
    HWY_INLINE MF reachesTube(const Vec3& toCentre, VF along, VF wider) const {
        const VF across2 = hn::NegMulAdd(along, along, squared(toCentre));
        return hn::And(hn::Le(across2, squared(hn::Add(tube_, wider))),
                       hn::Ge(hn::Add(along, wider), hn::Zero(F())));
    }

    const Aim& aim_;
    Vec3 axis_;
    VF sine_, sine2_, cosine2_;
    VF tube_;  ///< radius of the tube around all rays
};

/// A plane may shade unless the ball and the start lie wholly on the same side of it.
HWY_INLINE void lookAtPlane(const SceneSoA& scene, std::size_t plane, const Start& start,
                            const Aim& aim, bool endless, Occluders& found) {
    constexpr float kSlack = 1e-4F;
    const Vec3 normal = all3(scene.planes.x[plane], scene.planes.y[plane], scene.planes.z[plane]);
    const VF height = heightAbove(scene, plane, start);
    const VF rise = dot(normal, aim.centre);
    // Heights of the ball's centre above the plane, positive on the start's side.
    const VF aimHeight =
        endless ? hn::CopySign(rise, hn::Xor(rise, height))
                : hn::CopySign(hn::Add(height, rise), hn::Xor(hn::Add(height, rise), height));
    const VF bound = hn::MulAdd(aim.bound, all(1.0F + kSlack), all(kSlack));
    const MF may = hn::Lt(aimHeight, bound);
    // Twice the radius: then the plane is nearer than the light's centre on every ray, too.
    const MF whole = hn::Lt(aimHeight, hn::Mul(all(-2.0F), bound));
    found.shaded = hn::Or(found.shaded, whole);
    found.planes = hn::Or(found.planes, marked(may, plane));
}

HWY_INLINE Occluders lookForOccluders(const Setup& setup, const Start& start, const Aim& aim) {
    const SceneSoA& scene = setup.scene;
    Occluders found{hn::MaskFromVec(hn::Zero(F())), hn::Zero(U()), hn::Zero(U()), hn::Zero(U())};
    if (!setup.conesHold) {
        found.otherSpheres = hn::Set(U(), 0xFFFFFFFFU);
        found.planes = found.otherSpheres;
        return found;
    }
    const SphereTest test{aim};
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        test.look(scene, i, start, found);
    const bool endless = setup.reading.shadowReach == ShadowReach::endless;
    for (std::size_t i = 0; i < scene.planes.size(); ++i)
        lookAtPlane(scene, i, start, aim, endless, found);
    return found;
}

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

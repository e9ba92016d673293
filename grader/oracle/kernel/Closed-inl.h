// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_CLOSED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_CLOSED_INL_H
#undef TICKER_ORACLE_CLOSED_INL_H
#else
#define TICKER_ORACLE_CLOSED_INL_H
#endif

#include <grader/oracle/kernel/Shares-inl.h>

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

/// A ball and one sphere in front of it, seen from a point: sines and cosines of the ball's
/// half-angle a, of the sphere's b, and of the angle g between their centres.
struct TwoCones {
    VF sineA, cosineA, sineB, cosineB, sineG, cosineG;
};

/// Share of the ball outside the cone of half-angle t around its axis. The integral over the ball,
/// in spherical coordinates around the point, has the antiderivative
/// cos t (1 - sin^2 t / sin^2 a)^(3/2). It is zero for t beyond a.
HWY_INLINE VF shareOutside(VF sine, VF cosine, VF inverseSineA) {
    const VF inside = hn::Mul(sine, inverseSineA);
    const VF rest = positive(hn::NegMulAdd(inside, inside, all(1.0F)));
    return hn::Mul(positive(cosine), hn::Mul(hn::Sqrt(rest), rest));
}

/// Share of the ball that the sphere leaves visible. In each half-plane through the axis to the
/// ball's centre, the covered part has a closed form. The angle of the half-plane is integrated by
/// Gauss-Legendre quadrature, with nodes concentrated at the end where the integrand vanishes like
/// a square root. Measured error with 12 nodes: 2e-3 at worst, 1e-4 (RMS), 1e-5 on average.
HWY_INLINE VF visibleBesideSphere(const Setup& setup, const TwoCones& cones) {
    const VF zero = hn::Zero(F());
    const VF one = all(1.0F);
    const VF tiny = all(1e-12F);
    // Where the axis hits the sphere, the angle is counted from the far side.
    const MF outside = hn::Ge(cones.cosineB, cones.cosineG);
    const VF inverseSineA = hn::Div(one, cones.sineA);
    const VF rim = hn::Div(hn::NegMulAdd(cones.cosineA, cones.cosineG, cones.cosineB),
                           hn::Max(hn::Mul(cones.sineA, cones.sineG), tiny));
    const VF rimTurn = hn::Acos(F(), hn::Max(all(-1.0F), hn::Min(rim, one)));
    const VF tangent =
        hn::Asin(F(), hn::Min(one, hn::Div(cones.sineB, hn::Max(cones.sineG, tiny))));
    const MF touches = hn::Gt(cones.cosineG, hn::Mul(cones.cosineA, cones.cosineB));
    const VF pi = all(3.14159265F);
    const VF range =
        hn::IfThenElse(outside, hn::IfThenElse(touches, tangent, rimTurn), hn::Sub(pi, rimTurn));
    const VF rangeTurns = hn::Mul(range, all(0.159154943F));
    const VF side = hn::IfThenElse(outside, one, all(-1.0F));

    VF sum = zero;
    for (const Setup::Node& node : setup.nodes) {
        const VF turn = hn::Mul(rangeTurns, all(node.position));
        const VF across = hn::Mul(cones.sineG, sineOfTurn(turn));
        const VF along = hn::Mul(hn::Mul(cones.sineG, cosineOfTurn(turn)), side);
        const VF across2 = squared(across);
        const VF root = hn::Sqrt(positive(hn::MulSub(cones.sineB, cones.sineB, across2)));
        const VF scale = hn::Div(one, hn::Sub(one, across2));
        const VF sineMiddle = hn::Mul(along, cones.cosineB);
        const VF sineHalf = hn::Mul(cones.cosineG, root);
        const VF cosineMiddle = hn::Mul(cones.cosineG, cones.cosineB);
        const VF cosineHalf = hn::Mul(along, root);
        const VF beyondNear =
            shareOutside(hn::Mul(hn::Sub(sineMiddle, sineHalf), scale),
                         hn::Mul(hn::Add(cosineMiddle, cosineHalf), scale), inverseSineA);
        const VF beyondFar =
            shareOutside(hn::Mul(hn::Add(sineMiddle, sineHalf), scale),
                         hn::Mul(hn::Sub(cosineMiddle, cosineHalf), scale), inverseSineA);
        const VF covered = hn::Sub(beyondNear, beyondFar);
        sum = hn::MulAdd(hn::IfThenElse(outside, covered, beyondFar), all(node.weight), sum);
    }
    const VF share = hn::Mul(hn::Mul(sum, rangeTurns), all(2.0F));
    const VF visible = hn::IfThenElse(outside, hn::Sub(one, share), share);
    return hn::Min(one, positive(visible));
}

/// Share of a ball on one side of a plane; `height` is the distance of its centre from the plane,
/// in radii, positive on that side.
HWY_INLINE VF capShare(VF height) {
    const VF one = all(1.0F);
    const VF inside = hn::Min(one, hn::Max(all(-1.0F), height));
    const VF above = hn::Add(one, inside);
    return hn::Mul(hn::Mul(all(0.25F), squared(above)), hn::Sub(all(2.0F), inside));
}

HWY_INLINE VF visibleBesidePlanes(const Setup& setup, const Waiting& waiting, VF radius,
                                  VF visible) {
    const SceneSoA& scene = setup.scene;
    const bool endless = setup.reading.shadowReach == ShadowReach::endless;
    for (std::size_t i = 0; i < scene.planes.size(); ++i) {
        const MF mine = hn::RebindMask(F(), hn::TestBit(waiting.planes, hn::Set(U(), bitOf(i))));
        if (hn::AllFalse(F(), mine)) continue;
        const Vec3 normal = all3(scene.planes.x[i], scene.planes.y[i], scene.planes.z[i]);
        const VF height = heightAbove(scene, i, waiting.start);
        const VF rise = dot(normal, waiting.aim.centre);
        const VF aim = endless ? rise : hn::Add(rise, height);
        const VF share = capShare(hn::Div(hn::CopySign(aim, hn::Xor(aim, height)), radius));
        visible = hn::IfThenElse(mine, share, visible);
    }
    return visible;
}

/// Share of the light that is visible from one vector of points, each with exactly one sphere or
/// plane that may shade it.
HWY_INLINE VF visibleShare(const Setup& setup, const Waiting& waiting) {
    const SceneSoA& scene = setup.scene;
    const VF radius = hn::Mul(waiting.aim.spread, all(setup.lightRadius));
    Vec3 toCentre = all3(0.0F, 0.0F, 1.0F);
    VF power = all(1.0F);
    VF sphereRadius = all(0.0F);
    bool anySphere = false;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const MF mine =
            hn::RebindMask(F(), hn::TestBit(waiting.nearSpheres, hn::Set(U(), bitOf(i))));
        if (hn::AllFalse(F(), mine)) continue;
        anySphere = true;
        const Vec3 apart = centreOf(scene, i) - waiting.start.point;
        toCentre = select(mine, apart, toCentre);
        power = hn::IfThenElse(mine, powerOf(scene, i, apart, waiting.start), power);
        sphereRadius = hn::IfThenElse(mine, all(scene.spheres.radius[i]), sphereRadius);
    }
    VF visible = all(1.0F);
    if (anySphere) {
        const VF one = all(1.0F);
        TwoCones cones;
        cones.sineA = hn::Mul(radius, waiting.aim.inverseDistance);
        cones.cosineA = hn::Sqrt(positive(hn::NegMulAdd(cones.sineA, cones.sineA, one)));
        const VF inverseDistance2 = hn::Div(one, hn::MulAdd(sphereRadius, sphereRadius, power));
        const VF inverseDistance = hn::Sqrt(inverseDistance2);
        cones.sineB = hn::Mul(sphereRadius, inverseDistance);
        cones.cosineB = hn::Sqrt(hn::Mul(power, inverseDistance2));
        // Near zero, the cross product is accurate while 1 - cosine^2 loses all digits.
        const Vec3 axis = waiting.aim.centre * waiting.aim.inverseDistance;
        const VF scale = inverseRoot(squared(toCentre));
        const Vec3 unitCentre = toCentre * scale;
        cones.cosineG = dot(axis, unitCentre);
        cones.sineG = hn::Sqrt(squared(cross(axis, unitCentre)));
        visible = visibleBesideSphere(setup, cones);
    }
    return visibleBesidePlanes(setup, waiting, radius, visible);
}

/// Adds the light of all queued points with one occluder.
HWY_INLINE void settleClosed(const Setup& setup, std::size_t light, Workspace& work) {
    ShadowQueue& singles = work.lights[light].singles;
    fillIdleLanes(singles);
    const VF perRay = all(1.0F / static_cast<float>(setup.settings.shadowRayCount));
    for (std::size_t at = 0; at < singles.size; at += width()) {
        const Waiting waiting = waitingAt(setup, setup.scene.lights[light], singles, at);
        const VF share = visibleShare(setup, waiting);
        const Vec3 visible = waiting.contribution * share;
        addColour(work.colour, waiting.slot, visible);
        addColour(work.pairedColour, waiting.slot, visible);
        const VF noise = hn::Mul(hn::Mul(share, hn::Sub(all(1.0F), share)), perRay);
        addNoise(work, waiting.slot, waiting.contribution, noise);
    }
    singles.size = 0;
}

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

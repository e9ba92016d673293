// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_PATHS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_PATHS_INL_H
#undef TICKER_ORACLE_PATHS_INL_H
#else
#define TICKER_ORACLE_PATHS_INL_H
#endif

#include <grader/oracle/kernel/Closed-inl.h>
#include <grader/oracle/kernel/Lens-inl.h>
#include <grader/oracle/kernel/Lights-inl.h>
#include <grader/oracle/kernel/PerSample-inl.h>
#include <grader/oracle/kernel/Shares-inl.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

/// Height of a reflected ray's start above its surface; the framework's kShadowBias.
inline constexpr float kReflectionBias = 1e-4F;
inline constexpr float kBackground = 0.001F;

/// Reflects the rays of one vector. Rounding of the hit point changes the length of a small
/// sphere's normal; the reflected direction is normalised again, so that the error does not grow
/// from sphere to sphere.
HWY_INLINE void reflect(const Surface& surface, const Vec3& direction, VF weight, std::size_t at,
                        Workspace& work) {
    store(weight, work.weight, at);
    const VF twice = hn::Mul(all(-2.0F), dot(direction, surface.normal));
    store(normalised(moved(direction, surface.normal, twice)), work.direction, at);
    store(moved(surface.point, surface.normal, all(kReflectionBias)), work.origin, at);
    store(surface.object, work.object, at);
    store(hn::Mul(all(kReflectionBias), dot(surface.geometric, surface.normal)), work.clearance,
          at);
}

/// Finds the next hit of one vector of rays, adds the light that needs no shadow rays, and queues
/// the rest.
/// @return  False if no lane of the vector is alive.
template <typename Aims>
HWY_INLINE bool stepVector(const Setup& setup, int depth, std::size_t at, Aims& aims, bool paired,
                           Workspace& work) {
    const VF zero = hn::Zero(F());
    const VF weight = load(work.weight, at);
    if (hn::AllFalse(F(), hn::Gt(weight, zero))) return false;

    const Start start{load(work.origin, at), load(work.object, at), load(work.clearance, at)};
    const Vec3 direction = load(work.direction, at);
    const Closest nearest = closest(setup.scene, start, direction);
    const MF hit = hn::Lt(nearest.distance, all(kNowhere));
    const VF distance = hn::IfThenElseZero(hit, nearest.distance);
    const Surface surface =
        surfaceAt(setup, moved(start.point, direction, distance), direction, nearest.object);

    const VF mirrored = depth < setup.settings.bounces
                            ? hn::IfThenElseZero(hit, positive(surface.reflectivity))
                            : zero;
    const VF share = hn::Mul(weight, hn::Sub(all(1.0F), mirrored));
    const VF lit = hn::IfThenElseZero(hit, share);
    const Vec3 ambient{hn::Mul(surface.colour.x, all(setup.scene.ambient[0])),
                       hn::Mul(surface.colour.y, all(setup.scene.ambient[1])),
                       hn::Mul(surface.colour.z, all(setup.scene.ambient[2]))};
    const VF missed = hn::IfThenZeroElse(hit, hn::Mul(weight, all(kBackground)));
    Vec3 colour = moved({missed, missed, missed}, ambient, lit);
    for (std::size_t light = 0; light < work.lights.size(); ++light) {
        if (setup.contributionIsShare)
            lookAtLight(setup, light, surface, lit, ambient, at, paired, work, colour);
        else
            sampleLight(setup, light, static_cast<std::size_t>(depth), surface, lit, ambient, at,
                        paired, aims, work);
    }
    addColour(work.colour, at, colour);
    if (paired) addColour(work.pairedColour, at, colour);
    if (depth < setup.settings.bounces)
        reflect(surface, direction, hn::Mul(weight, mirrored), at, work);
    return true;
}

template <typename Lens, typename Aims>
HWY_INLINE void traceAll(const Setup& setup, Drawing drawing, Lens& lens, Aims& aims,
                         Workspace& work) {
    const bool paired = drawing == Drawing::paired;
    work.lights.resize(setup.scene.lights.size());
    for (std::size_t at = 0; at < work.paths; at += width())
        beginVector(setup, lens, at, paired, work);
    for (int depth = 0; depth <= setup.settings.bounces; ++depth) {
        bool alive = false;
        for (std::size_t at = 0; at < work.paths; at += width())
            alive = stepVector(setup, depth, at, aims, paired, work) || alive;
        if (!alive) break;
        for (std::size_t light = 0; light < work.lights.size(); ++light) {
            settleClosed(setup, light, work);
            settle(setup, light, static_cast<std::size_t>(depth), paired, aims, work);
        }
    }
}

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

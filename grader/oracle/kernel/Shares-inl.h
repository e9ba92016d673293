// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_SHARES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_SHARES_INL_H
#undef TICKER_ORACLE_SHARES_INL_H
#else
#define TICKER_ORACLE_SHARES_INL_H
#endif

#include <grader/oracle/kernel/Aims-inl.h>
#include <grader/oracle/kernel/Shadow-inl.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

/// One vector of queued points, and one light.
struct Waiting {
    Vec3 contribution;  ///< of the unshadowed light
    Start start;
    VU slot;
    VU nearSpheres, otherSpheres, planes;
    Aim aim;
    VF centreDistance;
};

HWY_INLINE Waiting waitingAt(const Setup& setup, const SceneSoA::Light& light,
                             const ShadowQueue& queue, std::size_t at) {
    Waiting waiting;
    waiting.contribution = load(queue.contribution, at);
    waiting.start = {load(queue.start, at), load(queue.object, at), load(queue.clearance, at)};
    waiting.slot = load(queue.slot, at);
    waiting.nearSpheres = load(queue.nearSpheres, at);
    waiting.otherSpheres = load(queue.otherSpheres, at);
    waiting.planes = load(queue.planes, at);
    waiting.aim = aimAt(setup, light, waiting.start.point);
    const Vec3 centre = all3(light.position[0], light.position[1], light.position[2]);
    waiting.centreDistance = hn::Sqrt(squared(centre - waiting.start.point));
    return waiting;
}

/// Lanes in which shadow ray `i` is blocked.
template <typename Aims>
HWY_INLINE MF rayStopped(const Setup& setup, const Waiting& waiting, Occluding& occluding,
                         Aims& aims, std::size_t i) {
    Vec3 towards = moved(waiting.aim.centre, aims.point(i), waiting.aim.spread);
    if (setup.mistake.pointJitter > 0.0) {
        constexpr std::size_t kJitter = 4100;  // far from the dimensions of all other samples
        const VF jitter =
            all(static_cast<float>(setup.mistake.pointJitter) / std::max(setup.lightRadius, 1e-6F));
        const Vec3 away = aims.point(i + kJitter) * jitter;
        const Start start{waiting.start.point + away, hn::Set(I(), -1), waiting.start.clearance};
        occluding.prepare(start, waiting.nearSpheres, waiting.otherSpheres, waiting.planes);
        towards = towards - away;
    }
    const VF length2 = squared(towards);
    return occluding.stops(towards, length2, reachOf(setup, length2, waiting.centreDistance));
}

/// Share of `shadowRays` rays that arrive, as a student's code counts it.
template <typename Aims>
HWY_INLINE VF countedShare(const Setup& setup, const Waiting& waiting, Occluding& occluding,
                           Aims& aims) {
    VF arrived = hn::Zero(F());
    for (int i = 0; i < setup.shadowRays; ++i) {
        const MF stopped = rayStopped(setup, waiting, occluding, aims, static_cast<std::size_t>(i));
        arrived = hn::Add(arrived, hn::IfThenZeroElse(stopped, all(1.0F)));
    }
    const VF rays = all(static_cast<float>(setup.shadowRays));
    if (setup.mistake.allOrNothing) return hn::IfThenElseZero(hn::Ge(arrived, rays), all(1.0F));
    if (setup.mistake.litIfAny)
        return hn::IfThenElseZero(hn::Gt(arrived, hn::Zero(F())), all(1.0F));
    return hn::Mul(arrived, all(1.0F / static_cast<float>(setup.shadowRays)));
}

/// Adds to the values of the paths `slot`; no path occurs twice in a vector.
HWY_INLINE void addAt(VF value, Lanes<float>& to, VU slot) {
    const VI where = hn::BitCast(I(), slot);
    const VF sum = hn::Add(hn::GatherIndex(F(), to.data(), where), value);
    hn::ScatterIndex(sum, F(), to.data(), where);
}

HWY_INLINE void addColour(std::array<Lanes<float>, 3>& to, VU slot, const Vec3& colour) {
    addAt(colour.x, to[0], slot);
    addAt(colour.y, to[1], slot);
    addAt(colour.z, to[2], slot);
}

/// Adds the covariance of `size` * X, where X is a random number of variance `variance`.
HWY_INLINE void addNoise(Workspace& work, VU slot, const Vec3& size, VF variance) {
    const VF products[6] = {squared(size.x),         squared(size.y),
                            squared(size.z),         hn::Mul(size.x, size.y),
                            hn::Mul(size.x, size.z), hn::Mul(size.y, size.z)};
    for (std::size_t i = 0; i < 6; ++i)
        addAt(hn::Mul(products[i], variance), work.noise[i], slot);
}

template <typename Aims>
HWY_INLINE void settleCounted(const Setup& setup, const Waiting& waiting, Occluding& occluding,
                              Aims& aims, Workspace& work) {
    const VF share = countedShare(setup, waiting, occluding, aims);
    addColour(work.colour, waiting.slot, waiting.contribution * share);
}

/// Two rays are enough for mean and variance: for independent estimates a and b, E[a b] is the
/// square of the mean, and E[(a - b)^2 / 2] is the variance of one ray.
template <typename Aims>
HWY_INLINE void settlePaired(const Setup& setup, const Waiting& waiting, Occluding& occluding,
                             Aims& aims, Workspace& work) {
    const VF one = all(1.0F);
    const MF first = rayStopped(setup, waiting, occluding, aims, 0);
    const MF second = rayStopped(setup, waiting, occluding, aims, 1);
    const Vec3& light = waiting.contribution;
    addColour(work.colour, waiting.slot, light * hn::IfThenZeroElse(first, one));
    addColour(work.pairedColour, waiting.slot, light * hn::IfThenZeroElse(second, one));
    const float noise = 0.5F / static_cast<float>(setup.settings.shadowRayCount);
    addNoise(work, waiting.slot, light, hn::IfThenElseZero(hn::Xor(first, second), all(noise)));
}

/// Idle lanes of the last vector get the slot behind the last path, so that their stores hit the
/// padding.
HWY_INLINE void fillIdleLanes(ShadowQueue& queue) {
    for (std::size_t i = queue.size; i < queue.size + width(); ++i) {
        queue.slot[i] = static_cast<std::uint32_t>(kPaths);
        queue.nearSpheres[i] = queue.otherSpheres[i] = queue.planes[i] = 0;
    }
}

/// Adds a light to all points of its queue and empties the queue.
template <typename Aims>
HWY_INLINE void settle(const Setup& setup, std::size_t light, std::size_t depth, bool paired,
                       Aims& aims, Workspace& work) {
    ShadowQueue& queue = work.lights[light].queue;
    fillIdleLanes(queue);
    Occluding occluding{setup.scene, work.occluders};
    for (std::size_t at = 0; at < queue.size; at += width()) {
        const Waiting waiting = waitingAt(setup, setup.scene.lights[light], queue, at);
        occluding.prepare(waiting.start, waiting.nearSpheres, waiting.otherSpheres, waiting.planes);
        aims.begin(waiting.slot, light, depth);
        if (paired)
            settlePaired(setup, waiting, occluding, aims, work);
        else
            settleCounted(setup, waiting, occluding, aims, work);
    }
    queue.size = 0;
}

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

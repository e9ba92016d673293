// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_PERSAMPLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_PERSAMPLE_INL_H
#undef TICKER_ORACLE_PERSAMPLE_INL_H
#else
#define TICKER_ORACLE_PERSAMPLE_INL_H
#endif

#include <grader/oracle/kernel/Lights-inl.h>
#include <grader/oracle/kernel/Shares-inl.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

/// Phong's terms for one aim point.
HWY_INLINE Phong phongTowards(const Setup& setup, const SceneSoA::Light& light,
                              const Surface& surface, const Vec3& towards, VF centreFalloff) {
    const VF inverseLength = inverseRoot(squared(towards));
    const bool own = setup.reading.phong == PhongReading::perSample;
    return phong(setup.scene, light, surface, towards * inverseLength,
                 own ? squared(inverseLength) : centreFalloff);
}

/// One light under the reading in which every aim point has its own Phong terms. The share of rays
/// that arrive does not determine the colour then, so every hit draws its samples at once.
template <typename Aims>
HWY_INLINE void sampleLight(const Setup& setup, std::size_t number, std::size_t depth,
                            const Surface& surface, VF weight, const Vec3& ambient, std::size_t at,
                            bool paired, Aims& aims, Workspace& work) {
    const SceneSoA::Light& light = setup.scene.lights[number];
    const Vec3 apart =
        all3(light.position[0], light.position[1], light.position[2]) - surface.point;
    const VF inverseDistance = inverseRoot(squared(apart));
    Waiting waiting;
    waiting.start = shadowStart(setup, surface, apart * inverseDistance);
    waiting.slot = hn::Iota(U(), static_cast<std::uint32_t>(at));
    waiting.aim = aimAt(setup, light, waiting.start.point);
    waiting.centreDistance = hn::Sqrt(squared(apart));
    const Occluders occluders = lookForOccluders(setup, waiting.start, waiting.aim);
    Occluding occluding{setup.scene, work.occluders};
    occluding.prepare(waiting.start, occluders.nearSpheres, occluders.otherSpheres,
                      occluders.planes);
    aims.begin(waiting.slot, number, depth);

    const int rays = paired ? 2 : setup.shadowRays;
    Vec3 colours[2] = {all3(0.0F, 0.0F, 0.0F), all3(0.0F, 0.0F, 0.0F)};
    for (int i = 0; i < rays; ++i) {
        const Vec3 towards =
            moved(waiting.aim.centre, aims.point(static_cast<std::size_t>(i)), waiting.aim.spread);
        const VF length2 = squared(towards);
        const MF stopped = hn::Or(
            occluders.shaded,
            occluding.stops(towards, length2, reachOf(setup, length2, waiting.centreDistance)));
        const Parts parts = partsOf(
            setup, number, phongTowards(setup, light, surface, towards, squared(inverseDistance)),
            ambient);
        Vec3& colour = colours[paired ? i : 0];
        const VF arrives = hn::IfThenZeroElse(stopped, weight);
        colour = moved(moved(colour, parts.shaded, arrives), parts.unshaded, weight);
    }
    if (!paired) {
        addColour(work.colour, at, colours[0] * all(1.0F / static_cast<float>(rays)));
        return;
    }
    addColour(work.colour, at, colours[0]);
    addColour(work.pairedColour, at, colours[1]);
    addNoise(work, waiting.slot, colours[0] - colours[1],
             all(0.5F / static_cast<float>(setup.settings.shadowRayCount)));
}

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_LIGHTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_LIGHTS_INL_H
#undef TICKER_ORACLE_LIGHTS_INL_H
#else
#define TICKER_ORACLE_LIGHTS_INL_H
#endif

#include <grader/oracle/kernel/Aims-inl.h>
#include <grader/oracle/kernel/Shade-inl.h>
#include <grader/oracle/kernel/Shadow-inl.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

/// Adds `colour` to the colours of one vector of paths.
HWY_INLINE void addColour(std::array<Lanes<float>, 3>& to, std::size_t at, const Vec3& colour) {
    store(hn::Add(load(to[0], at), colour.x), to[0], at);
    store(hn::Add(load(to[1], at), colour.y), to[1], at);
    store(hn::Add(load(to[2], at), colour.z), to[2], at);
}

/// A light's contribution, split into the part that needs shadow rays and the unshadowed part.
struct Parts {
    Vec3 shaded, unshaded;
};

HWY_INLINE Parts partsOf(const Setup& setup, std::size_t light, const Phong& phong,
                         const Vec3& ambient) {
    const Mistake& mistake = setup.mistake;
    const Vec3 none = all3(0.0F, 0.0F, 0.0F);
    Parts parts{phong.diffuse + phong.specular, none};
    if (mistake.diffuseUnshadowed) parts = {phong.specular, phong.diffuse};
    if (mistake.specularUnshadowed)
        parts = {parts.shaded - phong.specular, parts.unshaded + phong.specular};
    if (mistake.lightsMixed) {
        const VF times = all(static_cast<float>(setup.scene.lights.size() - light));
        parts = {parts.shaded * times, parts.unshaded * times};
    }
    if (mistake.ambientScaled) parts = {parts.shaded + ambient, parts.unshaded - ambient};
    if (mistake.shadowInverted) parts = {none - parts.shaded, parts.unshaded + parts.shaded};
    return parts;
}

/// Start of a point's shadow rays.
HWY_INLINE Start shadowStart(const Setup& setup, const Surface& surface, const Vec3& toLight) {
    const VF bias = all(setup.shadowBias);
    const Vec3 along = setup.reading.biasAlongLight ? toLight : surface.normal;
    return {moved(surface.point, along, bias), surface.object,
            hn::Mul(bias, dot(surface.geometric, along))};
}

/// Appends the lanes of `mask`. They are compressed in a register: some processors take a hundred
/// times as long to compress into memory.
template <typename T>
HWY_INLINE void append(T value, MF mask, Lanes<hn::TFromV<T>>& to, std::size_t at) {
    const hn::DFromV<T> tag;
    hn::StoreU(hn::Compress(value, hn::RebindMask(tag, mask)), tag, to.data() + at);
}

HWY_INLINE void enqueue(ShadowQueue& queue, MF mask, const Start& start, const Occluders& occluders,
                        const Vec3& contribution, std::size_t firstSlot) {
    const std::size_t at = queue.size;
    append(contribution.x, mask, queue.contribution.x, at);
    append(contribution.y, mask, queue.contribution.y, at);
    append(contribution.z, mask, queue.contribution.z, at);
    append(start.point.x, mask, queue.start.x, at);
    append(start.point.y, mask, queue.start.y, at);
    append(start.point.z, mask, queue.start.z, at);
    append(start.clearance, mask, queue.clearance, at);
    append(start.object, mask, queue.object, at);
    append(hn::Iota(U(), static_cast<std::uint32_t>(firstSlot)), mask, queue.slot, at);
    append(occluders.nearSpheres, mask, queue.nearSpheres, at);
    append(occluders.otherSpheres, mask, queue.otherSpheres, at);
    append(occluders.planes, mask, queue.planes, at);
    queue.size = at + hn::CountTrue(F(), mask);
}

/// Lanes in which exactly one near sphere, or one plane, may shade.
HWY_INLINE MF onlyOne(const Setup& setup, const Occluders& occluders) {
    const VU zero = hn::Zero(U());
    const VU one = hn::Set(U(), 1U);
    const VU near = occluders.nearSpheres;
    const VU planes = occluders.planes;
    const VU several =
        hn::Or(occluders.otherSpheres,
               hn::Or(hn::And(near, hn::Sub(near, one)), hn::And(planes, hn::Sub(planes, one))));
    const VU shared = hn::And(hn::Or(near, planes), hn::Set(U(), bitOf(31)));
    const bool planesToo = setup.reading.shadowReach != ShadowReach::toCentre;
    const auto both =
        planesToo ? hn::And(hn::Ne(near, zero), hn::Ne(planes, zero)) : hn::Ne(planes, zero);
    const auto few = hn::Eq(hn::Or(several, shared), zero);
    return hn::RebindMask(F(), hn::AndNot(both, few));
}

/// Handles one light at one vector of hits: adds its contribution to `colour` where cone tests
/// decide its visible share; queues all other hits.
HWY_INLINE void lookAtLight(const Setup& setup, std::size_t number, const Surface& surface,
                            VF weight, const Vec3& ambient, std::size_t at, bool paired,
                            Workspace& work, Vec3& colour) {
    const SceneSoA::Light& light = setup.scene.lights[number];
    const Vec3 apart =
        all3(light.position[0], light.position[1], light.position[2]) - surface.point;
    const VF inverseDistance = inverseRoot(squared(apart));
    const Vec3 toLight = apart * inverseDistance;
    const Phong lit = phong(setup.scene, light, surface, toLight, squared(inverseDistance));
    Vec3 contribution = (lit.diffuse + lit.specular) * weight;
    if (setup.lightIsSplit) [[unlikely]] {
        const Parts parts = partsOf(setup, number, lit, ambient);
        contribution = parts.shaded * weight;
        colour = colour + parts.unshaded * weight;
    }
    const VF size = hn::Abs(hn::Add(contribution.x, hn::Add(contribution.y, contribution.z)));
    const MF matters = hn::Gt(size, hn::Zero(F()));
    if (hn::AllFalse(F(), matters)) return;

    const Start start = shadowStart(setup, surface, toLight);
    const Occluders occluders = lookForOccluders(setup, start, aimAt(setup, light, start.point));
    const VU marks =
        hn::Or(occluders.nearSpheres, hn::Or(occluders.otherSpheres, occluders.planes));
    const MF doubtful = hn::RebindMask(F(), hn::Ne(marks, hn::Zero(U())));
    const MF dimmed = hn::Or(occluders.shaded, doubtful);
    colour = moved(colour, contribution, hn::IfThenZeroElse(dimmed, all(1.0F)));
    MF unknown = hn::And(matters, hn::AndNot(occluders.shaded, doubtful));
    if (hn::AllFalse(F(), unknown)) return;
    LightWork& lamp = work.lights[number];
    if (paired && setup.closedFormsHold) {
        const MF single = hn::And(unknown, onlyOne(setup, occluders));
        if (!hn::AllFalse(F(), single))
            enqueue(lamp.singles, single, start, occluders, contribution, at);
        unknown = hn::AndNot(single, unknown);
    }
    if (!hn::AllFalse(F(), unknown))
        enqueue(lamp.queue, unknown, start, occluders, contribution, at);
}

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

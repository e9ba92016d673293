// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_SHADE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_SHADE_INL_H
#undef TICKER_ORACLE_SHADE_INL_H
#else
#define TICKER_ORACLE_SHADE_INL_H
#endif

#include <grader/oracle/Bump.h>
#include <grader/oracle/Setup.h>
#include <grader/oracle/kernel/Intersect-inl.h>

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

/// What Phong's model needs of a point.
struct Surface {
    Vec3 point;
    Vec3 normal;     ///< for shading; bumps included
    Vec3 geometric;  ///< of the shape itself, without bumps
    Vec3 toViewer;   ///< unit length
    Vec3 colour;
    VF kD, kS, alpha, reflectivity;
    VI object;
};

/// Adds the normals of bumpy spheres, lane by lane in double precision: single precision would pick
/// other texels near their edges.
HWY_INLINE void addBumps(const Setup& setup, Surface& surface) {
    alignas(64) float p[3][16];
    alignas(64) float n[3][16];
    alignas(64) std::int32_t object[16];
    hn::Store(surface.point.x, F(), p[0]);
    hn::Store(surface.point.y, F(), p[1]);
    hn::Store(surface.point.z, F(), p[2]);
    hn::Store(surface.normal.x, F(), n[0]);
    hn::Store(surface.normal.y, F(), n[1]);
    hn::Store(surface.normal.z, F(), n[2]);
    hn::Store(surface.object, I(), object);
    const SceneSoA& scene = setup.scene;
    for (std::size_t lane = 0; lane < width(); ++lane) {
        if (object[lane] < 0) continue;
        const auto i = static_cast<std::size_t>(object[lane]);
        if (scene.heightMaps[i] == nullptr) continue;
        const double outwards[3] = {double{p[0][lane]} - double{scene.spheres.x[i]},
                                    double{p[1][lane]} - double{scene.spheres.y[i]},
                                    double{p[2][lane]} - double{scene.spheres.z[i]}};
        const std::array<double, 3> tilted =
            bumpedNormal(*scene.heightMaps[i], setup.reading.bump, outwards);
        for (std::size_t axis = 0; axis < 3; ++axis)
            n[axis][lane] = static_cast<float>(tilted[axis]);
    }
    surface.normal = {hn::Load(F(), n[0]), hn::Load(F(), n[1]), hn::Load(F(), n[2])};
}

HWY_INLINE Surface surfaceAt(const Setup& setup, const Vec3& point, const Vec3& direction,
                             VI object) {
    const SceneSoA& scene = setup.scene;
    Surface surface;
    surface.point = point;
    surface.object = object;
    const OfObject of{scene, object};
    const Vec3 shift{of(scene.normals.shiftX), of(scene.normals.shiftY), of(scene.normals.shiftZ)};
    // A miss has weight zero, but 0 * infinity is NaN: nothing that a miss computes may overflow.
    const MF known = hn::RebindMask(F(), hn::Gt(object, hn::Set(I(), -1)));
    const Vec3 none = all3(0.0F, 0.0F, 0.0F);
    surface.geometric = select(known, point * of(scene.normals.scale) - shift, none);
    surface.normal = surface.geometric;
    if (scene.anyBumpy) addBumps(setup, surface);
    surface.toViewer = setup.reading.viewerIsEye ? normalised(none - point) : none - direction;
    const SceneSoA::Materials& materials = scene.materials;
    surface.colour = {of(materials.red), of(materials.green), of(materials.blue)};
    surface.kD = of(materials.kD);
    surface.kS = of(materials.kS);
    surface.alpha = of(materials.alpha);
    surface.reflectivity = of(materials.reflectivity);
    return surface;
}

/// base^alpha for base >= 0; by repeated squaring if all exponents are the same integer.
HWY_INLINE VF power(const SceneSoA& scene, VF base, VF alpha) {
    if (scene.materials.wholeAlpha >= 0) {
        VF result = all(1.0F);
        VF square = base;
        for (unsigned bits = static_cast<unsigned>(scene.materials.wholeAlpha); bits != 0;
             bits >>= 1U) {
            if ((bits & 1U) != 0) result = hn::Mul(result, square);
            square = squared(square);
        }
        return result;
    }
    const VF zero = hn::Zero(F());
    const VF safe = hn::Max(base, all(1e-30F));
    const VF result = hn::Exp(F(), hn::Mul(alpha, hn::Log(F(), safe)));
    return hn::IfThenElse(hn::And(hn::Eq(base, zero), hn::Gt(alpha, zero)), zero, result);
}

/// Phong's diffuse and specular light of one unshadowed light source.
struct Phong {
    Vec3 diffuse, specular;
};

/// @param towards  Unit vector to the light.
/// @param falloff  1 / squared distance at which the intensity is taken.
HWY_INLINE Phong phong(const SceneSoA& scene, const SceneSoA::Light& light, const Surface& surface,
                       const Vec3& towards, VF falloff) {
    const VF facing = dot(surface.normal, towards);
    const VF twice = hn::Add(facing, facing);
    const VF mirrored =
        hn::MulSub(twice, dot(surface.normal, surface.toViewer), dot(towards, surface.toViewer));
    const VF arriving = hn::Mul(falloff, all(light.power));
    const VF diffuse = hn::Mul(arriving, hn::Mul(surface.kD, positive(facing)));
    const VF specular =
        hn::Mul(arriving, hn::Mul(surface.kS, power(scene, positive(mirrored), surface.alpha)));
    const Vec3 lamp = all3(light.colour[0], light.colour[1], light.colour[2]);
    const Vec3 lampTwice =
        all3(light.colour[0] * light.colour[0], light.colour[1] * light.colour[1],
             light.colour[2] * light.colour[2]);
    const Vec3 body{hn::Mul(surface.colour.x, lamp.x), hn::Mul(surface.colour.y, lamp.y),
                    hn::Mul(surface.colour.z, lamp.z)};
    return {body * diffuse, lampTwice * specular};
}

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

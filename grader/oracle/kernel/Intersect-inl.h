// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_INTERSECT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_INTERSECT_INL_H
#undef TICKER_ORACLE_INTERSECT_INL_H
#else
#define TICKER_ORACLE_INTERSECT_INL_H
#endif

#include <grader/oracle/SceneSoA.h>
#include <grader/oracle/kernel/Vec3-inl.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

inline constexpr float kNowhere = 1e30F;

/// Start points of rays, and for each the object that it lies on and its height above that object.
/// The stored height makes the test against that object exact, however small the shadow bias is
/// compared with the rounding of `point`.
struct Start {
    Vec3 point;
    VI object;
    VF clearance;
};

/// Power of the point, |start - centre|^2 - radius^2: positive outside of the sphere.
HWY_INLINE VF powerOf(const SceneSoA& scene, std::size_t sphere, const Vec3& toCentre,
                      const Start& start) {
    const VF radius = all(scene.spheres.radius[sphere]);
    const MF own =
        hn::RebindMask(F(), hn::Eq(start.object, hn::Set(I(), static_cast<std::int32_t>(sphere))));
    const VF exact = hn::Mul(start.clearance, hn::MulAdd(radius, all(2.0F), start.clearance));
    return hn::IfThenElse(own, exact, hn::NegMulAdd(radius, radius, squared(toCentre)));
}

/// Height of the start above a plane, on the side of its normal.
HWY_INLINE VF heightAbove(const SceneSoA& scene, std::size_t plane, const Start& start) {
    const Vec3 normal = all3(scene.planes.x[plane], scene.planes.y[plane], scene.planes.z[plane]);
    const auto number = static_cast<std::int32_t>(scene.spheres.size() + plane);
    const MF own = hn::RebindMask(F(), hn::Eq(start.object, hn::Set(I(), number)));
    return hn::IfThenElse(own, start.clearance,
                          hn::Sub(dot(normal, start.point), all(scene.planes.offset[plane])));
}

HWY_INLINE Vec3 centreOf(const SceneSoA& scene, std::size_t sphere) {
    return all3(scene.spheres.x[sphere], scene.spheres.y[sphere], scene.spheres.z[sphere]);
}

struct Closest {
    VF distance;  ///< kNowhere or more for a miss
    VI object;
};

/// The first object in front of each ray; directions have unit length.
HWY_INLINE Closest closest(const SceneSoA& scene, const Start& start, const Vec3& direction) {
    const VF zero = hn::Zero(F());
    Closest result{all(kNowhere), hn::Set(I(), -1)};
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const Vec3 toCentre = centreOf(scene, i) - start.point;
        const VF along = dot(toCentre, direction);
        const VF power = powerOf(scene, i, toCentre, start);
        const VF discriminant = hn::MulSub(along, along, power);
        const MF meets = hn::Ge(discriminant, zero);
        if (hn::AllFalse(F(), meets)) continue;
        const VF root = hn::Sqrt(positive(discriminant));
        // From inside of a sphere, its far side is hit.
        const VF distance =
            hn::IfThenElse(hn::Gt(power, zero), hn::Sub(along, root), hn::Add(along, root));
        const MF nearer =
            hn::And(meets, hn::And(hn::Gt(distance, zero), hn::Lt(distance, result.distance)));
        result.distance = hn::IfThenElse(nearer, distance, result.distance);
        result.object = hn::IfThenElse(hn::RebindMask(I(), nearer),
                                       hn::Set(I(), static_cast<std::int32_t>(i)), result.object);
    }
    for (std::size_t i = 0; i < scene.planes.size(); ++i) {
        const Vec3 normal = all3(scene.planes.x[i], scene.planes.y[i], scene.planes.z[i]);
        const VF height = heightAbove(scene, i, start);
        const VF distance = hn::Mul(hn::Neg(height), inverse(dot(normal, direction)));
        const MF nearer = hn::And(hn::Gt(distance, zero), hn::Lt(distance, result.distance));
        result.distance = hn::IfThenElse(nearer, distance, result.distance);
        const auto number = static_cast<std::int32_t>(scene.spheres.size() + i);
        result.object =
            hn::IfThenElse(hn::RebindMask(I(), nearer), hn::Set(I(), number), result.object);
    }
    return result;
}

/// Reads properties of each lane's object; arbitrary values in lanes without an object.
class OfObject {
public:
    OfObject(const SceneSoA& scene, VI object)
        : fitsRegister_(scene.heightMaps.size() <= width()),
          object_(hn::Max(object, hn::Zero(I()))) {}

    HWY_INLINE VF operator()(const std::vector<float>& table) const {
        if (fitsRegister_)
            return hn::TableLookupLanes(hn::LoadU(F(), table.data()),
                                        hn::IndicesFromVec(F(), object_));
        return hn::GatherIndex(F(), table.data(), object_);
    }

private:
    bool fitsRegister_;
    VI object_;
};

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

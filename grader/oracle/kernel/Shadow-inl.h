// Compiled once for each instruction set: see Kernel.cpp.
#if defined(TICKER_ORACLE_SHADOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TICKER_ORACLE_SHADOW_INL_H
#undef TICKER_ORACLE_SHADOW_INL_H
#else
#define TICKER_ORACLE_SHADOW_INL_H
#endif

#include <grader/oracle/kernel/Cones-inl.h>
#include <grader/oracle/kernel/Workspace.h>

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

/// All objects that may shade one vector of points, prepared for many shadow rays.
class Occluding {
public:
    Occluding(const SceneSoA& scene, OccluderScratch& scratch) : scene_(scene), scratch_(scratch) {
        scratch_.reserve(scene.spheres.size(), scene.planes.size());
    }

    HWY_INLINE void prepare(const Start& start, VU nearSpheres, VU otherSpheres, VU planes) {
        nears_ = others_ = planes_ = 0;
        const std::uint32_t near = bitsOf(nearSpheres);
        const std::uint32_t other = bitsOf(otherSpheres);
        for (std::size_t i = 0; i < scene_.spheres.size(); ++i) {
            if ((near & bitOf(i)) != 0) addSphere(i, start, nearSpheres, scratch_.near, nears_);
            if ((other & bitOf(i)) != 0) addSphere(i, start, otherSpheres, scratch_.other, others_);
        }
        const std::uint32_t plane = bitsOf(planes);
        for (std::size_t i = 0; i < scene_.planes.size(); ++i)
            if ((plane & bitOf(i)) != 0) addPlane(i, start, planes);
    }

    /// Lanes whose ray from the start along `towards` is blocked: by a near sphere at any
    /// distance, or by another object nearer than `reach`, in lengths of `towards`.
    HWY_INLINE MF stops(const Vec3& towards, VF length2, VF reach) const {
        const VF zero = hn::Zero(F());
        MF stopped = hn::MaskFromVec(zero);
        for (std::size_t i = 0; i < nears_; ++i) {
            const VF along = dot(vectorAt(scratch_.near, i), towards);
            const VF power = valueAt(scratch_.near, i);
            stopped =
                hn::Or(stopped, hn::Gt(hn::Mul(along, hn::Abs(along)), hn::Mul(length2, power)));
        }
        for (std::size_t i = 0; i < others_; ++i) {
            const VF along = dot(vectorAt(scratch_.other, i), towards);
            const VF power = valueAt(scratch_.other, i);
            const VF discriminant = hn::NegMulAdd(length2, power, squared(along));
            const VF root = hn::Sqrt(positive(discriminant));
            const VF distance =
                hn::IfThenElse(hn::Gt(power, zero), hn::Sub(along, root), hn::Add(along, root));
            stopped = hn::Or(stopped, hn::And(hn::Gt(discriminant, zero),
                                              hn::And(hn::Gt(distance, zero),
                                                      hn::Lt(distance, hn::Mul(length2, reach)))));
        }
        for (std::size_t i = 0; i < planes_; ++i) {
            const VF fall = dot(vectorAt(scratch_.plane, i), towards);
            const VF height = valueAt(scratch_.plane, i);
            stopped =
                hn::Or(stopped, hn::And(hn::Lt(hn::Mul(height, fall), zero),
                                        hn::Lt(hn::Abs(height), hn::Mul(reach, hn::Abs(fall)))));
        }
        return stopped;
    }

private:
    static constexpr std::size_t kStride = OccluderScratch::kStride;

    static HWY_INLINE std::uint32_t bitsOf(VU marks) {
        alignas(64) std::uint32_t lanes[16];
        hn::Store(marks, U(), lanes);
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < width(); ++i)
            bits |= lanes[i];
        return bits;
    }
    static HWY_INLINE MF markedLanes(VU marks, std::size_t object) {
        return hn::RebindMask(F(), hn::TestBit(marks, hn::Set(U(), bitOf(object))));
    }
    static HWY_INLINE Vec3 vectorAt(const std::vector<float>& values, std::size_t i) {
        const float* from = values.data() + i * kStride;
        return {hn::LoadU(F(), from), hn::LoadU(F(), from + 16), hn::LoadU(F(), from + 32)};
    }
    static HWY_INLINE VF valueAt(const std::vector<float>& values, std::size_t i) {
        return hn::LoadU(F(), values.data() + i * kStride + 48);
    }
    static HWY_INLINE void put(std::vector<float>& values, std::size_t& count, const Vec3& vector,
                               VF value) {
        float* to = values.data() + count++ * kStride;
        hn::StoreU(vector.x, F(), to);
        hn::StoreU(vector.y, F(), to + 16);
        hn::StoreU(vector.z, F(), to + 32);
        hn::StoreU(value, F(), to + 48);
    }
    HWY_INLINE void addSphere(std::size_t i, const Start& start, VU marks,
                              std::vector<float>& values, std::size_t& count) {
        const Vec3 toCentre = centreOf(scene_, i) - start.point;
        const VF power = powerOf(scene_, i, toCentre, start);
        put(values, count, toCentre, hn::IfThenElse(markedLanes(marks, i), power, all(kNowhere)));
    }
    HWY_INLINE void addPlane(std::size_t i, const Start& start, VU marks) {
        const Vec3 normal = all3(scene_.planes.x[i], scene_.planes.y[i], scene_.planes.z[i]);
        put(scratch_.plane, planes_, normal,
            hn::IfThenElseZero(markedLanes(marks, i), heightAbove(scene_, i, start)));
    }

    const SceneSoA& scene_;
    OccluderScratch& scratch_;
    std::size_t nears_ = 0, others_ = 0, planes_ = 0;
};

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

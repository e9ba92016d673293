#ifndef TICKER_ORACLE_WORKSPACE_H
#define TICKER_ORACLE_WORKSPACE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::oracle {

/// Paths that are worked on together, one array for each property; small enough for the innermost
/// caches. Arrays have room for one widest vector behind the last path.
inline constexpr std::size_t kPaths = 512;
inline constexpr std::size_t kPathRoom = kPaths + 16;

template <typename T>
struct alignas(64) Lanes : std::array<T, kPathRoom> {};

struct Lanes3 {
    Lanes<float> x, y, z;
};

/// Room for the objects that may shade one vector of points; 16 values for each coordinate.
struct OccluderScratch {
    static constexpr std::size_t kStride = std::size_t{4} * 16;
    std::vector<float> near, other, plane;

    void reserve(std::size_t spheres, std::size_t planes) {
        near.resize(spheres * kStride);
        other.resize(spheres * kStride);
        plane.resize(planes * kStride);
    }
};

/// Points whose share of a light is not known yet, close together.
struct ShadowQueue {
    std::size_t size = 0;
    Lanes3 start;  ///< of shadow rays
    Lanes<float> clearance;
    Lanes<std::int32_t> object;
    Lanes<std::uint32_t> slot;
    Lanes<std::uint32_t> nearSpheres, otherSpheres, planes;  ///< see Occluders
};

/// One light at one hit of each path.
struct LightWork {
    Lanes3 contribution;       ///< where all of the light arrives
    Lanes<float> share;        ///< of the light that arrives
    Lanes<float> pairedShare;  ///< an independent second estimate, or the same exact value
    Lanes<float> shareNoise;   ///< variance of a student's share
    ShadowQueue queue;         ///< points that need shadow rays
    ShadowQueue singles;       ///< points with one occluder, whose share has a closed form
};

/// What one thread works in. Slot i of every array belongs to path i.
struct Workspace {
    std::size_t paths = 0;  ///< slots in use

    // Asked for by the caller.
    Lanes<std::int32_t> column, row;     ///< of the path's pixel in the rendered region
    Lanes<std::uint32_t> sample;         ///< number of the path in its pixel
    Lanes<std::uint32_t> randomisation;  ///< equal for all paths that share one lattice shift

    // The ray under way.
    Lanes3 origin, direction;
    Lanes<float> weight;         ///< what the next colour counts; 0 ends the path
    Lanes<std::int32_t> object;  ///< that the ray left; -1: the lens
    Lanes<float> clearance;      ///< height of its origin above that object

    std::vector<LightWork> lights;  ///< one for each light of the scene
    OccluderScratch occluders;

    // Given back: the colour of each path.
    std::array<Lanes<float>, 3> colour, pairedColour;
    std::array<Lanes<float>, 6> noise;  ///< covariance that shadow rays add: rr gg bb rg rb gb
};

}  // namespace ticker::oracle

#endif

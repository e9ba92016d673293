#ifndef TICKER_ORACLE_WORKSPACE_H
#define TICKER_ORACLE_WORKSPACE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::oracle {

/// Number of paths that are processed together, one array for each property; small enough for the
/// L1 and L2 caches. Arrays have room for one widest vector behind the last path.
inline constexpr std::size_t kPaths = 512;
inline constexpr std::size_t kPathRoom = kPaths + 16;

template <typename T>
struct alignas(64) Lanes : std::array<T, kPathRoom> {};

struct Lanes3 {
    Lanes<float> x, y, z;
};

/// Scratch space for the objects that may shade one vector of points; 16 values for each
/// coordinate.
struct OccluderScratch {
    static constexpr std::size_t kStride = std::size_t{4} * 16;
    std::vector<float> near, other, plane;

    void reserve(std::size_t spheres, std::size_t planes) {
        near.resize(spheres * kStride);
        other.resize(spheres * kStride);
        plane.resize(planes * kStride);
    }
};

/// Points of one light whose visible share is not known yet, stored contiguously.
struct ShadowQueue {
    std::size_t size = 0;
    Lanes3 contribution;  ///< of the unshadowed light
    Lanes3 start;         ///< of shadow rays
    Lanes<float> clearance;
    Lanes<std::int32_t> object;
    Lanes<std::uint32_t> slot;
    Lanes<std::uint32_t> nearSpheres, otherSpheres, planes;  ///< see Occluders
};

/// Points of one light that cone tests leave undecided.
struct LightWork {
    ShadowQueue queue;    ///< points that need shadow rays
    ShadowQueue singles;  ///< points with one occluder, whose share has a closed form
};

/// Working memory of one thread. Slot i of every array belongs to path i.
struct Workspace {
    std::size_t paths = 0;  ///< slots in use

    // Input of a call.
    Lanes<std::int32_t> column, row;     ///< of the path's pixel in the rendered region
    Lanes<std::uint32_t> sample;         ///< number of the path in its pixel
    Lanes<std::uint32_t> randomisation;  ///< equal for all paths with the same lattice shift

    // The current ray.
    Lanes3 origin, direction;
    Lanes<float> weight;         ///< weight of the next colour; 0 ends the path
    Lanes<std::int32_t> object;  ///< the one that the ray starts on; -1: the lens
    Lanes<float> clearance;      ///< height of the ray's origin above that object

    std::vector<LightWork> lights;  ///< one for each light of the scene
    OccluderScratch occluders;

    // Output: the colour of each path.
    std::array<Lanes<float>, 3> colour, pairedColour;
    std::array<Lanes<float>, 6> noise;  ///< covariance that shadow rays add: rr gg bb rg rb gb
};

}  // namespace ticker::oracle

#endif

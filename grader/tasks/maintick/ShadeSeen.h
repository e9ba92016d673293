#ifndef TICKER_TASKS_MAINTICK_SHADESEEN_H
#define TICKER_TASKS_MAINTICK_SHADESEEN_H

#include <grader/tasks/maintick/ShadeCases.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ticker::tasks::maintick {

/// What an answer equals, other than the right value.
enum class Shown : std::uint8_t { right, lit, dark, black, specular, diffuse, other };

/// What the same code gives with and without what stands around the point.
struct ShadeSeen {
    const ShadeCase* asked = nullptr;
    ColourRGB given;
    /// Of the point that floats; if that is dark, of the one on its surface with nothing around.
    ColourRGB lit;
    ColourRGB dark;
    ColourRGB putOut;    ///< dark as well, see ShadeCase
    ColourRGB specular;  ///< free, without diffuse light
    ColourRGB diffuse;   ///< free, without specular light
    double bias = 0.0;   ///< of the ray that starts farthest from the point; 0: none was seen
    /// The largest cosine between a ray that starts near the point and the way to a light; empty:
    /// no such ray was seen.
    std::optional<double> aim{};

    [[nodiscard]] ColourRGB expected() const;
    [[nodiscard]] Shown shown() const;
};

/// The name of what is wrong at `first`, from what goes wrong elsewhere, and its hint; empty: the
/// finding's own.
[[nodiscard]] std::pair<const FindingText*, std::string> nameOf(const std::vector<ShadeSeen>& seen,
                                                                const ShadeSeen& first);

}  // namespace ticker::tasks::maintick

#endif

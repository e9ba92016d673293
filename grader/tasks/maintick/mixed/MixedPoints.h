#ifndef TICKER_TASKS_MAINTICK_MIXED_MIXEDPOINTS_H
#define TICKER_TASKS_MAINTICK_MIXED_MIXEDPOINTS_H

#include <grader/tasks/maintick/LitSetups.h>
#include <grader/tasks/support/Deck.h>

#include <cstdint>
#include <vector>

namespace ticker::tasks::maintick {

// Scenes whose attributes are drawn one by one, each from a short list of ordinary and extreme
// values: a condition that code has on one of them, or on two, shows.

/// A point of such a scene.
struct MixedPoint {
    /// The point floats above a small ball of the object's material: nothing hides a light.
    LitSetup alone;
    bool isOnPlane = false;
    raytracer::SceneDescription scene = {};  ///< the same lights; the point lies on `object`
    int object = 0;                          ///< spheres first, then planes
};

/// Materials with values from decks.
class MixedMaterials {
public:
    explicit MixedMaterials(Draw& draw);
    [[nodiscard]] raytracer::Material deal();

private:
    enum class Paint : std::uint8_t { any, oneBlack, black };

    Draw* draw_;
    Deck<Paint> paint_;
    Deck<double> kd_;
    Deck<double> ks_;
    Deck<double> alpha_;
    Deck<double> reflectivity_;
};

/// A number from `low` to `high`, uniform in its logarithm.
[[nodiscard]] double logBetween(Draw& draw, double low, double high);

/// Where something is in the world.
enum class Region : std::uint8_t { usual, behindCamera, negative, farOff };
[[nodiscard]] Vector3 placeIn(Draw& draw, Region region);

/// Points with their lights, alone in the scene but for their object.
class MixedPoints {
public:
    /// @param lights  How many, for a deck.
    /// @param hasLow  Whether some of them all but graze the surface.
    MixedPoints(Draw& draw, std::vector<int> lights, bool hasLow);
    /// A point whose cosines are well away from 0, and whose colour single precision gets right.
    [[nodiscard]] MixedPoint deal();

private:
    enum class Hue : std::uint8_t { white, oneChannel, any };
    enum class Side : std::uint8_t { front, low, behind };
    enum class View : std::uint8_t { highlight, anywhere, straight };

    struct LightPlan {
        double nearest;  ///< the distance is up to three times that
        Hue hue;
        Side side;
    };
    struct Plan {
        raytracer::Material material;
        Region region;
        double brightness;
        bool hasAmbient;
        View view;
        std::vector<LightPlan> lights;
    };

    [[nodiscard]] Plan plan();
    [[nodiscard]] LitSetup place(const Plan& plan);
    void addLight(LitSetup& setup, const Plan& plan, const LightPlan& light);
    [[nodiscard]] Vector3 viewerOf(const LitSetup& setup, View view);
    [[nodiscard]] ColourRGB colourOf(Hue hue);

    Draw* draw_;
    MixedMaterials materials_;
    Deck<Region> region_;
    Deck<double> brightness_;
    Deck<bool> hasAmbient_;
    Deck<View> view_;
    Deck<bool> isPlane_;
    Deck<int> lights_;
    Deck<double> distance_;
    Deck<Hue> hue_;
    Deck<Side> side_;
};

/// Puts objects around a point, and its own among them at any place of the lists.
void assemble(Draw& draw, MixedPoint& point, std::vector<raytracer::SphereDescription> spheres,
              std::vector<raytracer::PlaneDescription> planes);

/// The questions of M2: no other object is near the way to a light that is in front, nor beyond
/// that light.
[[nodiscard]] std::vector<MixedPoint> drawMixedPoints(std::uint64_t seed);

}  // namespace ticker::tasks::maintick

#endif

#ifndef TICKER_TASKS_SHADOWS_MIXED_MIXEDDECKS_H
#define TICKER_TASKS_SHADOWS_MIXED_MIXEDDECKS_H

#include <grader/tasks/support/Deck.h>

#include <raytracer/geometry/Material.h>

#include <cstdint>

namespace ticker::tasks {

enum class Tint : std::uint8_t { usual, white, oneChannel, withoutOne, black };
enum class PlaceKind : std::uint8_t { inView, behindCamera, aside };
enum class LightSide : std::uint8_t { inFront, behind };
enum class Shape : std::uint8_t { ball, plane };
enum class Company : std::uint8_t { none, before, behind, both };
enum class ViewerKind : std::uint8_t { mirrored, onLens, anywhere };

/// A colour of this kind, of channels in [low, high).
[[nodiscard]] ColourRGB tinted(Draw& draw, Tint tint, double low, double high);

/// Materials, usual and extreme.
class MaterialDecks {
public:
    [[nodiscard]] raytracer::Material next(Draw& draw);

private:
    Deck<Tint> tint_{
        {Tint::usual, Tint::usual, Tint::white, Tint::oneChannel, Tint::withoutOne, Tint::black}};
    Deck<Between> phongKD_{{{0.5, 0.95}, {0.5, 0.95}, {0.0, 0.0}, {1.5, 2.5}}};
    Deck<Between> phongKS_{{{0.7, 1.4}, {0.7, 1.4}, {0.0, 0.0}}};
    Deck<Between> phongAlpha_{{{6.0, 14.0}, {6.0, 14.0}, {1.0, 1.0}, {30.0, 50.0}}};
    Deck<Between> reflectivity_{{{0.1, 0.5}, {0.0, 0.0}, {0.95, 0.98}, {1.0, 1.0}}};
};

/// What scenes are made of, in random order.
struct MixedDecks {
    Deck<Between> distance;  ///< of a light from the point

    Deck<int> lights{{0, 1, 1, 1, 2, 2, 3, 5}};
    Deck<LightSide> side{
        {LightSide::inFront, LightSide::inFront, LightSide::inFront, LightSide::behind}};
    Deck<Between> level{{{0.7, 1.3}, {0.7, 1.3}, {0.0005, 0.003}, {10.0, 30.0}}};
    Deck<Tint> tint{{Tint::usual, Tint::usual, Tint::white, Tint::oneChannel}};
    Deck<Between> ambient{{{0.1, 0.5}, {0.0, 0.0}, {1.0, 2.0}}};
    Deck<Company> company{
        {Company::none, Company::before, Company::before, Company::behind, Company::both}};
    Deck<Shape> shape{{Shape::ball, Shape::ball, Shape::plane}};
    Deck<Between> ball{{{0.0, 0.0}, {0.0, 0.0}, {0.4, 0.5}, {2.0, 3.0}, {20.0, 30.0}}};
    Deck<PlaceKind> place{
        {PlaceKind::inView, PlaceKind::inView, PlaceKind::behindCamera, PlaceKind::aside}};
    Deck<ViewerKind> viewer{{ViewerKind::mirrored, ViewerKind::onLens, ViewerKind::anywhere}};
    MaterialDecks surface = {};
    MaterialDecks others = {};
};

}  // namespace ticker::tasks

#endif

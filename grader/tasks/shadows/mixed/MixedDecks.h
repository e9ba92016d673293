#ifndef TICKER_TASKS_SHADOWS_MIXED_MIXEDDECKS_H
#define TICKER_TASKS_SHADOWS_MIXED_MIXEDDECKS_H

#include <grader/tasks/support/Deck.h>
#include <grader/tasks/support/Surfaces.h>

#include <cstdint>

namespace ticker::tasks {

// Kinds of the attributes that each scene is drawn from.
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
    explicit MaterialDecks(Draw& draw) : draw_(draw) {}
    [[nodiscard]] raytracer::Material deal();

private:
    Draw& draw_;
    Deck<Tint> tint_{
        draw_,
        {Tint::usual, Tint::usual, Tint::white, Tint::oneChannel, Tint::withoutOne, Tint::black}};
    Deck<Between> phongKD_{draw_, {{0.5, 0.95}, {0.5, 0.95}, {0.0, 0.0}, {1.5, 2.5}}};
    Deck<Between> phongKS_{draw_, {{0.7, 1.4}, {0.7, 1.4}, {0.0, 0.0}}};
    Deck<Between> phongAlpha_{draw_, {{6.0, 14.0}, {6.0, 14.0}, {1.0, 1.0}, {30.0, 50.0}}};
    Deck<Between> reflectivity_{draw_, {{0.1, 0.5}, {0.0, 0.0}, {0.95, 0.98}, {1.0, 1.0}}};
};

/// What scenes are made of, in random order.
struct MixedDecks {
    Draw& draw;
    Deck<Between> distance;  ///< of a light from the point

    Deck<int> lights{draw, {0, 1, 1, 1, 2, 2, 3, 5}};
    Deck<LightSide> side{
        draw, {LightSide::inFront, LightSide::inFront, LightSide::inFront, LightSide::behind}};
    Deck<Between> level{draw, {{0.7, 1.3}, {0.7, 1.3}, {0.0005, 0.003}, {10.0, 30.0}}};
    Deck<Tint> tint{draw, {Tint::usual, Tint::usual, Tint::white, Tint::oneChannel}};
    Deck<Between> ambient{draw, {{0.1, 0.5}, {0.0, 0.0}, {1.0, 2.0}}};
    Deck<Company> company{
        draw, {Company::none, Company::before, Company::before, Company::behind, Company::both}};
    Deck<Shape> shape{draw, {Shape::ball, Shape::ball, Shape::plane}};
    Deck<Between> ball{draw, {{0.0, 0.0}, {0.0, 0.0}, {0.4, 0.5}, {2.0, 3.0}, {20.0, 30.0}}};
    Deck<PlaceKind> place{
        draw, {PlaceKind::inView, PlaceKind::inView, PlaceKind::behindCamera, PlaceKind::aside}};
    Deck<ViewerKind> viewer{draw, {ViewerKind::mirrored, ViewerKind::onLens, ViewerKind::anywhere}};
    MaterialDecks surface{draw};
    MaterialDecks others{draw};
};

}  // namespace ticker::tasks

#endif

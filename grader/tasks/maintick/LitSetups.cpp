#include <grader/tasks/maintick/LitSetups.h>

#include <algorithm>
#include <initializer_list>
#include <numbers>

namespace ticker::tasks::maintick {
namespace {

using raytracer::Material;

/// Where a light stands. `away` is in front of the surface, but R.V is negative: no highlight.
enum class Side : std::uint8_t { behind, away, inFront };

Vector3 towardsLightOf(const LitSetup& setup, std::size_t light) {
    return (setup.scene.pointLights[light].position() - setup.P).normalised();
}

/// Moves O so that R.V has this value for the first light.
void viewAt(Draw& draw, LitSetup& setup, double cosine) {
    const Vector3 mirrored = towardsLightOf(setup, 0).reflectIn(setup.N);
    const Perpendiculars sides = perpendicularsOf(mirrored);
    const double around = draw.between(0.0, 2.0 * std::numbers::pi);
    const Vector3 side = sides.first * std::cos(around) + sides.second * std::sin(around);
    const Vector3 V = mirrored * cosine + side * std::sqrt(1.0 - cosine * cosine);
    setup.O = setup.P + V * draw.between(1.7, 4.0);
}

/// R.V
double highlightOf(const LitSetup& setup, std::size_t light) {
    const Vector3 R = towardsLightOf(setup, light).reflectIn(setup.N);
    return R.dot((setup.O - setup.P).normalised());
}

/// N.V
double viewerFacing(const LitSetup& setup) {
    return (setup.O - setup.P).normalised().dot(setup.N);
}

void addLightAt(Draw& draw, LitSetup& setup, double facing, double distance, double intensity) {
    const Perpendiculars sides = perpendicularsOf(setup.N);
    const double around = draw.between(0.0, 2.0 * std::numbers::pi);
    const Vector3 side = sides.first * std::cos(around) + sides.second * std::sin(around);
    const Vector3 L = setup.N * facing + side * std::sqrt(1.0 - facing * facing);
    setup.scene.pointLights.emplace_back(setup.P + L * distance, draw.colour(0.3, 0.9), intensity);
}

Material& ownMaterial(LitSetup& setup) {
    return setup.scene.spheres[0].material;
}

LitQuestion lit(Draw& draw, LitKind kind, double distance) {
    LitQuestion question{kind, drawPoint(draw)};
    addLight(draw, question.setup, distance, 60.0 * distance);
    if (kind == LitKind::diffuse || kind == LitKind::specular)
        question.setup.scene.ambientLighting = ColourRGB{0.0};
    if (kind == LitKind::diffuse) ownMaterial(question.setup).phongKS = 0.0;
    if (kind == LitKind::specular) ownMaterial(question.setup).phongKD = 0.0;
    return question;
}

/// A highlight's rim: R.V is small, and the power so low that it still counts.
LitQuestion rimOfHighlight(Draw& draw) {
    while (true) {
        LitQuestion question = lit(draw, LitKind::specular, draw.between(1.5, 3.5));
        ownMaterial(question.setup).phongAlpha = 1.0;
        viewAt(draw, question.setup, draw.between(0.05, 0.15));
        if (viewerFacing(question.setup) > 0.2) return question;
    }
}

/// Where a highlight is brightest: ks (R.V)^alpha is above 1.15.
LitQuestion peakOfHighlight(Draw& draw) {
    LitQuestion question = lit(draw, LitKind::specular, draw.between(1.5, 3.5));
    ownMaterial(question.setup).phongKS = draw.between(1.25, 1.4);
    viewAt(draw, question.setup, draw.between(0.994, 0.999));
    return question;
}

/// A surface so shiny that a limit on alpha shows, such as that of a byte. In single precision R.V
/// is right to 4e-7, and its power to 1.2e-4.
LitQuestion shinyHighlight(Draw& draw) {
    LitQuestion question = lit(draw, LitKind::specular, draw.between(1.5, 3.5));
    question.kind = LitKind::shiny;
    ownMaterial(question.setup).phongAlpha = draw.whole(260, 300);
    viewAt(draw, question.setup, draw.between(0.994, 0.998));
    return question;
}

/// A coefficient of 2.5 to 3.5, to show code that treats it as a share and cuts it off at 1.
LitQuestion strong(Draw& draw, LitKind kind) {
    LitQuestion question = lit(draw, kind, draw.between(1.5, 3.5));
    const double coefficient = draw.between(2.5, 3.5);
    Material& material = ownMaterial(question.setup);
    (kind == LitKind::diffuse ? material.phongKD : material.phongKS) = coefficient;
    return question;
}

LitQuestion faint(Draw& draw) {
    LitQuestion question = lit(draw, LitKind::faint, draw.between(2.0, 3.0));
    dim(draw, question.setup);
    return question;
}

/// A light with one channel only.
LitQuestion pureLight(Draw& draw, double ColourRGB::*channel) {
    LitQuestion question = lit(draw, LitKind::pure, draw.between(1.5, 3.5));
    raytracer::PointLight& light = question.setup.scene.pointLights.at(0);
    ColourRGB colour;
    colour.*channel = draw.between(0.5, 0.9);
    light = {light.position(), colour, light.intensity()};
    return question;
}

/// A green light on a surface without green: only the highlight is visible.
LitQuestion otherColour(Draw& draw) {
    LitQuestion question = pureLight(draw, &ColourRGB::g);
    ownMaterial(question.setup).colour.g = 0.0;
    return question;
}

/// R.V is negative, and alpha is even, so that the power would be positive. With `isBelow`, N.L is
/// negative, too; otherwise the surface is lit in front and the viewer is behind it.
LitQuestion behind(Draw& draw, bool isBelow) {
    LitQuestion question{LitKind::behind, drawPoint(draw)};
    ownMaterial(question.setup).phongAlpha = 2.0 * draw.whole(1, 3);
    const double facing = draw.between(0.3, 0.8) * (isBelow ? -1.0 : 1.0);
    addLightAt(draw, question.setup, facing, draw.between(1.5, 3.0), 200.0);
    const double cosine = draw.between(-0.9, -0.6);
    do
        viewAt(draw, question.setup, cosine);
    while (!isBelow && viewerFacing(question.setup) > -0.2);
    return question;
}

LitQuestion several(Draw& draw, LitKind kind, int lights) {
    LitQuestion question{kind, drawPoint(draw)};
    addLight(draw, question.setup, draw.between(1.5, 3.0), 90.0);
    for (int i = 1; i < lights; ++i) {
        const double distance = draw.between(1.5, 3.0);
        addLightAt(draw, question.setup, draw.between(0.35, 0.9), distance, 110.0);
    }
    return question;
}

/// Lights behind the surface and in front of it, in the order of `places`. R.V is negative for
/// those behind, since accepted readings differ in whether they have a highlight. It is positive
/// for those in front, except `away`.
LitQuestion oneBehind(Draw& draw, std::initializer_list<Side> places) {
    constexpr double kOffEdge = 0.1;
    while (true) {
        LitQuestion question{LitKind::several, drawPoint(draw)};
        LitSetup& setup = question.setup;
        for (const Side side : places) {
            const double distance = draw.between(1.5, 3.0);
            addLightAt(draw, setup, draw.between(0.35, 0.9) * (side == Side::behind ? -1.0 : 1.0),
                       distance, 110.0);
        }
        const Vector3 towardsViewer = draw.directionAround(setup.N, 0.8);
        setup.O = setup.P + towardsViewer * draw.between(1.7, 4.0);
        const auto isOffEdge = [&, light = std::size_t{0}](Side side) mutable {
            const double highlight = highlightOf(setup, light++);
            return side == Side::inFront ? highlight > kOffEdge : highlight < -kOffEdge;
        };
        if (std::all_of(places.begin(), places.end(), isOffEdge)) return question;
    }
}

}  // namespace

LitSetup drawPoint(Draw& draw) {
    LitSetup setup;
    setup.P = {draw.between(-2.0, 2.0), draw.between(-2.0, 2.0), draw.between(3.0, 6.0)};
    setup.N = draw.direction();
    setup.O = setup.P + setup.N * 2.5;
    setup.scene.ambientLighting = draw.colour(0.05, 0.3);
    Material material;
    material.colour = draw.colour(0.15, 0.9);
    material.phongKD = draw.between(0.4, 0.7);
    material.phongKS = draw.between(0.9, 1.4);
    material.phongAlpha = draw.whole(5, 12);
    setup.scene.spheres.push_back({setup.P - setup.N * 3.0, 0.02, material, nullptr});
    return setup;
}

void dim(Draw& draw, LitSetup& setup) {
    constexpr double kFaint = 0.0005;
    setup.scene.ambientLighting = draw.colour(0.0002, 0.0004);
    raytracer::PointLight& light = setup.scene.pointLights.at(0);
    light = {light.position(), light.colour(), light.intensity() * kFaint};
}

void layOnSphere(LitSetup& setup, double radius, double height) {
    raytracer::SphereDescription& sphere = setup.scene.spheres[0];
    sphere.radius = radius;
    sphere.centre = setup.P - setup.N * (radius + height);
}

LitSetup onItsSurface(LitSetup setup) {
    layOnSphere(setup, 1.0, kRounding);
    return setup;
}

void addLight(Draw& draw, LitSetup& setup, double distance, double intensity) {
    addLightAt(draw, setup, draw.between(0.3, 0.8), distance, intensity);
    viewAt(draw, setup, draw.between(0.75, 0.93));
}

void addGrazingLight(Draw& draw, LitSetup& setup, double distance, double intensity) {
    addLightAt(draw, setup, draw.between(0.02, 0.04), distance, intensity);
    viewAt(draw, setup, draw.between(0.75, 0.93));
}

std::vector<LitQuestion> drawLitQuestions(std::uint64_t seed) {
    Draw draw{seed, 103};
    std::vector<LitQuestion> asked;
    for (int i = 0; i < 3; ++i) {
        asked.push_back({LitKind::ambient, drawPoint(draw)});
        asked.push_back(lit(draw, LitKind::diffuse, draw.between(1.5, 3.5)));
        asked.push_back(lit(draw, LitKind::specular, draw.between(1.5, 3.5)));
        asked.push_back(behind(draw, i == 1));
        asked.push_back(several(draw, LitKind::several, 2 + i % 2));
        asked.push_back(lit(draw, LitKind::all, i == 0 ? 0.5 : draw.between(2.5, 4.0)));
    }
    asked.push_back(lit(draw, LitKind::all, 3.0));
    LitQuestion bright{LitKind::bright, drawPoint(draw)};
    addLight(draw, bright.setup, 1.2, 4000.0);
    asked.push_back(bright);
    asked.push_back(lit(draw, LitKind::far, 120.0));
    asked.push_back(lit(draw, LitKind::far, 0.12));
    asked.push_back(rimOfHighlight(draw));
    asked.push_back(peakOfHighlight(draw));
    using enum Side;
    asked.push_back(oneBehind(draw, {behind, inFront}));
    asked.push_back(oneBehind(draw, {behind, inFront, inFront}));
    asked.push_back(oneBehind(draw, {inFront, behind, inFront}));
    asked.push_back(oneBehind(draw, {away, inFront}));
    constexpr int kManyLights = 20;  // more than fixed arrays have room for
    asked.push_back(several(draw, LitKind::many, kManyLights));
    asked.push_back(strong(draw, LitKind::diffuse));
    asked.push_back(strong(draw, LitKind::specular));
    asked.push_back(shinyHighlight(draw));
    asked.push_back(faint(draw));
    for (const auto channel : {&ColourRGB::r, &ColourRGB::g, &ColourRGB::b})
        asked.push_back(pureLight(draw, channel));
    asked.push_back(otherColour(draw));
    return asked;
}

probe::IlluminateQuestion questionOf(const LitSetup& setup) {
    probe::IlluminateQuestion question;
    question.scene = setup.scene;
    question.points.push_back({0, setup.P, setup.N, setup.O});
    return question;
}

}  // namespace ticker::tasks::maintick

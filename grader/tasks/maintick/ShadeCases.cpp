#include <grader/tasks/maintick/ShadeCases.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace ticker::tasks::maintick {
namespace {

Vector3 towards(const LitSetup& setup, std::size_t light = 0) {
    return (setup.scene.pointLights[light].position() - setup.P).normalised();
}

void hide(ShadeCase& made, std::size_t light) {
    auto& lights = made.without.scene.pointLights;
    lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(light));
    raytracer::PointLight& lamp = made.putOut.scene.pointLights[light];
    lamp = {lamp.position(), lamp.colour(), 0.0};
}

ShadeCase begun(Draw& draw, Occluder place, double distance) {
    ShadeCase made;
    made.place = place;
    made.free = drawPoint(draw);
    const auto add = place == Occluder::grazing ? addGrazingLight : addLight;
    // From far away as bright as from 4, so that its shadow counts beside the ambient light.
    add(draw, made.free, distance, 60.0 * distance * std::max(1.0, distance / 4.0));
    if (place == Occluder::ofFaintLight) dim(draw, made.free);
    made.asked = made.without = made.putOut = made.free;
    hide(made, 0);
    return made;
}

void addBall(LitSetup& setup, double along, double radius, std::size_t light = 0) {
    setup.scene.spheres.push_back({setup.P + towards(setup, light) * along, radius, {}, nullptr});
}

ShadeCase withBall(Draw& draw, Occluder place, double distance, double along, double radius) {
    ShadeCase made = begun(draw, place, distance);
    addBall(made.asked, along, radius);
    return made;
}

/// @param isParallel  The wall has the normal of the point's own surface.
ShadeCase behindWall(Draw& draw, bool isParallel) {
    ShadeCase made = begun(draw, Occluder::wall, 3.0);
    const Vector3 L = towards(made.asked);
    const Vector3 facing = draw.directionAround(L * -1.0, 0.4);
    made.asked.scene.planes.push_back(
        {made.asked.P + L * 1.5, isParallel ? made.asked.N : facing, {}});
    return made;
}

ShadeCase ofTwoBalls(Draw& draw, bool firstIsBeyond) {
    const double distance = draw.between(3.0, 4.0);
    ShadeCase made = begun(draw, Occluder::beforeAndBeyond, distance);
    const double beyond = distance + 1.0;
    addBall(made.asked, firstIsBeyond ? beyond : distance / 2.0, 0.3);
    addBall(made.asked, firstIsBeyond ? distance / 2.0 : beyond, 0.3);
    return made;
}

/// A case far from the origin of the world, where a bias proportional to the coordinates is large.
ShadeCase farOff(Draw& draw) {
    constexpr double kFarOff = 60.0;
    ShadeCase made = withBall(draw, Occluder::before, 3.0, 1.5, 0.3);
    const Vector3 way = draw.direction() * kFarOff;
    for (LitSetup* setup : {&made.free, &made.asked, &made.without, &made.putOut}) {
        setup->P += way;
        setup->O += way;
        for (auto& sphere : setup->scene.spheres)
            sphere.centre += way;
        for (raytracer::PointLight& light : setup->scene.pointLights)
            light = {light.position() + way, light.colour(), light.intensity()};
    }
    return made;
}

/// Two lights at right angles around the normal, one of them hidden.
ShadeCase ofTwo(Draw& draw, bool firstIsHidden) {
    ShadeCase made = begun(draw, firstIsHidden ? Occluder::ofFirstLight : Occluder::ofSecondLight,
                           draw.between(2.5, 3.5));
    const Vector3 L = towards(made.free);
    const Vector3 across = made.free.N.cross(L).normalised();
    const Vector3 second = (made.free.N + across).normalised();
    const ColourRGB colour = draw.colour(0.3, 0.9);
    made.free.scene.pointLights.emplace_back(made.free.P + second * draw.between(2.5, 3.5), colour,
                                             150.0);
    made.asked = made.without = made.putOut = made.free;
    hide(made, firstIsHidden ? 0 : 1);
    addBall(made.asked, 1.2, 0.2, firstIsHidden ? 0 : 1);
    return made;
}

ShadeCase betweenLights(Draw& draw) {
    ShadeCase made = begun(draw, Occluder::betweenLights, draw.between(6.0, 7.0));
    const double near = draw.between(1.4, 1.6);
    const ColourRGB colour = draw.colour(0.3, 0.9);
    made.free.scene.pointLights.emplace_back(made.free.P + towards(made.free) * near, colour,
                                             60.0 * near);
    made.asked = made.without = made.putOut = made.free;
    hide(made, 0);
    addBall(made.asked, 3.0, 0.3);
    return made;
}

/// A viewer on the side that the normal points to, near the highlight.
Vector3 viewerOutside(const LitSetup& setup) {
    const Vector3 R = towards(setup).reflectIn(setup.N);
    return setup.P + (R + setup.N * 0.4).normalised() * 2.5;
}

/// @param place  Itself or grazing.
ShadeCase ofItself(Draw& draw, Occluder place) {
    ShadeCase made = begun(draw, place, draw.between(2.0, 4.0));
    made.free.O = viewerOutside(made.free);
    made.asked.O = made.without.O = made.putOut.O = made.free.O;
    return made;
}

ShadeCase onSphere(Draw& draw, ShadeCase made, bool isSunk) {
    made.isSunk = isSunk;
    made.floating = made.free;
    const double radius = draw.between(0.4, 2.0);
    for (LitSetup* setup : {&made.free, &made.asked, &made.without, &made.putOut})
        layOnSphere(*setup, radius, isSunk ? -kRounding : kRounding);
    return made;
}

ShadeCase onPlane(Draw& draw, ShadeCase made, bool isSunk) {
    made.isSunk = isSunk;
    made.floating = made.free;
    made.object = static_cast<int>(made.asked.scene.spheres.size());
    const Vector3& N = made.free.N;
    const Vector3 below = N * (isSunk ? kRounding : -kRounding);
    const Vector3 along = perpendicularsOf(N).first * draw.between(-3.0, 3.0);
    for (LitSetup* setup : {&made.free, &made.asked, &made.without, &made.putOut})
        setup->scene.planes.push_back(
            {made.free.P + below + along, N, setup->scene.spheres[0].material});
    return made;
}

/// A light that is far away, and something at either end of the way to it. A tolerance of a
/// hundredth of the distance is about a whole unit there.
void addFar(Draw& draw, std::vector<ShadeCase>& cases, bool isSunk) {
    constexpr double kFar = 95.0;
    constexpr double kApart = 0.35;
    constexpr double kRadius = 0.08;
    for (ShadeCase& made :
         std::array{withBall(draw, Occluder::atPointOfFar, kFar, kApart, kRadius),
                    withBall(draw, Occluder::atFarLight, kFar, kFar - kApart, kRadius),
                    withBall(draw, Occluder::beyondFarLight, kFar, kFar + kApart, kRadius)})
        cases.push_back(onSphere(draw, std::move(made), isSunk));
}

/// Where a sphere contains the light or the point or both, and where light grazes the surface.
void addSurrounded(Draw& draw, std::vector<ShadeCase>& cases, bool isSunk) {
    const double distance = draw.between(3.0, 4.0);
    const double aside = draw.between(0.5, 0.7);
    for (ShadeCase& made :
         std::array{withBall(draw, Occluder::aroundLight, distance, distance, 0.4),
                    withBall(draw, Occluder::aroundLight, distance, distance + aside, 1.0),
                    withBall(draw, Occluder::aroundLight, distance, distance - aside, 1.0),
                    withBall(draw, Occluder::aroundPoint, distance, 0.0, 0.4),
                    withBall(draw, Occluder::aroundPoint, distance, aside, 1.0),
                    withBall(draw, Occluder::aroundBoth, distance, distance / 2.0, distance)})
        cases.push_back(onSphere(draw, std::move(made), isSunk));
    cases.push_back(onPlane(draw, ofItself(draw, Occluder::grazing), isSunk));
    cases.push_back(onSphere(draw, ofItself(draw, Occluder::grazing), isSunk));
}

}  // namespace

bool ShadeCase::isShaded() const {
    return place != Occluder::beyond && place != Occluder::farBeyond &&
           place != Occluder::backwards && place != Occluder::itself &&
           place != Occluder::aroundBoth && place != Occluder::grazing &&
           place != Occluder::beyondFarLight;
}

std::string_view wordsOf(Occluder place) {
    static constexpr std::array<std::string_view, 21> kWords{
        "something stands half-way to the light",
        "something stands between, 0.03 from the point",
        "something stands behind the light",
        "the light is 3 away, and something stands behind it, 5 away",
        "the light is 0.5 away, and something stands before it, 0.4 away",
        "the light is 3 away, and something stands before it, 2 away",
        "something stands on the side that looks away from the light",
        "of two lights the first is hidden",
        "of two lights the second is hidden",
        "a plane stands half-way to the light",
        "something stands half-way to the light, and something else behind the light",
        "there is nothing but the surface that the point lies on",
        "a sphere contains the light and not the point",
        "a sphere contains the point and not the light",
        "a sphere contains both the point and the light",
        "there is nothing but the surface, and the light stands one or two degrees above that",
        "the light is 95 away, and something stands between, 0.3 from the point",
        "the light is 95 away, and something stands 0.3 before it",
        "the light is 95 away, and something stands 0.3 behind it",
        "of two lights in one direction the far one is hidden, by something behind the near one",
        "the light is faint, and something stands half-way to it"};
    return kWords.at(static_cast<std::size_t>(place));
}

std::vector<ShadeCase> drawShadeCases(std::uint64_t seed) {
    Draw draw{seed, 104};
    std::vector<ShadeCase> cases;
    for (const bool isSunk : {false, true}) {
        const double distance = draw.between(3.0, 4.0);
        for (ShadeCase& made :
             std::array{withBall(draw, Occluder::before, distance, distance / 2.0, 0.3),
                        withBall(draw, Occluder::beyond, distance, distance + 1.0, 0.4),
                        withBall(draw, Occluder::farBeyond, 3.0, 5.5, 0.5),
                        withBall(draw, Occluder::close, 0.5, 0.43, 0.03),
                        withBall(draw, Occluder::between, 3.0, 2.4, 0.4),
                        withBall(draw, Occluder::backwards, distance, -1.5, 0.4),
                        withBall(draw, Occluder::near, distance, 0.06, 0.03),
                        behindWall(draw, false), behindWall(draw, true), ofTwo(draw, !isSunk),
                        ofTwoBalls(draw, !isSunk), betweenLights(draw), farOff(draw)})
            cases.push_back(onSphere(draw, std::move(made), isSunk));
    }
    constexpr int kOwnSurfaces = 24;
    for (int i = 0; i < kOwnSurfaces; ++i) {
        const bool isSunk = i / 2 % 2 == 1;
        cases.push_back(i % 2 == 0 ? onPlane(draw, ofItself(draw, Occluder::itself), isSunk)
                                   : onSphere(draw, ofItself(draw, Occluder::itself), isSunk));
    }
    for (const bool isSunk : {false, true})
        addSurrounded(draw, cases, isSunk);
    for (const bool isSunk : {false, true})
        addFar(draw, cases, isSunk);
    for (const bool isSunk : {false, true}) {
        const double distance = draw.between(3.0, 4.0);
        cases.push_back(onSphere(
            draw, withBall(draw, Occluder::ofFaintLight, distance, distance / 2.0, 0.3), isSunk));
    }
    return cases;
}

}  // namespace ticker::tasks::maintick

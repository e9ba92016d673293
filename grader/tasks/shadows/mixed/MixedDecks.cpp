#include <grader/tasks/shadows/mixed/MixedDecks.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace ticker::tasks {

ColourRGB tinted(Draw& draw, Tint tint, double low, double high) {
    ColourRGB colour = draw.colour(low, high);
    constexpr std::array kChannels{&ColourRGB::r, &ColourRGB::g, &ColourRGB::b};
    const auto channel = kChannels.at(static_cast<std::size_t>(draw.whole(0, 2)));
    ColourRGB only;
    only.*channel = colour.*channel;
    switch (tint) {
        case Tint::usual:
            break;
        case Tint::white:
            return ColourRGB{1.0};
        case Tint::oneChannel:
            return only;
        case Tint::withoutOne:
            colour.*channel = 0.0;
            break;
        case Tint::black:
            return ColourRGB{0.0};
    }
    return colour;
}

raytracer::Material MaterialDecks::deal() {
    raytracer::Material material;
    material.colour = tinted(draw_, tint_.deal(), 0.2, 0.9);
    material.phongKD = phongKD_.deal().number(draw_);
    material.phongKS = phongKS_.deal().number(draw_);
    material.phongAlpha = std::floor(phongAlpha_.deal().number(draw_));
    material.reflectivity = reflectivity_.deal().number(draw_);
    return material;
}

}  // namespace ticker::tasks

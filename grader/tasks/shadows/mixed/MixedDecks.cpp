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

raytracer::Material MaterialDecks::next(Draw& draw) {
    raytracer::Material material;
    material.colour = tinted(draw, tint_.next(draw), 0.2, 0.9);
    material.phongKD = drawFrom(phongKD_, draw);
    material.phongKS = drawFrom(phongKS_, draw);
    material.phongAlpha = std::floor(drawFrom(phongAlpha_, draw));
    material.reflectivity = drawFrom(reflectivity_, draw);
    return material;
}

}  // namespace ticker::tasks

#include <grader/lab/selftest/PictureTricks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace ticker::selftest {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

std::uint8_t byteOf(double value) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

Picture drawn(int width, int height, const std::function<Rgb(int x, int y)>& colourAt) {
    Picture picture{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const std::uint8_t byte : colourAt(x, y))
                picture.rgb.push_back(byte);
    return picture;
}

Rgb at(const ByteView& picture, int x, int y) {
    const std::size_t i =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
             static_cast<std::size_t>(x));
    return {picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]};
}

}  // namespace

Picture recoloured(const ByteView& picture,
                   const std::function<double(double value, int channel)>& change) {
    return drawn(picture.width, picture.height, [&](int x, int y) {
        Rgb colour = at(picture, x, y);
        for (int channel = 0; channel < 3; ++channel) {
            std::uint8_t& byte = colour[static_cast<std::size_t>(channel)];
            byte = byteOf(change(byte / 255.0, channel));
        }
        return colour;
    });
}

Picture inGrey(const ByteView& picture) {
    return drawn(picture.width, picture.height, [&](int x, int y) {
        const Rgb colour = at(picture, x, y);
        const std::uint8_t grey =
            byteOf((0.3 * colour[0] + 0.59 * colour[1] + 0.11 * colour[2]) / 255.0);
        return Rgb{grey, grey, grey};
    });
}

Picture withRedForBlue(const ByteView& picture) {
    return drawn(picture.width, picture.height, [&](int x, int y) {
        const Rgb colour = at(picture, x, y);
        return Rgb{colour[2], colour[1], colour[0]};
    });
}

Picture inAWindow(const ByteView& picture, int width, int height) {
    const int left = (width - picture.width) / 2;
    const int top = 2 * (height - picture.height) / 3;
    return drawn(width, height, [&](int x, int y) {
        const bool inside =
            x >= left && x < left + picture.width && y >= top && y < top + picture.height;
        if (inside) return at(picture, x - left, y - top);
        return y < top / 2 ? Rgb{50, 52, 60} : Rgb{235, 235, 238};
    });
}

Picture moved(const ByteView& picture, int right, int down) {
    return drawn(picture.width, picture.height, [&](int x, int y) {
        return at(picture, std::clamp(x - right, 0, picture.width - 1),
                  std::clamp(y - down, 0, picture.height - 1));
    });
}

Picture withANote(const ByteView& picture) {
    return drawn(picture.width, picture.height, [&](int x, int y) {
        const bool onNote = 20 * x > 16 * picture.width && 20 * x < 19 * picture.width &&
                            20 * y > 15 * picture.height && 20 * y < 18 * picture.height;
        return onNote ? Rgb{255, 240, 90} : at(picture, x, y);
    });
}

Picture photograph(int width, int height, std::uint64_t seed) {
    struct Wave {
        double across, down, phase, strength;
    };
    std::mt19937_64 generator{seed};
    const auto unit = [&] { return static_cast<double>(generator() >> 11U) * 0x1p-53; };
    std::vector<Wave> waves;
    for (int octave = 1; octave <= 32; octave *= 2)
        for (int i = 0; i < 6; ++i)
            waves.push_back({octave * (4.0 * unit() - 2.0) * 3.0,
                             octave * (4.0 * unit() - 2.0) * 3.0, 6.3 * unit(), 0.25 / octave});
    return drawn(width, height, [&](int x, int y) {
        double hill = 0.45;
        for (const Wave& wave : waves)
            hill += wave.strength *
                    std::sin(wave.across * x / width + wave.down * y / height + wave.phase);
        return Rgb{byteOf(hill), byteOf(0.2 + 0.7 * hill), byteOf(0.9 - 0.6 * hill)};
    });
}

}  // namespace ticker::selftest

#ifndef RAYTRACER_IMAGE_COLOURRGB_H
#define RAYTRACER_IMAGE_COLOURRGB_H

namespace raytracer {

/// A linear colour. Components are not clamped; a component `FF` in a scene file is 1.
struct ColourRGB {
    double r = 0.0;
    double g = 0.0;
    double b = 0.0;

    constexpr ColourRGB() = default;
    constexpr ColourRGB(double red, double green, double blue) : r(red), g(green), b(blue) {}
    /// Grey: all three components equal.
    constexpr explicit ColourRGB(double grey) : r(grey), g(grey), b(grey) {}

    constexpr ColourRGB& operator+=(const ColourRGB& o) {
        r += o.r;
        g += o.g;
        b += o.b;
        return *this;
    }
    constexpr ColourRGB& operator*=(double scale) {
        r *= scale;
        g *= scale;
        b *= scale;
        return *this;
    }
    constexpr ColourRGB& operator*=(const ColourRGB& o) {
        r *= o.r;
        g *= o.g;
        b *= o.b;
        return *this;
    }
    constexpr ColourRGB& operator/=(double divisor) {
        r /= divisor;
        g /= divisor;
        b /= divisor;
        return *this;
    }

    friend constexpr bool operator==(const ColourRGB&, const ColourRGB&) = default;
};

[[nodiscard]] constexpr ColourRGB operator+(const ColourRGB& a, const ColourRGB& b) {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
[[nodiscard]] constexpr ColourRGB operator-(const ColourRGB& a, const ColourRGB& b) {
    return {a.r - b.r, a.g - b.g, a.b - b.b};
}
/// Component by component: light of one colour on a surface of the other.
[[nodiscard]] constexpr ColourRGB operator*(const ColourRGB& a, const ColourRGB& b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}
[[nodiscard]] constexpr ColourRGB operator*(const ColourRGB& a, double scale) {
    return {a.r * scale, a.g * scale, a.b * scale};
}
[[nodiscard]] constexpr ColourRGB operator*(double scale, const ColourRGB& a) {
    return a * scale;
}
[[nodiscard]] constexpr ColourRGB operator/(const ColourRGB& a, double divisor) {
    return {a.r / divisor, a.g / divisor, a.b / divisor};
}

}  // namespace raytracer

#endif

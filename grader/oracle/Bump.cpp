#include <grader/oracle/Bump.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ticker::oracle {
namespace {

// Columns wrap round the sphere; rows are clamped at its poles.
double texel(const raytracer::HeightMap& map, int column, int row) {
    const int width = map.width();
    return map.at(((column % width) + width) % width, std::clamp(row, 0, map.height() - 1));
}

// Height at a position in texels; texel (i, j) covers [i, i + 1) x [j, j + 1).
double heightAt(const raytracer::HeightMap& map, BumpReading::Lookup lookup, double column,
                double row) {
    if (lookup == BumpReading::Lookup::nearest)
        return texel(map, static_cast<int>(std::floor(column)), static_cast<int>(std::floor(row)));
    const double left = std::floor(column - 0.5);
    const double top = std::floor(row - 0.5);
    const double right = column - 0.5 - left;
    const double down = row - 0.5 - top;
    const int i = static_cast<int>(left);
    const int j = static_cast<int>(top);
    return (1.0 - down) * ((1.0 - right) * texel(map, i, j) + right * texel(map, i + 1, j)) +
           down * ((1.0 - right) * texel(map, i, j + 1) + right * texel(map, i + 1, j + 1));
}

// Change of height over one texel along (alongColumns, alongRows), one of which is 1.
double slope(const raytracer::HeightMap& map, const BumpReading& reading, double column, double row,
             double alongColumns, double alongRows) {
    const auto height = [&](double steps) {
        return heightAt(map, reading.lookup, column + steps * alongColumns,
                        row + steps * alongRows);
    };
    switch (reading.difference) {
        case BumpReading::Difference::backward:
            return height(0.0) - height(-1.0);
        case BumpReading::Difference::central:
            return 0.5 * (height(1.0) - height(-1.0));
        case BumpReading::Difference::forward:
            break;
    }
    return height(1.0) - height(0.0);
}

double latitudeGain(BumpReading::LatitudeGain gain, double sine) {
    switch (gain) {
        case BumpReading::LatitudeGain::sine:
            return sine;
        case BumpReading::LatitudeGain::inverseSine:
            return 1.0 / std::max(sine, 1e-9);
        case BumpReading::LatitudeGain::constant:
            break;
    }
    return 1.0;
}

}  // namespace

std::array<double, 3> bumpedNormal(const raytracer::HeightMap& map, const BumpReading& reading,
                                   const double outwards[3]) {
    const double length = std::hypot(outwards[0], outwards[1], outwards[2]);
    const double x = outwards[0] / length;
    const double y = std::clamp(outwards[1] / length, -1.0, 1.0);
    const double z = outwards[2] / length;

    // Unit tangents to the right and downwards, as seen from the eye in front of the sphere.
    const double ring = std::sqrt(std::max(0.0, 1.0 - y * y));
    const double sine = ring > 0.0 ? x / ring : 0.0;  // of the longitude, 0 towards the eye
    const double cosine = ring > 0.0 ? -z / ring : 1.0;
    const double right[3] = {cosine, 0.0, sine};
    const double down[3] = {sine * y, -ring, -cosine * y};

    const double turn = std::atan2(sine, cosine) / (2.0 * std::numbers::pi);
    const double direction = reading.mirrored ? -1.0 : 1.0;
    const double u = reading.uOrigin + direction * turn;
    const double column = (u - std::floor(u)) * map.width();
    const double row = std::min(std::acos(y) / std::numbers::pi, 1.0 - 1e-12) * map.height();

    double tiltU = direction * reading.gainU * slope(map, reading, column, row, 1.0, 0.0) *
                   latitudeGain(reading.longitudeGain, ring);
    double tiltV = reading.gainV * slope(map, reading, column, row, 0.0, 1.0);
    if (reading.swapped) std::swap(tiltU, tiltV);
    std::array<double, 3> normal{x - tiltU * right[0] - tiltV * down[0],
                                 y - tiltU * right[1] - tiltV * down[1],
                                 z - tiltU * right[2] - tiltV * down[2]};
    const double scale = 1.0 / std::hypot(normal[0], normal[1], normal[2]);
    for (double& component : normal)
        component *= scale;
    return normal;
}

}  // namespace ticker::oracle

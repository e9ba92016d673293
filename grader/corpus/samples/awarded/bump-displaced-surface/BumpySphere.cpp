#include <raytracer/geometry/BumpySphere.h>

#include <cmath>

namespace raytracer {
namespace {

constexpr double kPi = 3.14159265358979323846;

int wrapped(int i, int n) { return ((i % n) + n) % n; }
int limited(int i, int n) { return i < 0 ? 0 : (i >= n ? n - 1 : i); }

double heightAt(const HeightMap& map, double azimuth, double elevation) {
    double s = (azimuth / (2 * kPi) + 0.25) * map.width() - 0.5;
    double t = (0.5 - elevation / kPi) * map.height() - 0.5;
    int i = static_cast<int>(std::floor(s)), j = static_cast<int>(std::floor(t));
    double a = s - i, b = t - j;
    auto h = [&](int x, int y) { return map.at(wrapped(x, map.width()), limited(y, map.height())); };
    return (1 - b) * ((1 - a) * h(i, j) + a * h(i + 1, j)) + b * ((1 - a) * h(i, j + 1) + a * h(i + 1, j + 1));
}

Vector3 bulged(const HeightMap& map, double azimuth, double elevation) {
    Vector3 out(std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
                std::cos(elevation) * std::sin(azimuth));
    return out * (1.0 + 0.02 * heightAt(map, azimuth, elevation));
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    Vector3 n = (position - centre()).normalised();
    if (std::abs(n.y) > 0.99999) return n;
    double az = std::atan2(n.z, n.x), el = std::asin(n.y);
    double da = 2 * kPi / heightMap().width(), de = kPi / heightMap().height();
    Vector3 along = bulged(heightMap(), az + da, el) - bulged(heightMap(), az - da, el);
    Vector3 up = bulged(heightMap(), az, el + de) - bulged(heightMap(), az, el - de);
    Vector3 result = along.cross(up).normalised();
    return result.dot(n) < 0 ? -result : result;
}

}  // namespace raytracer

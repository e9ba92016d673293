// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

// ported from my matlab prototype, so everything is 1-based here
struct Matlab {
    const HeightMap& m;
    int cols() const { return m.width(); }
    int rows() const { return m.height(); }
    int operator()(int r, int c) const { return (int)std::lround(m.at(c - 1, r - 1) * 255 / kBumpFactor); }
};

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Matlab im{heightMap()};
    Vector3 d = position - centre();
    Vector3 n = d * (1 / radius());
    n = n.normalised();
    double az = atan2(-n.x, n.z);                 // 0 at the back, grows to the right as seen from the camera side
    double el = asin(fmax(-1, fmin(1, n.y)));
    int c = 1 + (int)floor((az + std::numbers::pi) / (2 * std::numbers::pi) * im.cols());
    int r = 1 + (int)floor((std::numbers::pi / 2 - el) / std::numbers::pi * im.rows());
    if (c > im.cols()) c = 1;
    if (r > im.rows()) r = im.rows();
    int cn = c == im.cols() ? 1 : c + 1;
    int rn = r == im.rows() ? r : r + 1;
    // 5/255 per byte
    double gx = -(im(r, c) - im(r, cn)) * kBumpFactor / 255;
    double gy = -(im(r, c) - im(rn, c)) * kBumpFactor / 255;
    Vector3 e1(-cos(az), 0, -sin(az));
    Vector3 e2(-sin(az) * sin(el), -cos(el), cos(az) * sin(el));
    return (n - gx * e1 - gy * e2).normalised();
    // TASK T1 end
}

}  // namespace raytracer

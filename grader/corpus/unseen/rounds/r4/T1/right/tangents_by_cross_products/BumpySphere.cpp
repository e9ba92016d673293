// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 up(0, 1, 0);

    // In this world up x n ... tried it at the front: n = (0,0,-1), I want (1,0,0) to the right.
    // (0,1,0) x (0,0,-1) = (-1,0,0), so take it the other way round.
    Vector3 right = n.cross(up);
    if (right.magnitude() < 1e-9) right = Vector3(1, 0, 0);   // at the poles any will do
    right = right.normalised();
    // down: at the front (0,-1,0). right x n = (1,0,0) x (0,0,-1) = (0,1,0), so minus
    const Vector3 down = -(right.cross(n)).normalised();

    double u = 0.5 + std::atan2(n.x, -n.z) / (2 * M_PI);
    double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / M_PI;
    if (u >= 1) u = 0;
    if (v >= 1) v = 0.999999999;
    const int cx = (int)(u * heightMap().width());
    const int cy = (int)(v * heightMap().height());
    const int rx = cx == heightMap().width() - 1 ? 0 : cx + 1;
    const int by = cy == heightMap().height() - 1 ? cy : cy + 1;

    const double middle = heightMap().at(cx, cy);
    const double toTheRight = heightMap().at(rx, cy) - middle;
    const double below = heightMap().at(cx, by) - middle;

    Vector3 out = n - right * toTheRight - down * below;
    return out.normalised();
    // TASK T1 end
}

}  // namespace raytracer

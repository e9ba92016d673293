// Option 1, task T1.
// My v is the LATITUDE, it grows upwards (0 = south pole, 1 = north pole), so I need equation (3).
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const double PI = 3.14159265358979323846;

    // 1. smooth normal, u and v
    Vector3 n = Sphere::getNormalAt(position);
    double longitude = std::atan2(n.x, -n.z);                       // -PI .. PI, to the right
    double latitude = PI / 2 - std::acos(std::clamp(n.y, -1.0, 1.0));  // -PI/2 .. PI/2, upwards
    double u = (longitude + PI) / (2 * PI);
    double v = (latitude + PI / 2) / PI;

    // 2. tangents
    Vector3 Pu(std::cos(longitude), 0, std::sin(longitude));
    Vector3 Pv(-std::sin(latitude) * std::sin(longitude), std::cos(latitude),
               std::sin(latitude) * std::cos(longitude));

    // 3. slopes
    int w = heightMap().width();
    int h = heightMap().height();
    int col = (int)(u * w);
    if (col >= w) col = w - 1;
    int stepsUp = (int)(v * h);
    if (stepsUp >= h) stepsUp = h - 1;
    int row = h - 1 - stepsUp;  // row 0 is at the top

    int nextCol = col + 1;
    if (nextCol == w) nextCol = 0;
    int rowAbove = row > 0 ? row - 1 : 0;

    double Bu = heightMap().at(nextCol, row) - heightMap().at(col, row);
    double Bv = heightMap().at(col, rowAbove) - heightMap().at(col, row);

    // 4. tilt. at the front Pu = (1,0,0), Pv = (0,1,0): Pu x Pv = (0,0,1) = -n  ==> (3)
    Vector3 tilted = n - Bu * n.cross(Pv) + Bv * n.cross(Pu);
    return tilted.normalised();
    // TASK T1 end
}

}  // namespace raytracer

// Task T1 - bump mapping
// Ported from my Java solution of the printed handout
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    // Step 1: get smooth normal and the (u, v) coordinates
    Vector3 normal = Sphere::getNormalAt(position);
    double phi = std::atan2(normal.x, -normal.z);
    double theta = std::acos(std::clamp(normal.y, -1.0, 1.0));
    double u = (phi + std::numbers::pi) / (2 * std::numbers::pi);
    double v = theta / std::numbers::pi;

    // Step 2: P_u and P_v (partial derivatives, already unit vectors)
    Vector3 pu = Vector3(std::cos(phi), 0, std::sin(phi));
    Vector3 pv = Vector3(std::sin(phi) * std::cos(theta), -std::sin(theta),
                         -std::cos(phi) * std::cos(theta));

    // Step 3: current pixel minus pixel to the right / pixel below
    int bumpMapWidth = heightMap().width();
    int bumpMapHeight = heightMap().height();
    int currentX = std::min((int)(u * bumpMapWidth), bumpMapWidth - 1);
    int currentY = std::min((int)(v * bumpMapHeight), bumpMapHeight - 1);
    int nextX = (currentX + 1) % bumpMapWidth;
    int nextY = std::min(currentY + 1, bumpMapHeight - 1);
    double current = heightMap().at(currentX, currentY);
    double bu = current - heightMap().at(nextX, currentY);
    double bv = current - heightMap().at(currentX, nextY);

    // Step 4: the equation
    Vector3 bumped = normal + bu * normal.cross(pv) + bv * normal.cross(pu);
    return bumped.normalised();
    // TASK T1 end
}

}  // namespace raytracer

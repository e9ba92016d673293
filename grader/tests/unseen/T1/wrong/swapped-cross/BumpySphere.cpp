/*
 * T1 bump mapping
 */
#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <cmath>
#include <numbers>

using std::numbers::pi;

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    Vector3 N = Sphere::getNormalAt(position);
    double lng = atan2(N.x, -N.z);
    double lat = acos(std::clamp(N.y, -1.0, 1.0));

    Vector3 Pu{cos(lng), 0, sin(lng)};
    Vector3 Pv{sin(lng) * cos(lat), -sin(lat), -cos(lng) * cos(lat)};
    Vector3 Nu = N.cross(Pu);
    Vector3 Nv = N.cross(Pv);

    auto& hm = heightMap();
    int x = std::clamp(int((lng / pi + 1) / 2 * hm.width()), 0, hm.width() - 1);
    int y = std::clamp(int(lat / pi * hm.height()), 0, hm.height() - 1);
    double h0 = hm.at(x, y);
    double hu = hm.at(x + 1 < hm.width() ? x + 1 : 0, y) - h0;
    double hv = hm.at(x, y + 1 < hm.height() ? y + 1 : y) - h0;

    return (N + hu * Nu - hv * Nv).normalised();
    // TASK T1 end
}

}  // namespace raytracer

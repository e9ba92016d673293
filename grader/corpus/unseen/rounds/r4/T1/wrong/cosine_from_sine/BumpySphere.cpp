#include <raytracer/geometry/BumpySphere.h>

#include <cmath>

namespace raytracer {

static const double TWO_PI = 6.283185307179586;

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    Vector3 N = Sphere::getNormalAt(position);
    double y = N.y;
    if (y > 1) y = 1;
    if (y < -1) y = -1;
    double polar = acos(y);
    double lon = atan2(N.x, -N.z);

    // sin and cos, one of them by Pythagoras because that is faster
    double sinP = sin(polar);
    double cosP = sqrt(1 - sinP * sinP);
    double sinL = sin(lon);
    double cosL = cos(lon);

    int nu = heightMap().width();
    int nv = heightMap().height();
    int iu = (int)((lon / TWO_PI + 0.5) * nu);
    int iv = (int)(polar * 2 / TWO_PI * nv);
    if (iu > nu - 1) iu = nu - 1;
    if (iv > nv - 1) iv = nv - 1;
    int ju = iu + 1;
    if (ju > nu - 1) ju = 0;
    int jv = iv + 1;
    if (jv > nv - 1) jv = nv - 1;

    double du = heightMap().at(ju, iv) - heightMap().at(iu, iv);
    double dv = heightMap().at(iu, jv) - heightMap().at(iu, iv);
    Vector3 tu(cosL, 0, sinL);
    Vector3 tv(sinL * cosP, -sinP, -cosL * cosP);
    return (N - du * tu - dv * tv).normalised();
}

}  // namespace raytracer

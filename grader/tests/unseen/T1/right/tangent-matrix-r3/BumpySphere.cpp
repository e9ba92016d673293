#include <raytracer/geometry/BumpySphere.h>
#include <algorithm>
#include <array>
#include <cmath>

using namespace std;

namespace raytracer {

typedef array<double, 3> float3;   // HLSL habits

template <int S> static float3 mul(const float3& v, const array<float3, S>& m) {
    float3 o{};
    for (int i = 0; i < S; i++)
        for (int k = 0; k < 3; k++) o[k] += v[i] * m[i][k];
    return o;
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 N = Sphere::getNormalAt(position);
    const double PI = acos(-1.0);
    const double rho = sqrt(N.x * N.x + N.z * N.z);
    // tangent frame without any trigonometry
    const double ct = rho > 1e-9 ? -N.z / rho : 1, st = rho > 1e-9 ? N.x / rho : 0;
    const array<float3, 3> TBN{{ {ct, 0, st}, {st * N.y, -rho, -ct * N.y}, {N.x, N.y, N.z} }};

    const int W = heightMap().width(), H = heightMap().height();
    int ix = (int)((atan2(st, ct) / PI * 0.5 + 0.5) * W);
    int iy = (int)(acos(min(max(N.y, -1.0), 1.0)) / PI * H);
    ix = min(ix, W - 1);
    iy = min(iy, H - 1);
    auto hgt = [&](int dx, int dy) { return heightMap().at((ix + dx) % W, min(iy + dy, H - 1)); };

    float3 ts{hgt(0, 0) - hgt(1, 0), hgt(0, 0) - hgt(0, 1), 1.0};
    const double il = 1 / sqrt(ts[0] * ts[0] + ts[1] * ts[1] + ts[2] * ts[2]);
    for (double& t : ts) t *= il;
    const float3 w = mul<3>(ts, TBN);
    return Vector3(w[0], w[1], w[2]).normalised();
    // TASK T1 end
}

}  // namespace raytracer

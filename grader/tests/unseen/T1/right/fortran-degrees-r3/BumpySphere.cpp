// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#define RAD(D) ((D) * 3.14159265358979323846 / 180.0)

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    double A, B, U, V, BU, BV, S, T, X, Y, Z, L;
    int I, J, K, M, NX, NY;
    Vector3 Q;

    Q = Sphere::getNormalAt(position);
    NX = heightMap().width();
    NY = heightMap().height();
    A = std::atan2(Q.x, -Q.z) / RAD(1.0);
    S = Q.y;
    if (S > 1.0) S = 1.0;
    if (S < -1.0) S = -1.0;
    B = std::acos(S) / RAD(1.0);
    U = (A + 180.0) / 360.0;
    V = B / 180.0;
    I = (int)(U * NX);
    if (I == NX) I = NX - 1;
    J = (int)(V * NY);
    if (J == NY) J = NY - 1;
    K = I + 1;
    if (K == NX) K = 0;
    M = J + 1;
    if (M == NY) goto LAST;
    BV = heightMap().at(I, M) - heightMap().at(I, J);
    goto CONT;
LAST:
    BV = 0.0;
CONT:
    BU = heightMap().at(K, J) - heightMap().at(I, J);
    T = std::cos(RAD(B));
    X = Q.x - BU * std::cos(RAD(A)) - BV * std::sin(RAD(A)) * T;
    Y = Q.y + BV * std::sin(RAD(B));
    Z = Q.z - BU * std::sin(RAD(A)) + BV * std::cos(RAD(A)) * T;
    L = std::sqrt(X * X + Y * Y + Z * Z);
    return Vector3(X / L, Y / L, Z / L);
    // TASK T1 end
}

}  // namespace raytracer

// SUBROUTINE STYLE: INDICES FROM 1, ONE LETTER EACH, HEIGHTS AS BYTES, COMPLEX LONGITUDE
#include <raytracer/geometry/BumpySphere.h>

#include <cmath>
#include <complex>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& P) const {
    // TASK T1 begin
    int I, J, K, L, M, N;
    double A, C, D, E, F, G, Q, R, S, T, X, Y, Z;
    // M columns, N rows
    M = heightMap().width();
    N = heightMap().height();
    // direction X, Y, Z
    X = P.x - centre().x;
    Y = P.y - centre().y;
    Z = P.z - centre().z;
    R = std::sqrt(X * X + Y * Y + Z * Z);
    X = X / R;
    Y = Y / R;
    Z = Z / R;
    if (Y > 1.0) Y = 1.0;
    if (Y < -1.0) Y = -1.0;
    // A: longitude, T: polar angle
    std::complex<double> W(-Z, X);
    A = std::arg(W);
    T = std::acos(Y);
    Q = 3.141592653589793;
    // texel (I, J), I = 1..M, J = 1..N
    I = 1 + int(std::floor(M * (0.5 + 0.5 * A / Q)));
    J = 1 + int(std::floor(N * T / Q));
    if (I > M) I = M;
    if (J > N) J = N;
    K = I + 1;
    if (K > M) K = 1;
    L = J + 1;
    if (L > N) L = N;
    // D: here, E: right, F: below, in whole bytes as the picture had them
    D = std::floor(heightMap().at(I - 1, J - 1) * 51.0 + 0.5);
    E = std::floor(heightMap().at(K - 1, J - 1) * 51.0 + 0.5);
    F = std::floor(heightMap().at(I - 1, L - 1) * 51.0 + 0.5);
    E = (E - D) / 51.0;
    F = (F - D) / 51.0;
    // tilt:  n - E * (cos A, 0, sin A) - F * (sin A cos T, -sin T, -cos A cos T)
    C = std::cos(A);
    S = std::sin(A);
    X = X - E * C - F * S * Y;
    G = std::sin(T);
    Y = Y + F * G;
    Z = Z - E * S + F * C * std::cos(T);
    R = std::sqrt(X * X + Y * Y + Z * Z);
    return {X / R, Y / R, Z / R};
    // TASK T1 end
}

}  // namespace raytracer

#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

//     SUBROUTINE TANGTS (XN, PU, PV, U, V)
static void TANGTS(const double XN[4], double PU[4], double PV[4], double& U, double& V) {
    const double PI = 4.0 * std::atan(1.0);
    double RHO, CL, SL;
    RHO = std::sqrt(XN[1] * XN[1] + XN[3] * XN[3]);
    if (RHO > 1.0E-12) {
        CL = -XN[3] / RHO;
        SL = XN[1] / RHO;
    } else {
        CL = 1.0;
        SL = 0.0;
    }
    U = 0.5 + std::atan2(SL, CL) / (2.0 * PI);
    V = std::atan2(RHO, XN[2]) / PI;
    PU[1] = CL;
    PU[2] = 0.0;
    PU[3] = SL;
    PV[1] = SL * XN[2];
    PV[2] = -RHO;
    PV[3] = -CL * XN[2];
}

//     REAL FUNCTION HGT (B, J, I): one-based, periodic in J, constant beyond the last I
static double HGT(const HeightMap& B, int J, int I) {
    int NC = B.width(), NR = B.height();
    if (J > NC) J = J - NC;
    if (I > NR) I = NR;
    return B.at(J - 1, I - 1);
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    double XN[4], PU[4], PV[4], Q[4], U, V, BU, BV, S;
    int I, J, K;
    const Vector3 N0 = Sphere::getNormalAt(position);
    XN[1] = N0.x;
    XN[2] = N0.y;
    XN[3] = N0.z;
    TANGTS(XN, PU, PV, U, V);
    J = (int)(U * heightMap().width()) + 1;
    I = (int)(V * heightMap().height()) + 1;
    if (J > heightMap().width()) J = heightMap().width();
    if (I > heightMap().height()) I = heightMap().height();
    BU = HGT(heightMap(), J + 1, I) - HGT(heightMap(), J, I);
    BV = HGT(heightMap(), J, I + 1) - HGT(heightMap(), J, I);
    S = 0.0;
    for (K = 1; K <= 3; K++) {
        Q[K] = XN[K] - BU * PU[K] - BV * PV[K];
        S = S + Q[K] * Q[K];
    }
    S = 1.0 / std::sqrt(S);
    return Vector3(S * Q[1], S * Q[2], S * Q[3]);
    // TASK T1 end
}

}  // namespace raytracer

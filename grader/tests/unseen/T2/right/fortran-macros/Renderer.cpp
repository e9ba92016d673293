/* DO LOOPS, ONE LETTER NAMES */
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <cmath>

#define DO(I, N) for (int I = 1; I <= (N); ++I)
#define RND randomBetween(-1.0, 1.0)
#define MAX0(A) ((A) > 0.0 ? (A) : 0.0)

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& S, const SceneObject& B, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB C = B.colour() * S.ambientLighting();
    Vector3 V = (O - P).normalised(), Q = P + N * kShadowBias;
    int M = int(S.pointLights().size()), K = settings().shadowRayCount;
    DO(J, M) {
        const PointLight& G = S.pointLights()[J - 1];
        // H RAYS ARRIVE
        double H = 0.0;
        DO(I, K) {
            Vector3 A{RND, RND, RND};
            while (A.magnitude() > 1.0) A = Vector3{RND, RND, RND};
            Vector3 W = G.position() + A * settings().lightSize - Q;
            auto X = S.findClosestIntersection(Ray{Q, W.normalised()});
            if (X && X->distance < W.magnitude()) continue;
            H += 1.0;
        }
        H /= K;
        Vector3 L = G.position() - P;
        double D = L.magnitude();
        L = L / D;
        ColourRGB E = G.illuminationAt(D);
        double F = MAX0(N.dot(L)) * B.phongKD();
        double R = std::pow(MAX0(L.reflectIn(N).dot(V)), B.phongAlpha()) * B.phongKS();
        C += B.colour() * E * (F * H);
        C += G.colour() * E * (R * H);
    }
    return C;
}

Image Renderer::render(const Scene& S) const {
    Camera C(settings());
    Image Z(settings());
    double A = settings().dofAmount, F = settings().dofFocalPlane;
    int N = settings().dofRayCount, B = settings().bounces;
    forEachPixel(Z, [&](int X, int Y) {
        Ray R = C.castRay(X, Y);
        Vector3 P{R.direction.x * F / R.direction.z, R.direction.y * F / R.direction.z, F};
        ColourRGB T(0.0);
        DO(I, N) {
            Vector3 E;
            E.x = A * RND;
            E.y = A * RND;
            T += trace(S, Ray{E, (P - E).normalised()}, B);
        }
        T /= N;
        Z.set(X, Y, T);
    });
    return Z;
}

}  // namespace raytracer

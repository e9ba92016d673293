// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <cstdio>

namespace raytracer {

// #define TESTAUSGABE

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 toViewer = (O - P).normalised();
    ColourRGB colour = object.colour() * scene.ambientLighting();

    for (const PointLight& light : scene.pointLights()) {
        const double distance = (light.position() - P).magnitude();
        const Vector3 toLight = (light.position() - P).normalised();
        const ColourRGB arriving = light.illuminationAt(distance);

        const double facing = std::max(0.0, N.dot(toLight));
        const ColourRGB diffuse = object.colour() * arriving * (object.phongKD() * facing);

        const double mirrored = std::max(0.0, toLight.reflectIn(N).dot(toViewer));
        const ColourRGB specular = light.colour() * arriving *
                                   (object.phongKS() * std::pow(mirrored, object.phongAlpha()));

        // TASK T2.1 begin
        float treffer = 0.0f;
        const float alle = (float)settings().shadowRayCount;
        const Vector3 Startpunkt = P + kShadowBias * N;   // ein Stueckchen ueber der Flaeche
        for (float s = 0; s < alle; s += 1.0f) {
            Vector3 Ziel = Vector3::randomInsideUnitSphere();
            Ziel *= settings().lightSize;
            Ziel += light.position();
            Vector3 Richtung = Ziel - Startpunkt;
            const double Laenge = Richtung.magnitude();
            Richtung /= Laenge;
            std::optional<RaycastHit> Hindernis = scene.findClosestIntersection(Ray(Startpunkt, Richtung));
            if (Hindernis.has_value() == false) { treffer++; continue; }
            if (Hindernis->distance < Laenge) continue;
            treffer++;
        }
        float anteil = treffer / alle;
#ifdef TESTAUSGABE
        printf("%f\n", anteil);
#endif
        colour += anteil * (diffuse + specular);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        Ray Mitte = camera.castRay(x, y);
        float t = (float)0; (void)t;
        double k = settings().dofFocalPlane / Mitte.direction.z;
        Vector3 Brennpunkt = Mitte.evaluateAt(k);
        ColourRGB Summe(0, 0, 0);
        int anzahl = 0;
        do {
            Vector3 Auge;
            Auge.x += randomBetween(-1, 1) * settings().dofAmount;
            Auge.y += randomBetween(-1, 1) * settings().dofAmount;
            Vector3 dir = (Brennpunkt - Auge).normalised();
            Summe += trace(scene, Ray(Auge, dir), settings().bounces);
        } while (++anzahl < settings().dofRayCount);
        Summe /= anzahl;
        image.set(x, y, Summe);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer

#include <grader/tasks/maintick/PhongModel.h>

#include <numbers>

namespace ticker::tasks::maintick {

ColourRGB phong(const LitSetup& setup, const PhongMistake* mistake) {
    PhongTerms t{setup, setup.scene.spheres[0].material};
    const auto after = [&](PhongStep step) {
        if (mistake != nullptr && mistake->step == step) mistake->change(t);
    };
    t.ambient = t.material.colour * setup.scene.ambientLighting;
    after(PhongStep::material);
    for (; t.light < setup.scene.pointLights.size(); ++t.light) {
        t.L = t.path().normalised();
        t.V = (setup.O - setup.P).normalised();
        t.distance = t.path().magnitude();
        after(PhongStep::ways);
        t.facing = setup.N.dot(t.L);
        t.mirrored = t.L.reflectIn(setup.N).dot(t.V);
        after(PhongStep::cosines);
        t.facing = std::max(0.0, t.facing);
        t.mirrored = std::max(0.0, t.mirrored);
        after(PhongStep::clamped);
        const double sphere = 4.0 * std::numbers::pi * t.distance * t.distance;
        t.arriving = t.lamp().colour() * (t.lamp().intensity() / sphere);
        t.share = t.material.phongKS * std::pow(t.mirrored, t.material.phongAlpha);
        t.ownDiffuse = t.material.colour * t.arriving * (t.material.phongKD * t.facing);
        t.ownSpecular = t.lamp().colour() * t.arriving * t.share;
        after(PhongStep::light);
        t.diffuse += t.ownDiffuse;
        t.specular += t.ownSpecular;
    }
    t.colour = t.ambient + (t.diffuse + t.specular);
    after(PhongStep::colour);
    return t.colour;
}

}  // namespace ticker::tasks::maintick

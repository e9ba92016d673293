#include <grader/tasks/maintick/PhongModel.h>

#include <numbers>

namespace ticker::tasks::maintick {
namespace {

using raytracer::Material;
using raytracer::PointLight;

Vector3 towardsLight(PhongMistake mistake, const LitSetup& setup, const PointLight& light) {
    const Vector3 path = light.position() - setup.P;
    if (mistake == PhongMistake::lightNotUnit) return path;
    if (mistake == PhongMistake::lightReversed) return -path.normalised();
    if (mistake == PhongMistake::lightFromWorldOrigin) return light.position().normalised();
    return path.normalised();
}

Vector3 towardsViewer(PhongMistake mistake, const LitSetup& setup) {
    const Vector3 path = setup.O - setup.P;
    if (mistake == PhongMistake::viewFromCamera) return (-setup.P).normalised();
    if (mistake == PhongMistake::viewReversed) return -path.normalised();
    if (mistake == PhongMistake::viewNotUnit) return path;
    if (mistake == PhongMistake::viewIsO) return setup.O.normalised();
    return path.normalised();
}

ColourRGB arriving(PhongMistake mistake, const LitSetup& setup, const PointLight& light) {
    double distance = (light.position() - setup.P).magnitude();
    if (mistake == PhongMistake::falloffMissing) distance = 1.0;
    if (mistake == PhongMistake::falloffLinear) distance = std::sqrt(distance);
    if (mistake == PhongMistake::falloffSquaredAgain) distance *= distance;
    if (mistake == PhongMistake::falloffFromViewer)
        distance = (light.position() - setup.O).magnitude();
    if (mistake == PhongMistake::falloffFromOrigin) distance = light.position().magnitude();
    const double sphere = mistake == PhongMistake::fourPiMissing ? 1.0 : 4.0 * std::numbers::pi;
    return light.colour() * (light.intensity() / (sphere * distance * distance));
}

double facing(PhongMistake mistake, const Vector3& N, const Vector3& L, const Vector3& V) {
    double cosine = N.dot(L);
    if (mistake == PhongMistake::normalTurned && N.dot(V) < 0.0) cosine = -cosine;
    if (mistake == PhongMistake::facingUnclamped || mistake == PhongMistake::bothUnclamped)
        return cosine;
    return mistake == PhongMistake::facingAbsolute ? std::abs(cosine) : std::max(0.0, cosine);
}

double mirrored(PhongMistake mistake, const Vector3& N, const Vector3& L, const Vector3& V) {
    double cosine = L.reflectIn(N).dot(V);
    if (mistake == PhongMistake::halfVector) cosine = N.dot((L + V).normalised());
    if (mistake == PhongMistake::mirrorOfView) cosine = -cosine;
    if (mistake == PhongMistake::cosineOfNandV) cosine = N.dot(V);
    if (mistake == PhongMistake::cosineOfLandV) cosine = L.dot(V);
    if (mistake == PhongMistake::mirroredUnclamped || mistake == PhongMistake::bothUnclamped)
        return cosine;
    return mistake == PhongMistake::mirroredAbsolute ? std::abs(cosine) : std::max(0.0, cosine);
}

ColourRGB diffuse(PhongMistake mistake, const Material& material, const PointLight& light,
                  const ColourRGB& I, double cosine) {
    if (mistake == PhongMistake::diffuseMissing) return {};
    double kd = material.phongKD;
    if (mistake == PhongMistake::coefficientsExchanged) kd = material.phongKS;
    if (mistake == PhongMistake::diffuseWithoutKd) kd = 1.0;
    ColourRGB colour = material.colour * I;
    if (mistake == PhongMistake::diffuseColourless) colour = I;
    if (mistake == PhongMistake::diffuseWithoutI) colour = material.colour;
    if (mistake == PhongMistake::diffuseLightTwice) colour = colour * light.colour();
    return colour * (kd * cosine);
}

ColourRGB specular(PhongMistake mistake, const Material& material, const PointLight& light,
                   const ColourRGB& I, double cosine) {
    if (mistake == PhongMistake::specularMissing) return {};
    double ks = material.phongKS;
    if (mistake == PhongMistake::coefficientsExchanged) ks = material.phongKD;
    if (mistake == PhongMistake::specularWithoutKs) ks = 1.0;
    double share = ks * std::pow(cosine, material.phongAlpha);
    if (mistake == PhongMistake::specularAlphaMissing) share = ks * cosine;
    if (mistake == PhongMistake::specularPowerOfAll)
        share = std::pow(ks * cosine, material.phongAlpha);
    if (mistake == PhongMistake::specularObjectColour) return material.colour * I * share;
    if (mistake == PhongMistake::specularLightOnce) return I * share;
    if (mistake == PhongMistake::specularWithoutI) return light.colour() * share;
    return light.colour() * I * share;
}

Material materialWith(PhongMistake mistake, const LitSetup& setup) {
    const Material& own = setup.scene.spheres[0].material;
    if (mistake != PhongMistake::defaultCoefficients) return own;
    Material usual;
    usual.colour = own.colour;
    return usual;
}

ColourRGB ambient(PhongMistake mistake, const LitSetup& setup) {
    const Material& material = setup.scene.spheres[0].material;
    const ColourRGB light = setup.scene.ambientLighting;
    const auto lights = static_cast<double>(setup.scene.pointLights.size());
    if (mistake == PhongMistake::ambientMissing) return {};
    if (mistake == PhongMistake::ambientColourless) return light;
    if (mistake == PhongMistake::ambientTimesKd) return material.colour * light * material.phongKD;
    return material.colour * light * (mistake == PhongMistake::ambientPerLight ? lights : 1.0);
}

}  // namespace

ColourRGB phongWith(PhongMistake mistake, const LitSetup& setup) {
    const Material material = materialWith(mistake, setup);
    if (mistake == PhongMistake::flat) return material.colour;
    const ColourRGB base = ambient(mistake, setup);
    if (mistake == PhongMistake::lightsMissing) return base;
    const Vector3 V = towardsViewer(mistake, setup);
    ColourRGB sum;
    ColourRGB highlights;
    constexpr double kFar = 10.0;
    for (const PointLight& light : setup.scene.pointLights) {
        const Vector3 path = light.position() - setup.P;
        if (mistake == PhongMistake::farLightsMissing && path.magnitude() > kFar) continue;
        const Vector3 L = towardsLight(mistake, setup, light);
        const ColourRGB I = arriving(mistake, setup, light);
        if (mistake == PhongMistake::lastLightOnly) sum = {};
        if (mistake == PhongMistake::lastLightOnly || mistake == PhongMistake::lastHighlightOnly)
            highlights = {};
        sum += diffuse(mistake, material, light, I, facing(mistake, setup.N, L, V));
        highlights += specular(mistake, material, light, I, mirrored(mistake, setup.N, L, V));
        if (mistake == PhongMistake::firstLightOnly) break;
    }
    sum += highlights;
    if (mistake == PhongMistake::averaged && !setup.scene.pointLights.empty())
        sum /= static_cast<double>(setup.scene.pointLights.size());
    const ColourRGB all = base + sum;
    if (mistake != PhongMistake::clamped) return all;
    return {std::min(1.0, all.r), std::min(1.0, all.g), std::min(1.0, all.b)};
}

}  // namespace ticker::tasks::maintick

#include <grader/tasks/maintick/PhongModel.h>

#include <numbers>

namespace ticker::tasks::maintick {
namespace {

using raytracer::Material;
using raytracer::PointLight;

Vector3 towardsLight(PhongSlip slip, const LitSetup& setup, const PointLight& light) {
    const Vector3 path = light.position() - setup.P;
    if (slip == PhongSlip::lightNotUnit) return path;
    if (slip == PhongSlip::lightReversed) return -path.normalised();
    if (slip == PhongSlip::lightFromWorldOrigin) return light.position().normalised();
    return path.normalised();
}

Vector3 towardsViewer(PhongSlip slip, const LitSetup& setup) {
    const Vector3 path = setup.O - setup.P;
    if (slip == PhongSlip::viewFromCamera) return (-setup.P).normalised();
    if (slip == PhongSlip::viewReversed) return -path.normalised();
    if (slip == PhongSlip::viewNotUnit) return path;
    if (slip == PhongSlip::viewIsO) return setup.O.normalised();
    return path.normalised();
}

ColourRGB arriving(PhongSlip slip, const LitSetup& setup, const PointLight& light) {
    double distance = (light.position() - setup.P).magnitude();
    if (slip == PhongSlip::falloffMissing) distance = 1.0;
    if (slip == PhongSlip::falloffLinear) distance = std::sqrt(distance);
    if (slip == PhongSlip::falloffSquaredAgain) distance *= distance;
    if (slip == PhongSlip::falloffFromViewer) distance = (light.position() - setup.O).magnitude();
    if (slip == PhongSlip::falloffFromOrigin) distance = light.position().magnitude();
    const double sphere = slip == PhongSlip::fourPiMissing ? 1.0 : 4.0 * std::numbers::pi;
    return light.colour() * (light.intensity() / (sphere * distance * distance));
}

double facing(PhongSlip slip, const Vector3& N, const Vector3& L, const Vector3& V) {
    double cosine = N.dot(L);
    if (slip == PhongSlip::normalTurned && N.dot(V) < 0.0) cosine = -cosine;
    if (slip == PhongSlip::facingUnclamped || slip == PhongSlip::bothUnclamped) return cosine;
    return slip == PhongSlip::facingAbsolute ? std::abs(cosine) : std::max(0.0, cosine);
}

double mirrored(PhongSlip slip, const Vector3& N, const Vector3& L, const Vector3& V) {
    double cosine = L.reflectIn(N).dot(V);
    if (slip == PhongSlip::halfVector) cosine = N.dot((L + V).normalised());
    if (slip == PhongSlip::mirrorOfView) cosine = -cosine;
    if (slip == PhongSlip::cosineOfNandV) cosine = N.dot(V);
    if (slip == PhongSlip::cosineOfLandV) cosine = L.dot(V);
    if (slip == PhongSlip::mirroredUnclamped || slip == PhongSlip::bothUnclamped) return cosine;
    return slip == PhongSlip::mirroredAbsolute ? std::abs(cosine) : std::max(0.0, cosine);
}

ColourRGB diffuse(PhongSlip slip, const Material& material, const PointLight& light,
                  const ColourRGB& I, double cosine) {
    if (slip == PhongSlip::diffuseMissing) return {};
    double kd = material.phongKD;
    if (slip == PhongSlip::coefficientsExchanged) kd = material.phongKS;
    if (slip == PhongSlip::diffuseWithoutKd) kd = 1.0;
    ColourRGB colour = material.colour * I;
    if (slip == PhongSlip::diffuseColourless) colour = I;
    if (slip == PhongSlip::diffuseWithoutI) colour = material.colour;
    if (slip == PhongSlip::diffuseLightTwice) colour = colour * light.colour();
    return colour * (kd * cosine);
}

ColourRGB specular(PhongSlip slip, const Material& material, const PointLight& light,
                   const ColourRGB& I, double cosine) {
    if (slip == PhongSlip::specularMissing) return {};
    double ks = material.phongKS;
    if (slip == PhongSlip::coefficientsExchanged) ks = material.phongKD;
    if (slip == PhongSlip::specularWithoutKs) ks = 1.0;
    double share = ks * std::pow(cosine, material.phongAlpha);
    if (slip == PhongSlip::specularAlphaMissing) share = ks * cosine;
    if (slip == PhongSlip::specularPowerOfAll) share = std::pow(ks * cosine, material.phongAlpha);
    if (slip == PhongSlip::specularObjectColour) return material.colour * I * share;
    if (slip == PhongSlip::specularLightOnce) return I * share;
    if (slip == PhongSlip::specularWithoutI) return light.colour() * share;
    return light.colour() * I * share;
}

Material materialWith(PhongSlip slip, const LitSetup& setup) {
    const Material& own = setup.scene.spheres[0].material;
    if (slip != PhongSlip::defaultCoefficients) return own;
    Material usual;
    usual.colour = own.colour;
    return usual;
}

ColourRGB ambient(PhongSlip slip, const LitSetup& setup) {
    const Material& material = setup.scene.spheres[0].material;
    const ColourRGB light = setup.scene.ambientLighting;
    const auto lights = static_cast<double>(setup.scene.pointLights.size());
    if (slip == PhongSlip::ambientMissing) return {};
    if (slip == PhongSlip::ambientColourless) return light;
    if (slip == PhongSlip::ambientTimesKd) return material.colour * light * material.phongKD;
    return material.colour * light * (slip == PhongSlip::ambientPerLight ? lights : 1.0);
}

}  // namespace

ColourRGB phongWith(PhongSlip slip, const LitSetup& setup) {
    const Material material = materialWith(slip, setup);
    if (slip == PhongSlip::flat) return material.colour;
    const ColourRGB base = ambient(slip, setup);
    if (slip == PhongSlip::lightsMissing) return base;
    const Vector3 V = towardsViewer(slip, setup);
    ColourRGB sum;
    ColourRGB highlights;
    constexpr double kFar = 10.0;
    for (const PointLight& light : setup.scene.pointLights) {
        const Vector3 path = light.position() - setup.P;
        if (slip == PhongSlip::farLightsMissing && path.magnitude() > kFar) continue;
        const Vector3 L = towardsLight(slip, setup, light);
        const ColourRGB I = arriving(slip, setup, light);
        if (slip == PhongSlip::lastLightOnly) sum = {};
        if (slip == PhongSlip::lastLightOnly || slip == PhongSlip::lastHighlightOnly)
            highlights = {};
        sum += diffuse(slip, material, light, I, facing(slip, setup.N, L, V));
        highlights += specular(slip, material, light, I, mirrored(slip, setup.N, L, V));
        if (slip == PhongSlip::firstLightOnly) break;
    }
    sum += highlights;
    if (slip == PhongSlip::averaged && !setup.scene.pointLights.empty())
        sum /= static_cast<double>(setup.scene.pointLights.size());
    const ColourRGB all = base + sum;
    if (slip != PhongSlip::clamped) return all;
    return {std::min(1.0, all.r), std::min(1.0, all.g), std::min(1.0, all.b)};
}

}  // namespace ticker::tasks::maintick

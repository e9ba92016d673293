#!/usr/bin/env python3
"""Writes the wrong submissions (w-) and the debatable ones (g-)."""
import pathlib, sys
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import make_right as k
from make_right import SHADOW, LENS, OWN, PERRAY, LOOPTRACE, HALTON, OLDLENS, OLDTARGET, shadowTarget, lensPoint
k.CASES.clear()
case = k.case
def s(old, new, text=SHADOW):
    assert old in text, old
    return text.replace(old, new)
def l(old, new, text=LENS):
    assert old in text, old
    return text.replace(old, new)
FRACTION = '(static_cast<double>(reached) / settings().shadowRayCount)'
ADD = 'colour += (diffuse + specular) * ' + FRACTION + ';'
# ------------------------------------------------------------ T2.1
case('w-integer-division', shadow=s(FRACTION, '(reached / settings().shadowRayCount)'))
case('w-ambient-shadowed', shadow=s(ADD, 'colour = (colour + diffuse + specular) * ' + FRACTION + ';'))
case('w-ambient-per-light', shadow=s(ADD, ADD + '\n        if (reached == 0) colour = ColourRGB{};'))
case('w-count-not-reset', shadow=s('int reached = 0;', '').replace(ADD, 'colour += (diffuse + specular) * std::min(1.0, static_cast<double>(reached) / settings().shadowRayCount);'),
     edit=[('ColourRGB colour = object', 'int reached = 0;\n    ColourRGB colour = object')])
case('w-mean-of-lights', edit=[('    return colour;\n}\n\nImage', '    colour = object.colour() * scene.ambientLighting() + (colour - object.colour() * scene.ambientLighting()) / std::max<double>(1.0, static_cast<double>(scene.pointLights().size()));\n    return colour;\n}\n\nImage')])
case('w-table-of-ten', inc='#include <vector>', pre='''
static std::vector<Vector3> makePoints(int n) { std::vector<Vector3> v; for (int i = 0; i < n; ++i) v.push_back(Vector3::randomInsideUnitSphere()); return v; }
''', shadow='        static const std::vector<Vector3> points = makePoints(settings().shadowRayCount);\n' + s('Vector3::randomInsideUnitSphere()', 'points[static_cast<std::size_t>(i) % points.size()]'))
case('w-engine-in-function', inc='#include <random>', shadow='        std::mt19937 rng(42);\n        std::uniform_real_distribution<double> u(-1, 1);\n' + s(OLDTARGET, '''            Vector3 r;
            do r = {u(rng), u(rng), u(rng)}; while (r.dot(r) > 1);
            const Vector3 target = light.position() + r * settings().lightSize;
'''))
case('w-halton-fixed', pre=HALTON, shadow=s(OLDTARGET, '            const unsigned n = static_cast<unsigned>(i) + 1;\n            const double a = radicalInverse(2, n), b = radicalInverse(3, n), c = radicalInverse(5, n);\n' + k.BALL3),
     lens=l(OLDLENS, '''            const unsigned n = static_cast<unsigned>(i) + 1;
            const Vector3 lens{settings().dofAmount * (2 * radicalInverse(2, n) - 1), settings().dofAmount * (2 * radicalInverse(3, n) - 1), 0.0};
'''))
case('w-one-point-ten-rays', shadow='        const Vector3 target = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;\n' + s(OLDTARGET, ''))
case('w-less-equal', shadow=s('i < settings().shadowRayCount', 'i <= settings().shadowRayCount'))
case('w-from-one', shadow=s('int i = 0', 'int i = 1'))
case('w-cube', shadow=shadowTarget('Vector3{randomBetween(-1, 1), randomBetween(-1, 1), randomBetween(-1, 1)} * settings().lightSize'))
case('w-positive-octant', shadow=shadowTarget('Vector3{randomBetween(0, 1), randomBetween(0, 1), randomBetween(0, 1)} * settings().lightSize'))
case('w-flat-offset', shadow=shadowTarget('Vector3{randomBetween(-1, 1), 0.0, randomBetween(-1, 1)} * settings().lightSize'))
case('w-disc-xy', shadow=s('            const Vector3 target', '            Vector3 r = Vector3::randomInsideUnitSphere();\n            r.z = 0;\n            const Vector3 target').replace('Vector3::randomInsideUnitSphere() * settings', 'r * settings'))
case('w-diameter', shadow=shadowTarget('Vector3::randomInsideUnitSphere() * (2 * settings().lightSize)'))
case('w-half-size', shadow=shadowTarget('Vector3::randomInsideUnitSphere() * (settings().lightSize / 2)'))
case('w-no-size', shadow=shadowTarget('Vector3::randomInsideUnitSphere()'))
case('w-line', shadow=shadowTarget('Vector3{1, 1, 1} * (randomBetween(-1, 1) * settings().lightSize)'))
case('w-polar-without-cbrt', shadow=s('            const Vector3 target', '''            const double phi = randomBetween(0, 2 * std::numbers::pi), theta = randomBetween(0, std::numbers::pi), r = randomBetween(0, 1);
            const Vector3 target''').replace('Vector3::randomInsideUnitSphere() * settings', 'Vector3{r * std::sin(theta) * std::cos(phi), r * std::cos(theta), r * std::sin(theta) * std::sin(phi)} * settings'))
case('w-any-hit-blocks', shadow=s('if (!hit || hit->distance > towards.magnitude())', 'if (!hit)'))
case('w-no-bias', shadow=s('P + N * kShadowBias', 'P'))
case('w-bias-inwards', shadow=s('P + N * kShadowBias', 'P - N * kShadowBias'))
case('w-squared-vs-plain', shadow=s('hit->distance > towards.magnitude()', 'hit->distance > towards.dot(towards)'))
case('w-unnormalised-plain', shadow=s('Ray{start, towards.normalised()}', 'Ray{start, towards}'))
case('w-last-ray-decides', shadow=s('++reached;', 'reached = settings().shadowRayCount;\n            else reached = 0;'))
case('w-add-in-loop', shadow=s('++reached;', '{ ++reached; colour += (diffuse + specular) * (static_cast<double>(reached) / settings().shadowRayCount); }').replace('        ' + ADD, ''))
case('w-specular-unshadowed', shadow=s(ADD, 'colour += diffuse * ' + FRACTION + ' + specular;'))
case('w-diffuse-unshadowed', shadow=s(ADD, 'colour += diffuse + specular * ' + FRACTION + ';'))
case('w-specular-if-any', shadow=s(ADD, 'colour += diffuse * ' + FRACTION + ';\n        if (reached > 0) colour += specular;'))
case('w-phong-no-max', shadow='        (void)diffuse; (void)specular;' + PERRAY.replace('std::max(0.0, N.dot(L))', 'N.dot(L)'))
case('w-phong-each-not-divided', shadow='        (void)diffuse; (void)specular;' + PERRAY.replace('gathered / settings().shadowRayCount', 'gathered'))
case('w-phong-object-coloured-gloss', shadow='        (void)diffuse; (void)specular;' + PERRAY.replace('light.colour() * I', 'object.colour() * I'))
case('w-phong-divide-by-hits', shadow='        (void)diffuse; (void)specular;\n        int n = 0;' + PERRAY.replace('            const Vector3 L =', '            ++n;\n            const Vector3 L =').replace('gathered / settings().shadowRayCount', '(n ? gathered / n : gathered)'))
case('w-centre-visible-is-lit', shadow='''        const auto first = scene.findClosestIntersection({P + N * kShadowBias, toLight});
        if (!first || first->distance > distance) { colour += diffuse + specular; continue; }
''' + SHADOW)
case('w-centre-hidden-is-dark', shadow='''        const auto first = scene.findClosestIntersection({P + N * kShadowBias, toLight});
        if (first && first->distance < distance) continue;
''' + SHADOW)
case('w-break-at-first-blocked', shadow=s('++reached;', '++reached;\n            else break;'))
case('w-half-threshold', shadow=s(ADD, 'if (2 * reached >= settings().shadowRayCount) colour += diffuse + specular;'))
case('w-jitter-direction', shadow=s(OLDTARGET, '').replace('const Vector3 towards = target - start;', 'const Vector3 towards = (toLight + Vector3::randomInsideUnitSphere() * settings().lightSize).normalised() * distance;'))
case('w-jitter-start', shadow=s('towards = target - start;', 'towards = target - start;\n            const Vector3 from = start + N * (settings().lightSize * randomBetween(0, 1));').replace('Ray{start,', 'Ray{from,'))
case('w-spheres-only', shadow=s('if (!hit ||', 'if (!hit || dynamic_cast<const Plane*>(hit->object) ||'))
case('w-own-skips-self', pre=OWN.replace('inline bool sees(const Scene& scene, V a, V b) {', 'inline bool sees(const Scene& scene, V a, V b, const SceneObject* self) {').replace('if (cuts(', 'if (thing.get() != self && cuts('), shadow=r'''
        int seen = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i)
            seen += own::sees(scene, own::from(P), own::from(light.position()) + settings().lightSize * own::from(Vector3::randomInsideUnitSphere()), &object);
        colour += (diffuse + specular) * (double(seen) / settings().shadowRayCount);''')
OWNSH = r'''
        const own::V here = own::from(P + N * kShadowBias);
        int seen = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i)
            seen += own::sees(scene, here, own::from(light.position()) + settings().lightSize * own::from(@R@));
        colour += (diffuse + specular) * (double(seen) / settings().shadowRayCount);'''
case('w-own-near-root-only', pre=OWN.replace('(t1 > 0 && t1 < 1) || (t2 > 0 && t2 < 1)', 't1 > 0'), shadow=OWNSH.replace('@R@', 'Vector3::randomInsideUnitSphere()'))
case('w-own-no-far-limit', pre=OWN.replace('(t1 > 0 && t1 < 1) || (t2 > 0 && t2 < 1)', 't2 > 0').replace('t > 0 && t < 1', 't > 0'), shadow=OWNSH.replace('@R@', 'Vector3::randomInsideUnitSphere()'))
case('w-own-cube', pre=OWN, shadow=OWNSH.replace('@R@', 'Vector3{randomBetween(-1, 1), randomBetween(-1, 1), randomBetween(-1, 1)}'))
case('w-own-first-object', pre=OWN.replace('        if (cuts(*thing, a, b)) return false;\n    return true;', '        return !cuts(*thing, a, b);\n    return true;'), shadow=OWNSH.replace('@R@', 'Vector3::randomInsideUnitSphere()'))
case('w-own-diameter', pre=OWN, shadow=OWNSH.replace('@R@', '(2.0 * Vector3::randomInsideUnitSphere())'))
case('w-own-surface', pre=OWN, shadow=OWNSH.replace('@R@', 'Vector3::randomInsideUnitSphere().normalised()'))
case('w-own-sphere-centre-hit', pre=OWN.replace('- s->radius() * s->radius()', '- s->radius()'), shadow=OWNSH.replace('@R@', 'Vector3::randomInsideUnitSphere()'))
case('w-light-minimum', shadow=s(ADD, 'colour += (diffuse + specular) * std::max(0.1, ' + FRACTION + ');'))
case('w-smoothstep', shadow=s(ADD, 'const double f = ' + FRACTION + ';\n        colour += (diffuse + specular) * (f * f * (3 - 2 * f));'))
case('w-first-light-only', shadow=s('light.position() + Vector3', 'scene.pointLights().front().position() + Vector3'))
case('w-last-light-fraction', shadow=s('int reached = 0;', 'reached = 0;').replace('        ' + ADD, '        sum += diffuse + specular;'), edit=[('ColourRGB colour = object', 'int reached = 0;\n    ColourRGB sum;\n    ColourRGB colour = object'), ('    return colour;\n}\n\nImage', '    colour += sum * (static_cast<double>(reached) / settings().shadowRayCount);\n    return colour;\n}\n\nImage')])
case('w-occluded-share', shadow=s('if (!hit || hit->distance > towards.magnitude())', 'if (hit && hit->distance < towards.magnitude())'))
case('w-static-count', shadow=s('int reached = 0;', 'static thread_local int reached = 0;').replace(ADD, ADD + '\n        reached = 0; if (colour.r > 1e3) reached = 1;').replace('reached = 0; if', 'reached /= 8; if'))
case('w-from-light-no-margin', shadow=r'''
        int lost = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 lamp = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 way = P - lamp;
            const auto hit = scene.findClosestIntersection(Ray{lamp, way.normalised()});
            if (hit && hit->distance < way.magnitude()) ++lost;
        }
        colour += (1.0 - lost / static_cast<double>(settings().shadowRayCount)) * (diffuse + specular);''')
# ------------------------------------------------------------ T2.2
case('w-lens-disc', lens=l(OLDLENS, '''            const double r = std::sqrt(randomBetween(0, 1)), a = randomBetween(0, 2 * std::numbers::pi);
            const Vector3 lens{settings().dofAmount * r * std::cos(a), settings().dofAmount * r * std::sin(a), 0.0};
'''))
case('w-lens-ball', lens=l(OLDLENS, '''            Vector3 lens = Vector3::randomInsideUnitSphere() * settings().dofAmount;
            lens.z = 0;
'''))
case('w-lens-gauss', inc='#include <random>', lens=l(OLDLENS, '''            static thread_local std::mt19937 g{std::random_device{}()};
            std::normal_distribution<double> n{0, 0.5};
            const Vector3 lens{settings().dofAmount * n(g), settings().dofAmount * n(g), 0.0};
'''))
case('w-lens-triangle', lens=lensPoint('settings().dofAmount * (randomBetween(0, 1) + randomBetween(0, 1) - 1)', 'settings().dofAmount * (randomBetween(0, 1) + randomBetween(0, 1) - 1)'))
case('w-lens-double', lens=lensPoint('2 * settings().dofAmount * randomBetween(-1, 1)', '2 * settings().dofAmount * randomBetween(-1, 1)'))
case('w-lens-quarter', lens=lensPoint('settings().dofAmount * randomBetween(-1, 1) / 4', 'settings().dofAmount * randomBetween(-1, 1) / 4'))
case('w-lens-zero-one', lens=lensPoint('settings().dofAmount * randomBetween(0, 1)', 'settings().dofAmount * randomBetween(0, 1)'))
case('w-lens-y-half', lens=lensPoint('settings().dofAmount * randomBetween(-1, 1)', 'settings().dofAmount * (randomBetween(0, 1) - 0.5)'))
case('w-lens-aspect', lens=lensPoint('settings().dofAmount * randomBetween(-1, 1)', 'settings().dofAmount * randomBetween(-1, 1) * settings().height / settings().width'))
case('w-lens-diagonal', lens=('        double both = 0;\n' + l(OLDLENS, '            both = settings().dofAmount * randomBetween(-1, 1);\n            const Vector3 lens{both, both, 0.0};\n')))
case('w-lens-one-axis', lens=lensPoint('settings().dofAmount * randomBetween(-1, 1)', '0.0'))
case('w-lens-at-image-plane', lens=l('randomBetween(-1, 1), 0.0}', 'randomBetween(-1, 1), 1.0}'))
case('w-lens-cube', lens=l('randomBetween(-1, 1), 0.0}', 'randomBetween(-1, 1), settings().dofAmount * randomBetween(-1, 1)}'))
case('w-lens-xz', lens=l(OLDLENS, '            const Vector3 lens{settings().dofAmount * randomBetween(-1, 1), 0.0, settings().dofAmount * randomBetween(-1, 1)};\n'))
case('w-focal-along-ray', lens=l('settings().dofFocalPlane / pinhole.direction.z', 'settings().dofFocalPlane'))
case('w-focal-times-z', lens=l('settings().dofFocalPlane / pinhole.direction.z', 'settings().dofFocalPlane * pinhole.direction.z'))
case('w-focal-moved', lens=l('settings().dofFocalPlane / pinhole.direction.z', '(settings().dofFocalPlane + 0.2) / pinhole.direction.z'))
case('w-focal-from-image-plane', lens=l('pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z)', 'pinhole.evaluateAt((settings().dofFocalPlane + 1) / pinhole.direction.z)'))
case('w-focal-shared-by-z', lens=l('const Vector3 focus =', 'Vector3 focus =').replace('        ColourRGB sum;', '        focus.z = settings().dofFocalPlane * pinhole.direction.z;\n        ColourRGB sum;'))
case('w-parallel-shift', lens=l('Ray{lens, (focus - lens).normalised()}', 'Ray{lens, focus.normalised()}'))
case('w-direction-plus', lens=l('(focus - lens)', '(focus + lens)'))
case('w-origin-not-moved', lens=l('Ray{lens,', 'Ray{pinhole.origin,'))
case('w-start-at-focus', lens=l('Ray{lens,', 'Ray{focus,'))
case('w-lens-less-equal', lens=l('i < settings().dofRayCount', 'i <= settings().dofRayCount'))
case('w-lens-from-one', lens=l('int i = 0', 'int i = 1'))
case('w-lens-7x7-over-50', lens=l('for (int i = 0; i < settings().dofRayCount; ++i) {', 'const int side = static_cast<int>(std::sqrt(settings().dofRayCount));\n        for (int i = 0; i < side * side; ++i) {'))
case('w-last-colour', lens=l('sum += trace', 'sum = trace').replace('sum / settings().dofRayCount', 'sum'))
case('w-moving-half', lens=l('sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);', 'sum = (sum + trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)) / 2;').replace('sum / settings().dofRayCount', 'sum'))
case('w-clamped-samples', lens=l('sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);', '''const ColourRGB c = trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
            sum += ColourRGB{std::min(1.0, c.r), std::min(1.0, c.g), std::min(1.0, c.b)};'''))
case('w-clamped-average', lens=l('image.set(x, y, sum / settings().dofRayCount);', '''sum /= settings().dofRayCount;
        image.set(x, y, {std::clamp(sum.r, 0.0, 1.0), std::clamp(sum.g, 0.0, 1.0), std::clamp(sum.b, 0.0, 1.0)});'''))
case('w-gamma', lens=l('image.set(x, y, sum / settings().dofRayCount);', '''sum /= settings().dofRayCount;
        image.set(x, y, {std::sqrt(sum.r), std::sqrt(sum.g), std::sqrt(sum.b)});'''))
case('w-bytes', lens=l('image.set(x, y, sum / settings().dofRayCount);', '''sum /= settings().dofRayCount;
        image.set(x, y, {std::floor(sum.r * 255) / 255, std::floor(sum.g * 255) / 255, std::floor(sum.b * 255) / 255});'''))
case('w-mean-of-roots', lens=l('sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);', '''const ColourRGB c = trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
            sum += ColourRGB{std::sqrt(c.r), std::sqrt(c.g), std::sqrt(c.b)};''').replace('image.set(x, y, sum / settings().dofRayCount);', 'sum /= settings().dofRayCount;\n        image.set(x, y, sum * sum);'))
case('w-background-ignored', lens=l('sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);', '''const Ray r{lens, (focus - lens).normalised()};
            if (!scene.findClosestIntersection(r)) continue;
            ++hits;
            sum += trace(scene, r, settings().bounces);''').replace('ColourRGB sum;', 'ColourRGB sum;\n        int hits = 0;').replace('sum / settings().dofRayCount', '(hits ? sum / hits : kBackgroundColour)'))
case('w-no-reflections', lens=l('settings().bounces', '0'))
case('w-bounce-short', lens=l('settings().bounces', 'settings().bounces - 1'))
case('w-bounce-more', lens=l('settings().bounces', 'settings().bounces + 1'))
case('w-own-trace-added', pre=LOOPTRACE.replace('weight * (1.0 - share) * r.', 'weight * r.'), lens=l('trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)', 'follow(*this, scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)'))
case('w-own-trace-viewer', pre=LOOPTRACE.replace('hit->normal, ray.origin)', 'hit->normal, Vector3{})'), lens=l('trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)', 'follow(*this, scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)'))
case('w-own-trace-end-dark', pre=LOOPTRACE.replace('bounces > 0 ? hit->object->reflectivity() : 0.0', 'hit->object->reflectivity()').replace('if (share <= 0.0) return', 'if (share <= 0.0 || bounces <= 0) return'), lens=l('trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)', 'follow(*this, scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)'))
case('w-lens-table', inc='#include <vector>', lens='''        static const std::vector<Vector3> eyes = [&] {
            std::vector<Vector3> v;
            for (int i = 0; i < settings().dofRayCount; ++i)
                v.push_back(settings().dofAmount * Vector3{randomBetween(-1, 1), randomBetween(-1, 1), 0});
            return v;
        }();
''' + l(OLDLENS, '            const Vector3 lens = eyes[static_cast<std::size_t>(i) % eyes.size()];\n'))
case('w-lens-seeded-per-row', inc='#include <random>', render=r'''
Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            std::mt19937 rng(static_cast<unsigned>(y));
            std::uniform_real_distribution<double> u(-settings().dofAmount, settings().dofAmount);
            const Ray r = camera.castRay(x, y);
            const Vector3 f = r.direction * (settings().dofFocalPlane / r.direction.z);
            ColourRGB c;
            for (int i = 0; i < settings().dofRayCount; ++i) {
                const double a = u(rng), b = u(rng);
                const Vector3 o{a, b, 0};
                c += trace(scene, {o, (f - o).normalised()}, settings().bounces);
            }
            image.set(x, y, c / settings().dofRayCount);
        }
    return image;
}
''')
case('w-lens-grid-fixed', lens=l(OLDLENS, '''            const int side = std::max(1, static_cast<int>(std::sqrt(settings().dofRayCount)));
            const double u = (i % side + 0.5) / side, v = (i / side + 0.5) / ((settings().dofRayCount + side - 1) / side);
            const Vector3 lens{settings().dofAmount * (2 * u - 1), settings().dofAmount * (2 * v - 1), 0.0};
'''))
case('w-lens-strata-clumped', lens=l(OLDLENS, '''            const int side = 7;
            const double u = (i % side + randomBetween(0, 1)) / side, v = (i / side + randomBetween(0, 1)) / side;
            const Vector3 lens{settings().dofAmount * (2 * u - 1), settings().dofAmount * (2 * v - 1), 0.0};
'''))
case('w-illuminate-forgets-viewer', edit=[('(O - P).normalised()', '(-P).normalised()')])
case('w-falloff-linear', edit=[('light.illuminationAt(distance)', 'light.illuminationAt(std::sqrt(distance))')])
case('w-own-camera-no-aspect', lens=l('const Ray pinhole = camera.castRay(x, y);', '''const double tx = std::tan(std::numbers::pi / 8);
        const Ray pinhole{{}, Vector3{((x + 0.5) / image.width() * 2 - 1) * tx, (1 - (y + 0.5) / image.height() * 2) * tx, 1}.normalised()}; (void)camera;'''))
case('w-own-camera-corner', lens=l('const Ray pinhole = camera.castRay(x, y);', '''const double tx = std::tan(std::numbers::pi / 8), h = static_cast<double>(settings().height) / settings().width;
        const Ray pinhole{{}, Vector3{(2.0 * (x + settings().region.x) / settings().width - 1) * tx, (1 - 2.0 * (y + settings().region.y) / settings().height) * tx * h, 1}.normalised()}; (void)camera;'''))
case('w-skips-last-row', render=r'''
Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    for (int y = 0; y < image.height() - 1; ++y)
        for (int x = 0; x < image.width() - 1; ++x) {
            const Ray r = camera.castRay(x, y);
            const Vector3 f = r.direction * (settings().dofFocalPlane / r.direction.z);
            ColourRGB c;
            for (int i = 0; i < settings().dofRayCount; ++i) {
                const Vector3 o = settings().dofAmount * Vector3{randomBetween(-1, 1), randomBetween(-1, 1), 0};
                c += trace(scene, {o, (f - o).normalised()}, settings().bounces);
            }
            image.set(x, y, c / settings().dofRayCount);
        }
    return image;
}
''')
case('w-flipped', lens=l('image.set(x, y,', 'image.set(x, image.height() - 1 - y,'))
# ------------------------------------------------------------ debatable
case('g-hardcoded-constants', shadow=SHADOW.replace('settings().shadowRayCount', '10').replace('settings().lightSize', '0.4'),
     lens=LENS.replace('settings().dofRayCount', '50').replace('settings().dofFocalPlane', '3.51805').replace('settings().dofAmount', '0.2'))
case('g-light-surface', shadow=shadowTarget('Vector3::randomInsideUnitSphere().normalised() * settings().lightSize'))
case('g-centre-distance', shadow=s('hit->distance > towards.magnitude()', 'hit->distance > distance'))
case('g-pixel-jitter', lens=LENS.replace('        ColourRGB sum;', '        const Ray right = camera.castRay(x + 1, y), down = camera.castRay(x, y + 1);\n        const Vector3 stepX = right.evaluateAt(settings().dofFocalPlane / right.direction.z) - focus, stepY = down.evaluateAt(settings().dofFocalPlane / down.direction.z) - focus;\n        ColourRGB sum;').replace(
     '(focus - lens).normalised()', '(focus + stepX * randomBetween(-0.5, 0.5) + stepY * randomBetween(-0.5, 0.5) - lens).normalised()'))
case('g-adaptive-shadow', shadow=s('            const Vector3 target', '            if (i == 4 && (reached == 0 || reached == 4)) { reached = reached ? settings().shadowRayCount : 0; break; }\n            const Vector3 target'))
case('g-facing-disc', shadow='''        const Vector3 side = std::abs(toLight.x) > 0.9 ? Vector3{0, 1, 0} : Vector3{1, 0, 0};
        const Vector3 e1 = toLight.cross(side).normalised(), e2 = toLight.cross(e1);
''' + s(OLDTARGET, '''            const double r = settings().lightSize * std::sqrt(randomBetween(0, 1)), a = randomBetween(0, 2 * std::numbers::pi);
            const Vector3 target = light.position() + e1 * (r * std::cos(a)) + e2 * (r * std::sin(a));
'''))
case('g-49-strata', lens=l('for (int i = 0; i < settings().dofRayCount; ++i) {', 'const int side = static_cast<int>(std::sqrt(settings().dofRayCount));\n        for (int i = 0; i < side * side; ++i) {').replace(OLDLENS, '''            const double u = (i % side + randomBetween(0, 1)) / side, v = (i / side + randomBetween(0, 1)) / side;
            const Vector3 lens{settings().dofAmount * (2 * u - 1), settings().dofAmount * (2 * v - 1), 0.0};
''').replace('sum / settings().dofRayCount', 'sum / (side * side)'))

if __name__ == '__main__':
    out = pathlib.Path(sys.argv[1])
    bumpy = pathlib.Path(sys.argv[2]).read_text()
    for name, text in k.CASES.items():
        d = out / name
        d.mkdir(parents=True, exist_ok=True)
        (d / 'Renderer.cpp').write_text(text)
        (d / 'BumpySphere.cpp').write_text(bumpy)
    print(len(k.CASES))

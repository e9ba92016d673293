#!/usr/bin/env python3
"""Second batch, after the first one's outcome: where rays are unseen, samplers, hashes."""
import pathlib, sys
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import make_right as k
from make_right import SHADOW, LENS, OWN, PERRAY, LOOPTRACE, HALTON, OLDLENS, OLDTARGET, BALL3, shadowTarget, lensPoint
k.CASES.clear()
case = k.case
def s(old, new, text=SHADOW):
    assert old in text, old
    return text.replace(old, new)
def l(old, new, text=LENS):
    assert old in text, old
    return text.replace(old, new)
HASH = r'''
namespace {
// As on a graphics card: no state, a number for every key.
std::uint64_t mix(std::uint64_t h) { h ^= h >> 30; h *= 0xbf58476d1ce4e5b9ULL; h ^= h >> 27; h *= 0x94d049bb133111ebULL; return h ^ (h >> 31); }
struct Stream {
    std::uint64_t key;
    double next() { key += 0x9e3779b97f4a7c15ULL; return static_cast<double>(mix(key) >> 11) * 0x1p-53; }
};
Stream streamAt(const Vector3& p) { return {mix(std::bit_cast<std::uint64_t>(p.x)) ^ mix(std::bit_cast<std::uint64_t>(p.y) + 1) * 3 ^ mix(std::bit_cast<std::uint64_t>(p.z) + 2) * 5}; }
}
'''
HINC = '#include <bit>\n#include <cstdint>'
HASHTARGET = '            const double a = stream.next(), b = stream.next(), c = stream.next();\n' + BALL3
case('r2-hash-of-point', inc=HINC, pre=HASH, shadow='        Stream stream = streamAt(P + light.position());\n' + s(OLDTARGET, HASHTARGET))
case('r2-hash-of-point-and-viewer', inc=HINC, pre=HASH, shadow='        Stream stream = streamAt(P + 7.0 * light.position() + 31.0 * O);\n' + s(OLDTARGET, HASHTARGET))
case('r2-hash-of-pixel', inc=HINC, pre=HASH, lens='        Stream stream{mix(static_cast<std::uint64_t>(y) * 65536u + static_cast<std::uint64_t>(x))};\n' + l(OLDLENS, '''            const double u = stream.next(), v = stream.next();
            const Vector3 lens{settings().dofAmount * (2 * u - 1), settings().dofAmount * (2 * v - 1), 0.0};
'''))
OWNSH = r'''
        const own::V here = own::from(P + N * kShadowBias);
        int seen = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 r = @R@;
            seen += own::sees(scene, here, own::from(light.position()) + settings().lightSize * own::from(r));
        }
        const double f = double(seen) / settings().shadowRayCount;
        colour += (diffuse + specular) * f;'''
BALL = 'Vector3::randomInsideUnitSphere()'
case('r2-own-hash-of-point', inc=HINC, pre=OWN + HASH, shadow='        Stream stream = streamAt(P + light.position());\n' + OWNSH.replace('@R@', '[&] { const double a = stream.next(), b = stream.next(), c = stream.next(); const double cz = 2 * b - 1, sz = std::sqrt(1 - cz * cz), q = std::cbrt(c), t = 2 * std::numbers::pi * a; return Vector3{q * sz * std::cos(t), q * sz * std::sin(t), q * cz}; }()'))
case('r2-progressive-set', lens=l('            sum += trace', '            sum += trace').replace('settings().bounces);\n        }', 'settings().bounces);\n            image.set(x, y, sum / (i + 1));  // for a preview\n        }'))
case('r2-castray-in-loop', lens='''        image.set(x, y, {});
        for (int i = 0; i < settings().dofRayCount; ++i) {
            Ray ray = camera.castRay(x, y);
            const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
            ray.origin = ray.origin + settings().dofAmount * Vector3{randomBetween(-1, 1), randomBetween(-1, 1), 0};
            ray.direction = (focus - ray.origin).normalised();
            image.set(x, y, image.at(x, y) + trace(scene, ray, settings().bounces) / settings().dofRayCount);
        }''')
case('r2-engine-each-call', inc='#include <random>', shadow='        std::mt19937 rng(std::random_device{}());\n        std::uniform_real_distribution<double> u(-1, 1);\n' + s(OLDTARGET, '''            Vector3 r;
            do r = {u(rng), u(rng), u(rng)}; while (r.dot(r) > 1);
            const Vector3 target = light.position() + r * settings().lightSize;
'''))
case('r2-same-offsets-for-lights', inc='#include <vector>', edit=[('    for (const PointLight& light', '    std::vector<Vector3> offsets;\n    for (int i = 0; i < settings().shadowRayCount; ++i) offsets.push_back(Vector3::randomInsideUnitSphere() * settings().lightSize);\n    for (const PointLight& light')], shadow=s('Vector3::randomInsideUnitSphere() * settings().lightSize', 'offsets[static_cast<std::size_t>(i)]'))
case('r2-blue-mask-16', inc='#include <array>\n#include <random>', pre=HALTON + r'''
namespace {
using Mask = std::array<std::array<std::array<double, 2>, 16>, 16>;
const Mask& mask() {
    static const Mask m = [] { Mask k; std::mt19937 g(5); for (auto& r : k) for (auto& c : r) c = {g() / 4294967296.0, g() / 4294967296.0}; return k; }();
    return m;
}
}
''', lens='        const auto [rx, ry] = mask()[static_cast<std::size_t>(y) % 16][static_cast<std::size_t>(x) % 16];\n' + l(OLDLENS, '''            const Vector3 lens{settings().dofAmount * (2 * wrap(rx + i * 0.7548776662466927) - 1),
                               settings().dofAmount * (2 * wrap(ry + i * 0.5698402909980532) - 1), 0.0};
'''))
case('r2-own-trace-own-geometry-half', pre=OWN + LOOPTRACE, shadow=OWNSH.replace('@R@', BALL), lens=LENS.replace('trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)', 'follow(*this, scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)').replace('settings().dofAmount * random', '0.5 * settings().dofAmount * random'))
case('r2-own-phong-each', pre=OWN, shadow=PERRAY.replace('const auto hit = scene.findClosestIntersection({start, way.normalised()});\n            if (hit && hit->distance < way.magnitude()) continue;', 'if (!own::sees(scene, own::from(start), own::from(lamp))) continue;') + '\n        (void)diffuse; (void)specular; (void)way;' if False else '        (void)diffuse; (void)specular;' + PERRAY.replace('const auto hit = scene.findClosestIntersection({start, way.normalised()});\n            if (hit && hit->distance < way.magnitude()) continue;', 'if (!own::sees(scene, own::from(start), own::from(start + way))) continue;'))
# ---- unseen shadow rays, wrong
for name, r in {
    'half-size': '0.5 * ' + BALL, 'octant': 'Vector3{randomBetween(0, 1), randomBetween(0, 1), randomBetween(0, 1)}',
    'three-quarters': '0.75 * ' + BALL, 'half-more': '1.5 * ' + BALL,
    'disc-xy': '[] { Vector3 v = Vector3::randomInsideUnitSphere(); v.z = 0; return v; }()',
    'line': 'Vector3{0, randomBetween(-1, 1), 0}', 'centre': 'Vector3{}',
    'upper-half': '[] { Vector3 v = Vector3::randomInsideUnitSphere(); v.y = std::abs(v.y); return v; }()',
    'squared-radius': '[] { Vector3 v = Vector3::randomInsideUnitSphere(); return v * v.magnitude(); }()'}.items():
    case('w2-own-' + name, pre=OWN, shadow=OWNSH.replace('@R@', r))
OB = OWNSH.replace('@R@', BALL)
case('w2-own-one-for-all', pre=OWN, shadow='        const Vector3 one = Vector3::randomInsideUnitSphere();\n' + OWNSH.replace('@R@', 'one'))
case('w2-own-less-equal', pre=OWN, shadow=s('i < settings', 'i <= settings', OB))
case('w2-own-nine', pre=OWN, shadow=s('i < settings', 'i + 1 < settings', OB))
case('w2-own-four-rays', pre=OWN, shadow=s('settings().shadowRayCount', '4', OB))
case('w2-own-threshold', pre=OWN, shadow=s('colour += (diffuse + specular) * f;', 'if (f > 0.5) colour += diffuse + specular;', OB))
case('w2-own-specular', pre=OWN, shadow=s('(diffuse + specular) * f', 'diffuse * f + specular', OB))
case('w2-own-ambient', pre=OWN, shadow=s('colour += (diffuse + specular) * f', 'colour = (colour + diffuse + specular) * f', OB))
case('w2-own-minimum', pre=OWN, shadow=s('* f;', '* std::max(f, 0.1);', OB))
case('w2-own-smoothstep', pre=OWN, shadow=s('* f;', '* (f * f * (3 - 2 * f));', OB))
case('w2-own-squared-share', pre=OWN, shadow=s('* f;', '* (f * f);', OB))
case('w2-own-fixed', pre=OWN, inc='#include <vector>', shadow='        static const std::vector<Vector3> t = [&] { std::vector<Vector3> v; for (int i = 0; i < settings().shadowRayCount; ++i) v.push_back(Vector3::randomInsideUnitSphere()); return v; }();\n' + OWNSH.replace('@R@', 't[static_cast<std::size_t>(i) % t.size()]'))
case('w2-own-no-planes', pre=OWN.replace('return t > 0 && t < 1;', 'return t > 2;'), shadow=OB)
case('w2-own-no-bias', pre=OWN, shadow=s('P + N * kShadowBias', 'P', OB))
case('w2-own-skips-plane-self', pre=OWN.replace('inline bool sees(const Scene& scene, V a, V b) {', 'inline bool sees(const Scene& scene, V a, V b, const SceneObject* self) {').replace('if (cuts(', 'if (!(thing.get() == self && dynamic_cast<const Plane*>(self)) && cuts('), shadow=OB.replace('own::from(r))', 'own::from(r), &object)'))
case('w2-own-centre-hidden', pre=OWN, shadow='        if (!own::sees(scene, own::from(P + N * kShadowBias), own::from(light.position()))) continue;\n' + OB)
case('w2-own-centre-visible', pre=OWN, shadow='        if (own::sees(scene, own::from(P + N * kShadowBias), own::from(light.position()))) { colour += diffuse + specular; continue; }\n' + OB)
case('w2-own-phong-not-max-gloss', pre=OWN, shadow='        (void)diffuse; (void)specular;' + PERRAY.replace('const auto hit = scene.findClosestIntersection({start, way.normalised()});\n            if (hit && hit->distance < way.magnitude()) continue;', 'if (!own::sees(scene, own::from(start), own::from(start + way))) continue;').replace('std::max(0.0, L.reflectIn(N).dot(toViewer))', 'std::abs(L.reflectIn(N).dot(toViewer))'))
# ---- seen shadow rays, wrong
case('w2-theta-uniform', shadow=s('            const Vector3 target', '''            const double phi = randomBetween(0, 2 * std::numbers::pi), theta = randomBetween(0, std::numbers::pi), r = std::cbrt(randomBetween(0, 1));
            const Vector3 target''').replace('Vector3::randomInsideUnitSphere() * settings', 'Vector3{r * std::sin(theta) * std::cos(phi), r * std::cos(theta), r * std::sin(theta) * std::sin(phi)} * settings'))
case('w2-radius-uniform', shadow=s('            const Vector3 target', '            const Vector3 dir = Vector3::randomInsideUnitSphere().normalised();\n            const Vector3 target').replace('Vector3::randomInsideUnitSphere() * settings', 'dir * randomBetween(0, 1) * settings'))
case('w2-cube-normalised', shadow=shadowTarget('Vector3{randomBetween(-1, 1), randomBetween(-1, 1), randomBetween(-1, 1)}.normalised() * settings().lightSize'))
case('w2-octant-normalised', shadow=shadowTarget('Vector3{randomBetween(0, 1), randomBetween(0, 1), randomBetween(0, 1)}.normalised() * settings().lightSize'))
case('w2-corners', inc='#include <cstdlib>', shadow=shadowTarget('Vector3(rand() % 3 - 1, rand() % 3 - 1, rand() % 3 - 1) * (settings().lightSize / std::sqrt(3.0))'))
case('w2-srand-time', inc='#include <cstdlib>\n#include <ctime>', pre='namespace { double rnd() { return 2.0 * rand() / RAND_MAX - 1; } }', shadow='        srand(static_cast<unsigned>(time(nullptr)));\n' + s(OLDTARGET, '''            Vector3 r;
            do { const double a = rnd(), b = rnd(), c = rnd(); r = {a, b, c}; } while (r.dot(r) > 1);
            const Vector3 target = light.position() + r * settings().lightSize;
'''))
case('w2-srand-time-lens', inc='#include <cstdlib>\n#include <ctime>', pre='namespace { double rnd() { return 2.0 * rand() / RAND_MAX - 1; } }', lens='        srand(static_cast<unsigned>(time(nullptr)));\n' + l(OLDLENS, '            const double a = rnd(), b = rnd();\n            const Vector3 lens{settings().dofAmount * a, settings().dofAmount * b, 0.0};\n'))
case('w2-below-horizon-arrives', shadow=s('            const auto hit', '            if (N.dot(towards) < 0.0) { ++reached; continue; }\n            const auto hit'))
case('w2-minus-light-size', shadow=s('hit->distance > towards.magnitude()', 'hit->distance > distance - settings().lightSize'))
case('w2-plus-light-size', shadow=s('hit->distance > towards.magnitude()', 'hit->distance > distance + settings().lightSize'))
case('w2-bias-tenth', shadow=s('N * kShadowBias', 'N * 0.1'))
case('w2-bias-hundredth', shadow=s('N * kShadowBias', 'N * 0.01'))
case('w2-min-hit-distance', shadow=s('hit->distance > towards.magnitude()', 'hit->distance > towards.magnitude() || hit->distance < 0.05'))
case('w2-ignores-self', shadow=s('hit->distance > towards.magnitude()', 'hit->distance > towards.magnitude() || hit->object == &object'))
case('w2-half-ball-near-viewer', shadow=s(OLDTARGET, '''            Vector3 r = Vector3::randomInsideUnitSphere();
            if (r.dot(toLight) > 0) r = -r;
            const Vector3 target = light.position() + r * settings().lightSize;
'''))
case('w2-tiny-shift', shadow=shadowTarget('(Vector3::randomInsideUnitSphere() + Vector3{0.2, 0, 0}) * settings().lightSize'))
case('w2-diffuse-sees-specular-once', shadow=s('colour += (diffuse + specular)', 'colour += specular * (reached == settings().shadowRayCount ? 1.0 : 0.0);\n        colour += diffuse'))
case('w2-clamped-illuminate', edit=[('    return colour;\n}\n\nImage', '    return {std::min(1.0, colour.r), std::min(1.0, colour.g), std::min(1.0, colour.b)};\n}\n\nImage')])
case('w2-float-count-int-percent', shadow=s('(static_cast<double>(reached) / settings().shadowRayCount)', '((100 * reached / settings().shadowRayCount) / 100.0)'))
case('w2-early-out-fully-lit-3', shadow=s('            const Vector3 target', '            if (i >= 3 && reached == i) { reached = settings().shadowRayCount; break; }\n            const Vector3 target'))
# ---- unseen lens rays, wrong
def ot(name, lens, pre=LOOPTRACE, **kw):
    case('w2-ot-' + name, pre=pre, lens=lens.replace('trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)', 'follow(*this, scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)').replace('trace(scene, Ray{lens, focus.normalised()}, settings().bounces)', 'follow(*this, scene, Ray{lens, focus.normalised()}, settings().bounces)'), **kw)
A = 'settings().dofAmount * '
ot('double', lensPoint('2 * ' + A + 'randomBetween(-1, 1)', '2 * ' + A + 'randomBetween(-1, 1)'))
ot('half-more', lensPoint('1.5 * ' + A + 'randomBetween(-1, 1)', '1.5 * ' + A + 'randomBetween(-1, 1)'))
ot('zero-one', lensPoint(A + 'randomBetween(0, 1)', A + 'randomBetween(0, 1)'))
ot('disc', l(OLDLENS, '''            const double r = std::sqrt(randomBetween(0, 1)), a = randomBetween(0, 2 * std::numbers::pi);
            const Vector3 lens{settings().dofAmount * r * std::cos(a), settings().dofAmount * r * std::sin(a), 0.0};
'''))
ot('one-axis', lensPoint(A + 'randomBetween(-1, 1)', '0.0'))
ot('y-half', lensPoint(A + 'randomBetween(-1, 1)', '0.5 * ' + A + 'randomBetween(-1, 1)'))
ot('diagonal', '        double both = 0;\n' + l(OLDLENS, '            both = settings().dofAmount * randomBetween(-1, 1);\n            const Vector3 lens{both, both, 0.0};\n'))
ot('triangle', lensPoint(A + '(randomBetween(0, 1) + randomBetween(0, 1) - 1)', A + '(randomBetween(0, 1) + randomBetween(0, 1) - 1)'))
ot('along-ray', l('settings().dofFocalPlane / pinhole.direction.z', 'settings().dofFocalPlane'))
ot('focal-moved', l('settings().dofFocalPlane / pinhole.direction.z', '(settings().dofFocalPlane + 0.2) / pinhole.direction.z'))
ot('parallel', l('(focus - lens).normalised()', 'focus.normalised()'))
ot('pinhole', lensPoint('0.0', '0.0'))
ot('less-equal', l('i < settings', 'i <= settings'))
ot('from-one', l('int i = 0', 'int i = 1'))
ot('five-rays', LENS.replace('settings().dofRayCount', '5'))
ot('last', l('sum +=', 'sum =').replace('sum / settings().dofRayCount', 'sum'))
ot('no-bounce', l('settings().bounces', '0'))
ot('one-bounce', l('settings().bounces', '1'))
ot('four-bounces', l('settings().bounces', '4'))
ot('no-share', LENS, pre=LOOPTRACE.replace('weight *= share;', ''))
ot('no-bias', LENS, pre=LOOPTRACE.replace('hit->location + hit->normal * kShadowBias', 'hit->location'))
ot('black-background', LENS, pre=LOOPTRACE.replace('total + weight * kBackgroundColour', 'total'))
ot('white-background', LENS, pre=LOOPTRACE.replace('weight * kBackgroundColour', 'weight * ColourRGB{0.01}'))
ot('shared-lens', 'FIX' if False else l(OLDLENS, '').replace('        ColourRGB sum;', '''        ColourRGB sum;
        const Vector3 lens{settings().dofAmount * randomBetween(-1, 1), settings().dofAmount * randomBetween(-1, 1), 0.0};'''))
ot('clamped', l('sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);', '''const ColourRGB c = trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
            sum += ColourRGB{std::min(1.0, c.r), std::min(1.0, c.g), std::min(1.0, c.b)};'''))
ot('gamma', l('image.set(x, y, sum / settings().dofRayCount);', 'sum /= settings().dofRayCount;\n        image.set(x, y, {std::sqrt(sum.r), std::sqrt(sum.g), std::sqrt(sum.b)});'))
ot('flipped', l('image.set(x, y,', 'image.set(x, image.height() - 1 - y,'))
# ---- seen lens rays, wrong
case('w2-lens-x-per-pixel', lens='        const double sharedX = settings().dofAmount * randomBetween(-1, 1);\n' + lensPoint('sharedX', A + 'randomBetween(-1, 1)'))
case('w2-lens-y-times-x', lens=l(OLDLENS, '''            const double u = randomBetween(-1, 1), v = u * randomBetween(-1, 1);
            const Vector3 lens{settings().dofAmount * u, settings().dofAmount * v, 0.0};
'''))
case('w2-lens-integers', inc='#include <cstdlib>', lens=lensPoint(A + '(rand() % 3 - 1)', A + '(rand() % 3 - 1)'))
case('w2-lens-perimeter', lens=l(OLDLENS, '''            const double t = randomBetween(-1, 1), e = randomBetween(0, 1) < 0.5 ? -1 : 1;
            const bool side = randomBetween(0, 1) < 0.5;
            const Vector3 lens{settings().dofAmount * (side ? e : t), settings().dofAmount * (side ? t : e), 0.0};
'''))
case('w2-lens-rand-int-division', inc='#include <cstdlib>', lens=lensPoint(A + '(2 * (rand() / RAND_MAX) - 1)', A + '(2 * (rand() / RAND_MAX) - 1)'))
case('w2-lens-diamond', lens=l(OLDLENS, '''            const double u = randomBetween(-0.5, 0.5), v = randomBetween(-0.5, 0.5);
            const Vector3 lens{settings().dofAmount * (u + v), settings().dofAmount * (u - v), 0.0};
'''))
case('w2-lens-rotated-45', lens=l(OLDLENS, '''            const double u = randomBetween(-1, 1) / std::sqrt(2.0), v = randomBetween(-1, 1) / std::sqrt(2.0);
            const Vector3 lens{settings().dofAmount * (u + v), settings().dofAmount * (u - v), 0.0};
'''))
case('w2-lens-off-centre-slightly', lens=lensPoint(A + 'randomBetween(-1, 1) + 0.02', A + 'randomBetween(-1, 1)'))
case('w2-lens-bitten', lens=l(OLDLENS, '''            double u = randomBetween(-1, 1), v = randomBetween(-1, 1);
            if (u > 0.5 && v > 0.5) { u = -u; v = -v; }
            const Vector3 lens{settings().dofAmount * u, settings().dofAmount * v, 0.0};
'''))
case('w2-region-ignored', lens=l('const Ray pinhole = camera.castRay(x, y);', '''const double tx = std::tan(std::numbers::pi / 8), h = static_cast<double>(settings().height) / settings().width;
        const Ray pinhole{{}, Vector3{(2.0 * (x + 0.5) / settings().width - 1) * tx, (1 - 2.0 * (y + 0.5) / settings().height) * tx * h, 1}.normalised()}; (void)camera;'''))
case('w2-size-640', lens=l('const Ray pinhole = camera.castRay(x, y);', '''const double tx = std::tan(std::numbers::pi / 8);
        const Ray pinhole{{}, Vector3{(2.0 * (x + settings().region.x + 0.5) / 640 - 1) * tx, (1 - 2.0 * (y + settings().region.y + 0.5) / 480) * tx * 0.75, 1}.normalised()}; (void)camera;'''))
case('w2-median', inc='#include <vector>', lens=l('sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);', 'all.push_back(trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces));').replace('        ColourRGB sum;', '        std::vector<ColourRGB> all;').replace('image.set(x, y, sum / settings().dofRayCount);', '''std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.r + a.g + a.b < b.r + b.g + b.b; });
        image.set(x, y, all[all.size() / 2]);'''))
case('w2-neighbour-blur', render=r'''
Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image raw{settings()};
    forEachPixel(raw, [&](int x, int y) {
''' + LENS.replace('image.set', 'raw.set') + r'''
    });
    Image image{settings()};
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            ColourRGB c;
            int n = 0;
            for (int j = std::max(0, y - 1); j <= std::min(image.height() - 1, y + 1); ++j)
                for (int i = std::max(0, x - 1); i <= std::min(image.width() - 1, x + 1); ++i, ++n) c += raw.at(i, j);
            image.set(x, y, c / n);
        }
    return image;
}
''')
case('w2-thread-race', inc='#include <thread>\n#include <vector>', render=r'''
Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Ray r = camera.castRay(x, y);
            const Vector3 f = r.direction * (settings().dofFocalPlane / r.direction.z);
            ColourRGB parts[2];
            auto half = [&](int k) {
                seedRandom(7);
                for (int i = k; i < settings().dofRayCount; i += 2) {
                    const Vector3 o = settings().dofAmount * Vector3{randomBetween(-1, 1), randomBetween(-1, 1), 0};
                    parts[k] += trace(scene, {o, (f - o).normalised()}, settings().bounces);
                }
            };
            half(0);
            half(1);
            image.set(x, y, (parts[0] + parts[1]) / settings().dofRayCount);
        }
    return image;
}
''')
if __name__ == '__main__':
    out = pathlib.Path(sys.argv[1])
    bumpy = pathlib.Path(sys.argv[2]).read_text()
    for name, text in k.CASES.items():
        d = out / name
        d.mkdir(parents=True, exist_ok=True)
        (d / 'Renderer.cpp').write_text(text)
        (d / 'BumpySphere.cpp').write_text(bumpy)
    print(len(k.CASES))

#!/usr/bin/env python3
"""Third batch, with the decision partly known."""
import pathlib, sys
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import make_right as k
from make_right import SHADOW, LENS, OWN, PERRAY, LOOPTRACE, OLDLENS, OLDTARGET, shadowTarget, lensPoint
import make_second
from make_second import OWNSH, s, l, ot
k.CASES.clear()
case = k.case
POLAR = '''[] { const double r = randomBetween(0, 1), t = randomBetween(0, std::numbers::pi), p = randomBetween(0, 2 * std::numbers::pi); return r * Vector3{%s}; }()'''
case('r3-own-polar-y', pre=OWN, shadow=OWNSH.replace('@R@', POLAR % 'std::sin(t) * std::cos(p), std::cos(t), std::sin(t) * std::sin(p)'))
case('r3-own-polar-z', pre=OWN, shadow=OWNSH.replace('@R@', POLAR % 'std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)'))
case('r3-own-surface', pre=OWN, shadow=OWNSH.replace('@R@', 'Vector3::randomInsideUnitSphere().normalised()'))
case('r3-own-uniform-radius', pre=OWN, shadow=OWNSH.replace('@R@', 'Vector3::randomInsideUnitSphere().normalised() * randomBetween(0, 1)'))
case('r3-polar-y', shadow=shadowTarget((POLAR % 'std::sin(t) * std::cos(p), std::cos(t), std::sin(t) * std::sin(p)') + ' * settings().lightSize'))
case('r3-polar-x-floats', shadow=s('            const Vector3 target', '''            const float r = float(randomBetween(0, 1)), t = float(randomBetween(0, 3.14159265)), p = float(randomBetween(0, 6.2831853));
            const Vector3 target''').replace('Vector3::randomInsideUnitSphere() * settings', 'Vector3{r * std::cos(t), r * std::sin(t) * std::cos(p), r * std::sin(t) * std::sin(p)} * settings'))
case('r3-quadtree', inc='#include <functional>', render=r'''
Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    const std::function<void(int, int, int, int)> paint = [&](int x0, int y0, int x1, int y1) {
        if (x0 >= x1 || y0 >= y1) return;
        if (x1 - x0 > 2 || y1 - y0 > 2) {
            const int mx = (x0 + x1) / 2, my = (y0 + y1) / 2;
            paint(mx, my, x1, y1); paint(x0, my, mx, y1); paint(mx, y0, x1, my); paint(x0, y0, mx, my);
            return;
        }
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                const Ray ray = camera.castRay(x, y);
                const Vector3 focus = ray.direction * (settings().dofFocalPlane / ray.direction.z);
                ColourRGB sum;
                for (int i = 0; i < settings().dofRayCount; ++i) {
                    const Vector3 eye = settings().dofAmount * Vector3{randomBetween(-1, 1), randomBetween(-1, 1), 0};
                    const ColourRGB c = trace(scene, {eye, (focus - eye).normalised()}, settings().bounces);
                    if (std::isfinite(c.r + c.g + c.b)) sum += c;
                }
                image.set(x, y, sum / settings().dofRayCount);
            }
    };
    paint(0, 0, image.width(), image.height());
    return image;
}
''')
case('r3-macros-goto', pre='#define COUNT (settings().shadowRayCount)\n#define LENSES (settings().dofRayCount)', shadow='''        int i = 0, ok = 0;
        again: {
            Vector3 s = P + N * kShadowBias, w = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere() - s;
            auto h = scene.findClosestIntersection(Ray(s, w.normalised()));
            ok += h.has_value() ? (h->distance >= w.magnitude() ? 1 : 0) : 1;
        }
        if (++i < COUNT) goto again;
        colour += (diffuse + specular) * (ok / (COUNT * 1.0));''', lens=LENS.replace('settings().dofRayCount', 'LENSES'))
case('r3-more-where-mixed', shadow=s('        colour +=', '''        int cast = settings().shadowRayCount;
        if (reached != 0 && reached != cast)
            for (; cast < 4 * settings().shadowRayCount; ++cast) {
                const Vector3 towards = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
                const auto hit = scene.findClosestIntersection(Ray{start, towards.normalised()});
                if (!hit || hit->distance > towards.magnitude()) ++reached;
            }
        colour +=''').replace('/ settings().shadowRayCount)', '/ cast)') if False else s('(static_cast<double>(reached) / settings().shadowRayCount)', '(static_cast<double>(reached) / cast)').replace('        colour +=', '''        int cast = settings().shadowRayCount;
        for (const bool mixed = reached != 0 && reached != cast; mixed && cast < 4 * settings().shadowRayCount; ++cast) {
            const Vector3 towards = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection(Ray{start, towards.normalised()});
            if (!hit || hit->distance > towards.magnitude()) ++reached;
        }
        colour +='''))
# -- wrong
case('w3-shrinking-aims', shadow=shadowTarget('Vector3::randomInsideUnitSphere() * (settings().lightSize * i / settings().shadowRayCount)'))
case('w3-shrinking-lens', lens=lensPoint('settings().dofAmount * randomBetween(-1, 1) * i / settings().dofRayCount', 'settings().dofAmount * randomBetween(-1, 1) * i / settings().dofRayCount'))
case('w3-lens-corners', lens=lensPoint('settings().dofAmount * (randomBetween(0, 1) < 0.5 ? -1 : 1)', 'settings().dofAmount * (randomBetween(0, 1) < 0.5 ? -1 : 1)'))
case('w3-vignette', lens=l('image.set(x, y, sum / settings().dofRayCount);', 'image.set(x, y, sum * (pinhole.direction.z / settings().dofRayCount));'))
case('w3-bokeh-weights', lens=l('sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);', 'const double w = std::exp(-lens.dot(lens) / (settings().dofAmount * settings().dofAmount));\n            weights += w;\n            sum += w * trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);').replace('ColourRGB sum;', 'ColourRGB sum;\n        double weights = 0;').replace('sum / settings().dofRayCount', 'sum / weights'))
case('w3-divided-twice', shadow=s('(static_cast<double>(reached) / settings().shadowRayCount)', '(static_cast<double>(reached) / settings().shadowRayCount / settings().shadowRayCount)'))
case('w3-ambient-per-light-added', shadow=SHADOW + '\n        colour += object.colour() * scene.ambientLighting();', edit=[('ColourRGB colour = object.colour() * scene.ambientLighting();', 'ColourRGB colour;')])
case('w3-bounces-counted-down', lens=('        int left = settings().bounces;\n' + l('settings().bounces', 'left--')))
case('w3-index-as-bounces', lens=l('settings().bounces', 'i'))
case('w3-uninitialised', lens=l('ColourRGB sum;', 'double acc[3];').replace('sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);', 'const ColourRGB c = trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);\n            acc[0] += c.r; acc[1] += c.g; acc[2] += c.b;').replace('sum / settings', 'ColourRGB(acc[0], acc[1], acc[2]) / settings'))
case('w3-static-sum', lens=l('ColourRGB sum;', 'static ColourRGB sum;'))
case('w3-int-accumulators', lens=l('ColourRGB sum;', 'int r = 0, g = 0, b = 0;').replace('sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);', 'const ColourRGB c = trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);\n            r += int(c.r * 255); g += int(c.g * 255); b += int(c.b * 255);').replace('image.set(x, y, sum / settings().dofRayCount);', 'const int n = settings().dofRayCount;\n        image.set(x, y, ColourRGB(r / n / 255.0, g / n / 255.0, b / n / 255.0));'))
case('w3-castray-swapped', lens=l('camera.castRay(x, y)', 'camera.castRay(y, x)'))
case('w3-castray-next', lens=l('camera.castRay(x, y)', 'camera.castRay(x + 1, y)'))
case('w3-tone-per-ray', inc='#include <raytracer/image/ToneCurve.h>', lens=l('sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);', 'const ColourRGB c = trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);\n            sum += ColourRGB{c.r / (1 + c.r), c.g / (1 + c.g), c.b / (1 + c.b)};'))
case('w3-trimmed-mean', inc='#include <vector>', lens=l('sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);', '''const ColourRGB c = trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
            if (c.r + c.g + c.b > most) { most = c.r + c.g + c.b; brightest = c; }
            sum += c;''').replace('ColourRGB sum;', 'ColourRGB sum, brightest;\n        double most = -1;').replace('sum / settings().dofRayCount', '(sum - brightest) / (settings().dofRayCount - 1)'))
case('w3-nine-and-centre', shadow=s('Vector3::randomInsideUnitSphere() * settings', '(i == 0 ? Vector3{} : Vector3::randomInsideUnitSphere()) * settings'))
case('w3-gloss-abs', edit=[('std::max(0.0, toLight.reflectIn(N).dot(toViewer))', 'std::abs(toLight.reflectIn(N).dot(toViewer))')])
case('w3-facing-abs', edit=[('std::max(0.0, N.dot(toLight))', 'std::abs(N.dot(toLight))')])
case('w3-normal-for-viewer', edit=[('(O - P).normalised()', 'N')])
case('w3-hard-in-mirrors', shadow='        const bool primary = std::abs(O.z) < 1e-9;\n' + s('Vector3::randomInsideUnitSphere() * settings', '(primary ? Vector3::randomInsideUnitSphere() : Vector3{}) * settings'))
case('w3-one-ray-in-mirrors', shadow='        const int count = std::abs(O.z) < 1e-9 ? settings().shadowRayCount : 1;\n' + SHADOW.replace('settings().shadowRayCount', 'count'))
case('w3-all-lights-one-share', shadow='''        const Vector3 start = P + N * kShadowBias;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 towards = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection(Ray{start, towards.normalised()});
            if (!hit || hit->distance > towards.magnitude()) ++reached;
        }
        sum += diffuse + specular;''', edit=[('ColourRGB colour = object', 'int reached = 0;\n    ColourRGB sum;\n    ColourRGB colour = object'), ('    return colour;\n}\n\nImage', '    if (!scene.pointLights().empty()) colour += sum * (static_cast<double>(reached) / (settings().shadowRayCount * static_cast<double>(scene.pointLights().size())));\n    return colour;\n}\n\nImage')])
case('w3-own-all-lights-one-share', pre=OWN, shadow=OWNSH.replace('@R@', 'Vector3::randomInsideUnitSphere()').replace('int seen = 0;', '').replace('const double f = double(seen) / settings().shadowRayCount;', 'total += settings().shadowRayCount;').replace('colour += (diffuse + specular) * f;', 'sum += diffuse + specular;'), edit=[('ColourRGB colour = object', 'int seen = 0, total = 0;\n    ColourRGB sum;\n    ColourRGB colour = object'), ('    return colour;\n}\n\nImage', '    if (total) colour += sum * (double(seen) / total);\n    return colour;\n}\n\nImage')])
case('w3-own-only-nearest-light', pre=OWN, shadow='        if (&light != &scene.pointLights().front()) { colour += diffuse + specular; continue; }\n' + OWNSH.replace('@R@', 'Vector3::randomInsideUnitSphere()'))
case('w3-own-threads-lens-half-shadow-size', pre=OWN, shadow=OWNSH.replace('@R@', 'Vector3::randomInsideUnitSphere() * 0.9'))
if __name__ == '__main__':
    out = pathlib.Path(sys.argv[1])
    bumpy = pathlib.Path(sys.argv[2]).read_text()
    for name, text in k.CASES.items():
        d = out / name
        d.mkdir(parents=True, exist_ok=True)
        (d / 'Renderer.cpp').write_text(text)
        (d / 'BumpySphere.cpp').write_text(bumpy)
    print(len(k.CASES))

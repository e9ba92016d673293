#!/usr/bin/env python3
"""Writes the right submissions: NAME/Renderer.cpp under the folder given."""
import pathlib, sys

HEAD = r'''// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
@INC@
namespace raytracer {
@PRE@
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
@SHADOW@
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
@LENS@
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
'''
SHADOW = r'''        const Vector3 start = P + N * kShadowBias;
        int reached = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 target =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 towards = target - start;
            const auto hit = scene.findClosestIntersection(Ray{start, towards.normalised()});
            if (!hit || hit->distance > towards.magnitude()) ++reached;
        }
        colour += (diffuse + specular) * (static_cast<double>(reached) / settings().shadowRayCount);'''
LENS = r'''        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 lens{settings().dofAmount * randomBetween(-1, 1),
                               settings().dofAmount * randomBetween(-1, 1), 0.0};
            sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);'''
CASES = {}
def case(name, shadow=SHADOW, lens=LENS, inc='', pre='', whole=None, render=None, edit=None):
    text = whole
    if text is None:
        text = HEAD.replace('@INC@', inc).replace('@PRE@', pre)
        text = text.replace('@SHADOW@', shadow).replace('@LENS@', lens)
    if render is not None:
        a = text.index('Image Renderer::render'); b = text.rindex('}  // namespace raytracer')
        text = text[:a] + render + '\n' + text[b:]
    for old, new in (edit or []):
        assert old in text, (name, old)
        text = text.replace(old, new)
    assert name not in CASES
    CASES[name] = text
def shadowTarget(expr):
    return SHADOW.replace('Vector3::randomInsideUnitSphere() * settings().lightSize', expr)
def lensPoint(x, y):
    return (LENS.replace('{settings().dofAmount * randomBetween(-1, 1),', '{' + x + ',')
                .replace('settings().dofAmount * randomBetween(-1, 1), 0.0}', y + ', 0.0}'))

if __name__ == '__main__' or True:
    pass
# ---------------------------------------------------------------- threads
case('r-async-bands', inc='#include <future>\n#include <vector>', render=r'''
Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    auto band = [&](int from, int to) {
        for (int y = from; y < to; ++y)
            for (int x = 0; x < image.width(); ++x) {
                const Ray centre = camera.castRay(x, y);
                const Vector3 focus = centre.direction * (settings().dofFocalPlane / centre.direction.z);
                ColourRGB total;
                for (int n = 0; n < settings().dofRayCount; n++) {
                    Vector3 eye(randomBetween(-1.0, 1.0), randomBetween(-1.0, 1.0), 0.0);
                    eye *= settings().dofAmount;
                    total += trace(scene, Ray(eye, (focus - eye).normalised()), settings().bounces);
                }
                image.set(x, y, total / settings().dofRayCount);
            }
    };
    std::vector<std::future<void>> jobs;
    const int step = std::max(1, image.height() / 4);
    for (int y = 0; y < image.height(); y += step)
        jobs.push_back(std::async(std::launch::async, band, y, std::min(image.height(), y + step)));
    for (auto& job : jobs) job.get();
    return image;
}
''')
case('r-threads-mt19937', inc='#include <random>\n#include <thread>\n#include <vector>\n#include <atomic>', pre=r'''
namespace {
thread_local std::mt19937_64 engine{std::random_device{}()};
double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); }
Vector3 inBall() {
    for (;;) {
        const Vector3 v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
        if (v.dot(v) <= 1.0) return v;
    }
}
}  // namespace
''', shadow=shadowTarget('inBall() * settings().lightSize'), render=r'''
Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    std::atomic<int> next{0};
    auto worker = [&] {
        int y;
        while ((y = next.fetch_add(1)) < image.height()) {
            for (int x = 0; x < image.width(); ++x) {
                Vector3 d = camera.castRay(x, y).direction;
                Vector3 focal = d / d.z * settings().dofFocalPlane;
                ColourRGB c{0.0};
                for (int k = settings().dofRayCount; k-- > 0;) {
                    Vector3 o{uniform(-1, 1) * settings().dofAmount, uniform(-1, 1) * settings().dofAmount, 0};
                    c += trace(scene, {o, (focal - o).normalised()}, settings().bounces);
                }
                c /= settings().dofRayCount;
                image.set(x, y, c);
            }
        }
    };
    std::vector<std::thread> pool;
    for (unsigned i = 0; i < 2; ++i) pool.emplace_back(worker);
    for (auto& t : pool) t.join();
    return image;
}
''')
# ---------------------------------------------------------------- odd numeric types
case('r-valarray', inc='#include <valarray>', pre=r'''
namespace {
using V = std::valarray<double>;
V va(const Vector3& v) { return {v.x, v.y, v.z}; }
Vector3 vec(const V& v) { return {v[0], v[1], v[2]}; }
double len(const V& v) { return std::sqrt((v * v).sum()); }
}
''', shadow=r'''
        const V from = va(P) + va(N) * kShadowBias;
        V visible(0.0, static_cast<std::size_t>(settings().shadowRayCount));
        for (double& seen : visible) {
            const V to = va(light.position()) + settings().lightSize * va(Vector3::randomInsideUnitSphere());
            const V ray = to - from;
            const auto hit = scene.findClosestIntersection({vec(from), vec(ray / len(ray))});
            seen = hit.has_value() && hit->distance < len(ray) ? 0.0 : 1.0;
        }
        colour += (visible.sum() / static_cast<double>(visible.size())) * (diffuse + specular);''', lens=r'''
        const V d = va(camera.castRay(x, y).direction);
        const V focus = d * (settings().dofFocalPlane / d[2]);
        V rgb(0.0, 3);
        for (int i = 0; i < settings().dofRayCount; ++i) {
            V lens = settings().dofAmount * V{randomBetween(-1, 1), randomBetween(-1, 1), 0.0};
            V dir = focus - lens;
            dir /= len(dir);
            const ColourRGB c = trace(scene, {vec(lens), vec(dir)}, settings().bounces);
            rgb += V{c.r, c.g, c.b};
        }
        rgb /= static_cast<double>(settings().dofRayCount);
        image.set(x, y, {rgb[0], rgb[1], rgb[2]});''')
case('r-floats', pre=r'''
namespace {
struct F3 { float x, y, z; };
F3 f3(const Vector3& v) { return {float(v.x), float(v.y), float(v.z)}; }
Vector3 d3(F3 v) { return {double(v.x), double(v.y), double(v.z)}; }
F3 sub(F3 a, F3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
float length(F3 a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }
}
''', shadow=r'''
        const F3 start = f3(P + N * kShadowBias);
        float lit = 0.0f;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const F3 r = f3(Vector3::randomInsideUnitSphere());
            const F3 c = f3(light.position());
            const float s = float(settings().lightSize);
            const F3 to = sub({c.x + s * r.x, c.y + s * r.y, c.z + s * r.z}, start);
            const float l = length(to);
            const auto hit = scene.findClosestIntersection({d3(start), d3({to.x / l, to.y / l, to.z / l})});
            if (!hit || float(hit->distance) > l) lit += 1.0f;
        }
        colour += (diffuse + specular) * double(lit / float(settings().shadowRayCount));''', lens=r'''
        const F3 d = f3(camera.castRay(x, y).direction);
        const float t = float(settings().dofFocalPlane) / d.z;
        const F3 focus{d.x * t, d.y * t, d.z * t};
        float r = 0, g = 0, b = 0;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const float a = float(settings().dofAmount);
            const F3 lens{a * float(randomBetween(-1, 1)), a * float(randomBetween(-1, 1)), 0.0f};
            const F3 to = sub(focus, lens);
            const float l = length(to);
            const ColourRGB c = trace(scene, {d3(lens), d3({to.x / l, to.y / l, to.z / l})}, settings().bounces);
            r += float(c.r); g += float(c.g); b += float(c.b);
        }
        const float n = float(settings().dofRayCount);
        image.set(x, y, {double(r / n), double(g / n), double(b / n)});''')
case('r-kahan-arrays', shadow=r'''
        double share = 0.0;
        const double weight = 1.0 / settings().shadowRayCount;
        for (int i = 0; i != settings().shadowRayCount; i++) {
            Vector3 jitter = Vector3::randomInsideUnitSphere();
            jitter *= settings().lightSize;
            const Vector3 begin = P + kShadowBias * N;
            const Vector3 path = light.position() + jitter - begin;
            const double far = std::sqrt(path.dot(path));
            const auto hit = scene.findClosestIntersection(Ray(begin, path / far));
            const bool blocked = hit && hit->distance < far;
            share += blocked ? 0.0 : weight;
        }
        colour += share * diffuse;
        colour += share * specular;''', lens=r'''
        const Ray mid = camera.castRay(x, y);
        const double scale = settings().dofFocalPlane / mid.direction.z;
        double sum[3] = {0, 0, 0}, lost[3] = {0, 0, 0};
        for (int i = 0; i < settings().dofRayCount; i++) {
            const double ox = randomBetween(-settings().dofAmount, settings().dofAmount);
            const double oy = randomBetween(-settings().dofAmount, settings().dofAmount);
            Vector3 dir(mid.direction.x * scale - ox, mid.direction.y * scale - oy, settings().dofFocalPlane);
            const ColourRGB c = trace(scene, Ray(Vector3(ox, oy, 0), dir.normalised()), settings().bounces);
            const double part[3] = {c.r, c.g, c.b};
            for (int k = 0; k < 3; k++) {
                const double yk = part[k] - lost[k];
                const double tk = sum[k] + yk;
                lost[k] = (tk - sum[k]) - yk;
                sum[k] = tk;
            }
        }
        image.set(x, y, ColourRGB(sum[0], sum[1], sum[2]) / settings().dofRayCount);''')
case('r-running-mean', lens=LENS.replace('ColourRGB sum;', 'ColourRGB mean;').replace(
    'sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);',
    '''const ColourRGB c = trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
            mean += (c - mean) / (i + 1);''').replace('sum / settings().dofRayCount', 'mean'),
    shadow=SHADOW.replace('int reached = 0;', 'double visible = 0;').replace(
      'if (!hit || hit->distance > towards.magnitude()) ++reached;',
      'const double v = (!hit || hit->distance > towards.magnitude()) ? 1 : 0;\n            visible += (v - visible) / (i + 1);')
      .replace('(static_cast<double>(reached) / settings().shadowRayCount)', 'visible'))
# ---------------------------------------------------------------- coroutine
case('r-coroutine', inc='#include <coroutine>\n#include <exception>\n#include <utility>', pre=r'''
namespace {
template <class T>
struct Generator {
    struct promise_type {
        T value;
        Generator get_return_object() { return Generator{std::coroutine_handle<promise_type>::from_promise(*this)}; }
        std::suspend_always initial_suspend() { return {}; }
        std::suspend_always final_suspend() noexcept { return {}; }
        std::suspend_always yield_value(T v) { value = v; return {}; }
        void return_void() {}
        void unhandled_exception() { std::terminate(); }
    };
    std::coroutine_handle<promise_type> h;
    explicit Generator(std::coroutine_handle<promise_type> x) : h(x) {}
    Generator(Generator&& o) noexcept : h(std::exchange(o.h, {})) {}
    Generator(const Generator&) = delete;
    ~Generator() { if (h) h.destroy(); }
    bool next() { h.resume(); return !h.done(); }
    T get() const { return h.promise().value; }
};
Generator<Vector3> lensPoints(int n, double size) {
    for (int i = 0; i < n; ++i) {
        const double px = randomBetween(-size, size);
        const double py = randomBetween(-size, size);
        co_yield Vector3{px, py, 0.0};
    }
}
Generator<Vector3> lightPoints(int n, Vector3 centre, double size) {
    for (int i = 0; i < n; ++i) co_yield centre + size * Vector3::randomInsideUnitSphere();
}
}
''', shadow=r'''
        const Vector3 start = P + N * kShadowBias;
        double reached = 0;
        auto points = lightPoints(settings().shadowRayCount, light.position(), settings().lightSize);
        while (points.next()) {
            const Vector3 towards = points.get() - start;
            const auto hit = scene.findClosestIntersection({start, towards.normalised()});
            reached += !hit || hit->distance > towards.magnitude();
        }
        colour += (diffuse + specular) * (reached / settings().shadowRayCount);''', lens=r'''
        const Ray ray = camera.castRay(x, y);
        const Vector3 focus = ray.evaluateAt(settings().dofFocalPlane / ray.direction.z);
        ColourRGB sum;
        auto points = lensPoints(settings().dofRayCount, settings().dofAmount);
        while (points.next()) sum += trace(scene, {points.get(), (focus - points.get()).normalised()}, settings().bounces);
        image.set(x, y, sum / settings().dofRayCount);''')
# ---------------------------------------------------------------- own geometry
OWN = r'''
namespace own {
template <typename T> struct Vec {
    T e[3];
    friend Vec operator-(Vec a, Vec b) { return {{a.e[0] - b.e[0], a.e[1] - b.e[1], a.e[2] - b.e[2]}}; }
    friend Vec operator+(Vec a, Vec b) { return {{a.e[0] + b.e[0], a.e[1] + b.e[1], a.e[2] + b.e[2]}}; }
    friend Vec operator*(T s, Vec a) { return {{s * a.e[0], s * a.e[1], s * a.e[2]}}; }
    friend T operator|(Vec a, Vec b) { return a.e[0] * b.e[0] + a.e[1] * b.e[1] + a.e[2] * b.e[2]; }
};
using V = Vec<double>;
inline V from(const Vector3& v) { return {{v.x, v.y, v.z}}; }

// Is the open segment from a to b cut by the object?
inline bool cuts(const SceneObject& thing, V a, V b) {
    const V d = b - a;
    if (const auto* s = dynamic_cast<const Sphere*>(&thing)) {
        const V m = a - from(s->centre());
        const double A = d | d, B = 2 * (m | d), C = (m | m) - s->radius() * s->radius();
        const double D = B * B - 4 * A * C;
        if (D < 0) return false;
        const double t1 = (-B - std::sqrt(D)) / (2 * A), t2 = (-B + std::sqrt(D)) / (2 * A);
        return (t1 > 0 && t1 < 1) || (t2 > 0 && t2 < 1);
    }
    if (const auto* p = dynamic_cast<const Plane*>(&thing)) {
        const V n = from(p->normal());
        const double below = d | n;
        if (below == 0) return false;
        const double t = ((from(p->point()) - a) | n) / below;
        return t > 0 && t < 1;
    }
    return false;
}
inline bool sees(const Scene& scene, V a, V b) {
    for (const auto& thing : scene.objects())
        if (cuts(*thing, a, b)) return false;
    return true;
}
}  // namespace own
'''
case('r-own-geometry', pre=OWN, shadow=r'''
        const own::V here = own::from(P + N * kShadowBias);
        int seen = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i)
            seen += own::sees(scene, here, own::from(light.position()) + settings().lightSize * own::from(Vector3::randomInsideUnitSphere()));
        colour += (diffuse + specular) * (double(seen) / settings().shadowRayCount);''')
case('r-own-geometry-rand', inc='#include <cstdlib>', pre=OWN + r'''
namespace {
double rnd() { return rand() / (RAND_MAX + 1.0); }
}
''', shadow=r'''
        const own::V here = own::from(P + N * kShadowBias);
        int seen = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            double a, b, c;
            do { a = 2 * rnd() - 1; b = 2 * rnd() - 1; c = 2 * rnd() - 1; } while (a * a + b * b + c * c > 1);
            seen += own::sees(scene, here, own::from(light.position()) + settings().lightSize * own::V{{a, b, c}});
        }
        colour += (diffuse + specular) * (double(seen) / settings().shadowRayCount);''',
     lens=lensPoint('settings().dofAmount * (2 * rnd() - 1)', 'settings().dofAmount * (2 * rnd() - 1)'))
case('r-any-hit-objects', shadow=r'''
        const auto blocked = [&](const Ray& r, double upTo) {
            return std::any_of(scene.objects().begin(), scene.objects().end(), [&](const auto& o) {
                const auto h = o->intersectionWith(r);
                return h && h->distance < upTo;
            });
        };
        int free = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 s = P + N * kShadowBias;
            const Vector3 w = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere() - s;
            if (!blocked(Ray{s, w}, 1.0)) free++;
        }
        colour += (diffuse + specular) * (free / (double)settings().shadowRayCount);''')
case('r-from-the-light', shadow=r'''
        // Light travels from the lamp to the surface, so do these rays.
        const Vector3 end = P + N * kShadowBias;
        int lost = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 lamp = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 way = end - lamp;
            const double length = way.magnitude();
            const auto hit = scene.findClosestIntersection(Ray{lamp, way / length});
            if (hit && hit->distance < length - 1e-6) ++lost;
        }
        const double lit = 1.0 - lost / static_cast<double>(settings().shadowRayCount);
        colour += lit * (diffuse + specular);''')
case('r-horizon-first', shadow=SHADOW.replace('            const auto hit', '            if (N.dot(towards) <= 0.0) continue;  // below the horizon: the surface itself is in the way\n            const auto hit'),
     lens=LENS)
case('r-skip-dark', shadow='        if (diffuse == ColourRGB{} && specular == ColourRGB{}) continue;\n' + SHADOW)
case('r-squared-distances', shadow=SHADOW.replace('if (!hit || hit->distance > towards.magnitude()) ++reached;',
  '''if (hit) {
                const Vector3 a = hit->location - start;
                if (a.dot(a) < towards.dot(towards)) continue;
            }
            reached++;'''))
case('r-unnormalised', shadow=SHADOW.replace('towards.normalised()', 'towards').replace('hit->distance > towards.magnitude()', 'hit->distance > 1.0'),
     lens=LENS.replace('(focus - lens).normalised()', 'focus - lens'))
case('r-bias-along-ray', shadow=r'''
        int reached = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 target = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 dir = (target - P).normalised();
            const auto hit = scene.findClosestIntersection(Ray{P + dir * 1e-4, dir});
            if (!hit || hit->distance > (target - P).magnitude() - 1e-4) ++reached;
        }
        colour += (diffuse + specular) * (1.0 * reached / settings().shadowRayCount);''')
case('r-bias-thousandth', shadow=SHADOW.replace('N * kShadowBias', 'N * 1e-3').replace('towards = target - start', 'towards = target - P'))
# ---------------------------------------------------------------- samplers
case('r-drand48', inc='#include <cstdlib>\n#include <ctime>', pre=r'''
namespace { const bool seeded = (srand48(time(nullptr)), true); }
''', shadow=r'''
        int reached = 0;
        for (int i = 0; i < settings().shadowRayCount; i++) {
            Vector3 d;
            do d = Vector3(drand48() - 0.5, drand48() - 0.5, drand48() - 0.5); while (d.magnitude() > 0.5);
            Vector3 target = light.position() + d * 2 * settings().lightSize;
            Vector3 start = P + N * kShadowBias;
            Ray ray(start, (target - start).normalised());
            auto hit = scene.findClosestIntersection(ray);
            if (hit && hit->distance < (target - start).magnitude()) continue;
            reached++;
        }
        (void)seeded;
        colour += (diffuse + specular) * ((double)reached / settings().shadowRayCount);''',
     lens=lensPoint('(drand48() - 0.5) * 2 * settings().dofAmount', '(drand48() - 0.5) * 2 * settings().dofAmount'))
case('r-normal-cbrt', inc='#include <random>', pre=r'''
namespace {
thread_local std::minstd_rand rng{std::random_device{}()};
Vector3 ballPoint(double radius) {
    std::normal_distribution<double> gauss;
    const Vector3 g{gauss(rng), gauss(rng), gauss(rng)};
    return g.normalised() * (radius * std::cbrt(std::uniform_real_distribution<double>{}(rng)));
}
}
''', shadow=shadowTarget('ballPoint(settings().lightSize)'))
case('r-polar-cbrt', shadow=SHADOW.replace('            const Vector3 target', '''            const double phi = randomBetween(0, 2 * std::numbers::pi);
            const double cosTheta = randomBetween(-1, 1);
            const double sinTheta = std::sqrt(1 - cosTheta * cosTheta);
            const double radius = settings().lightSize * std::pow(randomBetween(0, 1), 1.0 / 3.0);
            const Vector3 target''').replace('Vector3::randomInsideUnitSphere() * settings().lightSize',
            'radius * Vector3{sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta}'))
HALTON = r'''
namespace {
double radicalInverse(unsigned base, unsigned i) {
    double f = 1, r = 0;
    for (; i > 0; i /= base) { f /= base; r += f * (i % base); }
    return r;
}
double wrap(double a) { return a - std::floor(a); }
}
'''
BALL3 = r'''            const double cz = 2 * b - 1, sz = std::sqrt(std::max(0.0, 1 - cz * cz)), rad = std::cbrt(c);
            const Vector3 inside = rad * Vector3{sz * std::cos(2 * std::numbers::pi * a), sz * std::sin(2 * std::numbers::pi * a), cz};
            const Vector3 target = light.position() + inside * settings().lightSize;
'''
OLDTARGET = '''            const Vector3 target =
                light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
'''
OLDLENS = '''            const Vector3 lens{settings().dofAmount * randomBetween(-1, 1),
                               settings().dofAmount * randomBetween(-1, 1), 0.0};
'''
case('r-halton-rotated', pre=HALTON, shadow=('        const double ra = randomBetween(0, 1), rb = randomBetween(0, 1), rc = randomBetween(0, 1);\n' + SHADOW).replace(OLDTARGET,
  '            const unsigned n = static_cast<unsigned>(i) + 1;\n            const double a = wrap(radicalInverse(2, n) + ra), b = wrap(radicalInverse(3, n) + rb), c = wrap(radicalInverse(5, n) + rc);\n' + BALL3),
  lens=('        const double rx = randomBetween(0, 1), ry = randomBetween(0, 1);\n' + LENS).replace(OLDLENS,
  '''            const unsigned n = static_cast<unsigned>(i) + 1;
            const Vector3 lens{settings().dofAmount * (2 * wrap(radicalInverse(2, n) + rx) - 1),
                               settings().dofAmount * (2 * wrap(radicalInverse(3, n) + ry) - 1), 0.0};
'''))
case('r-sobol-scrambled', inc='#include <cstdint>', pre=r'''
namespace {
std::uint32_t sobolX(std::uint32_t n) {
    std::uint32_t r = 0;
    for (std::uint32_t v = 1u << 31; n; n >>= 1, v >>= 1) if (n & 1) r ^= v;
    return r;
}
std::uint32_t sobolY(std::uint32_t n) {
    std::uint32_t r = 0;
    for (std::uint32_t v = 1u << 31; n; n >>= 1, v ^= v >> 1) if (n & 1) r ^= v;
    return r;
}
double unit(std::uint32_t a) { return a * 0x1p-32; }
}
''', lens=('        const auto sx = static_cast<std::uint32_t>(randomBetween(0, 4294967296.0)), sy = static_cast<std::uint32_t>(randomBetween(0, 4294967296.0));\n' + LENS).replace(OLDLENS,
  '''            const auto n = static_cast<std::uint32_t>(i);
            const Vector3 lens{settings().dofAmount * (2 * unit(sobolX(n) ^ sx) - 1),
                               settings().dofAmount * (2 * unit(sobolY(n) ^ sy) - 1), 0.0};
'''))
case('r-strata-5x10', shadow=SHADOW.replace(OLDTARGET, '''            // strata in the angle, plain random in the others
            const double a = (i + randomBetween(0, 1)) / settings().shadowRayCount, b = randomBetween(0, 1), c = randomBetween(0, 1);
''' + BALL3), lens=LENS.replace('        ColourRGB sum;', '''        ColourRGB sum;
        int rows = static_cast<int>(std::sqrt(settings().dofRayCount));
        while (settings().dofRayCount % rows != 0) --rows;
        const int columns = settings().dofRayCount / rows;''').replace(OLDLENS, '''            const double u = (i % columns + randomBetween(0, 1)) / columns;
            const double v = (i / columns + randomBetween(0, 1)) / rows;
            const Vector3 lens{settings().dofAmount * (2 * u - 1), settings().dofAmount * (2 * v - 1), 0.0};
'''))
case('r-latin-hypercube', inc='#include <numeric>\n#include <random>\n#include <vector>', pre=r'''
namespace {
std::vector<double> shuffledStrata(int n) {
    thread_local std::mt19937 g{std::random_device{}()};
    std::vector<double> s(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) s[static_cast<std::size_t>(i)] = (i + std::generate_canonical<double, 53>(g)) / n;
    std::shuffle(s.begin(), s.end(), g);
    return s;
}
}
''', shadow=('        const auto A = shuffledStrata(settings().shadowRayCount), B = shuffledStrata(settings().shadowRayCount), C = shuffledStrata(settings().shadowRayCount);\n' + SHADOW).replace(OLDTARGET,
  '            const auto k = static_cast<std::size_t>(i);\n            const double a = A[k], b = B[k], c = C[k];\n' + BALL3),
  lens=('        const auto U = shuffledStrata(settings().dofRayCount), V = shuffledStrata(settings().dofRayCount);\n' + LENS).replace(OLDLENS, '''            const auto k = static_cast<std::size_t>(i);
            const Vector3 lens{settings().dofAmount * (2 * U[k] - 1), settings().dofAmount * (2 * V[k] - 1), 0.0};
'''))
case('r-table-4096', inc='#include <array>\n#include <random>', pre=r'''
namespace {
// Made once; every point starts at another place in it.
const std::array<Vector3, 4096>& ballTable() {
    static const auto table = [] {
        std::array<Vector3, 4096> t;
        std::mt19937 g{2024};
        std::uniform_real_distribution<double> u{-1, 1};
        for (auto& v : t)
            do v = {u(g), u(g), u(g)}; while (v.dot(v) > 1);
        return t;
    }();
    return table;
}
}
''', shadow=('        const auto first = static_cast<std::size_t>(randomBetween(0, 4096));\n' + SHADOW).replace('Vector3::randomInsideUnitSphere()',
  'ballTable()[(first + static_cast<std::size_t>(i)) % 4096]'))
case('r-best-candidate', inc='#include <vector>\n#include <array>', pre=r'''
namespace {
std::vector<std::array<double, 2>> blueNoise(int n) {
    std::vector<std::array<double, 2>> out;
    while (static_cast<int>(out.size()) < n) {
        std::array<double, 2> best{};
        double far = -1;
        for (int c = 0; c < 4; ++c) {
            const std::array<double, 2> p{randomBetween(-1, 1), randomBetween(-1, 1)};
            double near = 1e9;
            for (const auto& q : out) {  // on the torus, so that the edges get no more than their share
                const double dx = std::abs(p[0] - q[0]), dy = std::abs(p[1] - q[1]);
                near = std::min(near, std::hypot(std::min(dx, 2 - dx), std::min(dy, 2 - dy)));
            }
            if (near > far) { far = near; best = p; }
        }
        out.push_back(best);
    }
    return out;
}
}
''', lens=('        const auto dots = blueNoise(settings().dofRayCount);\n' + LENS).replace(OLDLENS, '''            const auto& dot = dots[static_cast<std::size_t>(i)];
            const Vector3 lens{settings().dofAmount * dot[0], settings().dofAmount * dot[1], 0.0};
'''))
case('r-antithetic', shadow=SHADOW.replace('        int reached = 0;', '        int reached = 0;\n        Vector3 last;').replace(OLDTARGET, '''            last = i % 2 == 0 ? Vector3::randomInsideUnitSphere() : -last;
            const Vector3 target = light.position() + last * settings().lightSize;
'''), lens=LENS.replace('        ColourRGB sum;', '        ColourRGB sum;\n        Vector3 lens;').replace(OLDLENS, '''            if (i % 2 == 0)
                lens = Vector3{randomBetween(-1, 1), randomBetween(-1, 1), 0} * settings().dofAmount;
            else
                lens = -lens;
'''))
case('r-r2-sequence', pre=HALTON, lens=('        const double rx = randomBetween(0, 1), ry = randomBetween(0, 1);\n' + LENS).replace(OLDLENS, '''            const Vector3 lens{settings().dofAmount * (2 * wrap(rx + i * 0.7548776662466927) - 1),
                               settings().dofAmount * (2 * wrap(ry + i * 0.5698402909980532) - 1), 0.0};
'''))
case('r-table-rotated-lens', inc='#include <array>\n#include <random>\n#include <vector>', pre=HALTON + r'''
namespace {
const std::vector<std::array<double, 2>>& offsets(int n) {
    static std::vector<std::array<double, 2>> t = [&] {
        std::vector<std::array<double, 2>> made(static_cast<std::size_t>(n));
        std::mt19937 g(1);
        for (auto& o : made) o = {g() / 4294967296.0, g() / 4294967296.0};
        return made;
    }();
    return t;
}
}
''', lens=('        const double rx = randomBetween(0, 1), ry = randomBetween(0, 1);\n' + LENS).replace(OLDLENS, '''            const auto& table = offsets(settings().dofRayCount);
            const auto& o = table[static_cast<std::size_t>(i) % table.size()];
            const Vector3 lens{settings().dofAmount * (2 * wrap(o[0] + rx) - 1), settings().dofAmount * (2 * wrap(o[1] + ry) - 1), 0.0};
'''))
# ---------------------------------------------------------------- focal points and cameras
case('r-focal-similar-triangles', lens=LENS.replace('pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z)',
  'Vector3{pinhole.direction.x / pinhole.direction.z * settings().dofFocalPlane, pinhole.direction.y / pinhole.direction.z * settings().dofFocalPlane, settings().dofFocalPlane}'))
case('r-focal-cosine', lens=LENS.replace('pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z)',
  'pinhole.evaluateAt(settings().dofFocalPlane / std::cos(std::acos(pinhole.direction.dot(Vector3{0, 0, 1}))))'))
case('r-focal-plane-object', lens=LENS.replace('pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z)',
  'Plane{{0, 0, settings().dofFocalPlane}, {0, 0, -1}, Material{}}.intersectionWith(pinhole)->location'))
case('r-half-aperture', lens=lensPoint('settings().dofAmount * (randomBetween(0, 1) - 0.5)', 'settings().dofAmount * (randomBetween(0, 1) - 0.5)'))
case('r-own-camera-matrix', lens=r'''
        // camera space -> world: the identity here, kept for the day the camera moves
        const double world[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
        const auto apply = [&](double a, double b, double c, double w) {
            const double in[4] = {a, b, c, w};
            double out[3] = {0, 0, 0};
            for (int r = 0; r < 3; ++r)
                for (int k = 0; k < 4; ++k) out[r] += world[r][k] * in[k];
            return Vector3{out[0], out[1], out[2]};
        };
        const bool part = !settings().region.isWholeFrame();
        const double px = x + (part ? settings().region.x : 0), py = y + (part ? settings().region.y : 0);
        const double aspect = double(settings().width) / settings().height;
        const double tanX = std::tan(std::numbers::pi / 8), tanY = tanX / aspect;
        const double ndcX = 2 * (px + 0.5) / settings().width - 1, ndcY = 1 - 2 * (py + 0.5) / settings().height;
        const double f = settings().dofFocalPlane;
        const Vector3 focus = apply(ndcX * tanX * f, ndcY * tanY * f, f, 1);
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const Vector3 eye = apply(settings().dofAmount * randomBetween(-1, 1), settings().dofAmount * randomBetween(-1, 1), 0, 1);
            sum += trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);''')
LOOPTRACE = r'''
namespace {
ColourRGB follow(const Renderer& r, const Scene& scene, Ray ray, int bounces) {
    ColourRGB total;
    double weight = 1.0;
    for (;;) {
        const auto hit = scene.findClosestIntersection(ray);
        if (!hit) return total + weight * kBackgroundColour;
        const double share = bounces > 0 ? hit->object->reflectivity() : 0.0;
        total += weight * (1.0 - share) * r.illuminate(scene, *hit->object, hit->location, hit->normal, ray.origin);
        if (share <= 0.0) return total;
        weight *= share;
        bounces--;
        ray = Ray{hit->location + hit->normal * kShadowBias, ray.direction - hit->normal * (2 * ray.direction.dot(hit->normal))};
    }
}
}
'''
case('r-own-trace-loop', pre=LOOPTRACE, lens=LENS.replace('trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)',
  'follow(*this, scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)'))
# ---------------------------------------------------------------- styles
case('r-functional', inc='#include <functional>\n#include <numeric>\n#include <ranges>\n#include <utility>', shadow=r'''
        const auto indices = std::views::iota(0, settings().shadowRayCount);
        const Vector3 above = P + kShadowBias * N;
        const auto lit = std::ranges::count_if(
            indices | std::views::transform([&](int) { return light.position() + settings().lightSize * Vector3::randomInsideUnitSphere() - above; }) |
                std::views::transform([&](const Vector3& way) { return std::pair{way.magnitude(), scene.findClosestIntersection(Ray{above, way.normalised()})}; }),
            [](const auto& p) { return !(p.second && p.second->distance <= p.first); });
        colour += (diffuse + specular) * (static_cast<double>(lit) / static_cast<double>(indices.size()));''', lens=r'''
        const Vector3 focus = [&, r = camera.castRay(x, y)] { return r.evaluateAt(settings().dofFocalPlane / r.direction.z); }();
        auto rays = std::views::iota(0, settings().dofRayCount) | std::views::transform([&](int) {
            const auto a = settings().dofAmount;
            const Vector3 eye{randomBetween(-a, a), randomBetween(-a, a), 0};
            return trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
        });
        image.set(x, y, std::accumulate(rays.begin(), rays.end(), ColourRGB{}) / settings().dofRayCount);''')
case('r-java-like', inc='#include <memory>\n#include <vector>', pre=r'''
class IRandomSource {
public:
    virtual ~IRandomSource() = default;
    virtual double nextDouble() = 0;
};
class MathRandom : public IRandomSource {
public:
    double nextDouble() override { return randomBetween(0.0, 1.0); }
};
class ApertureSampler {
public:
    ApertureSampler(std::shared_ptr<IRandomSource> source, double amount) : source(source), amount(amount) {}
    Vector3 getSample() {
        double x = (this->source->nextDouble() * 2 - 1) * this->amount;
        double y = (this->source->nextDouble() * 2 - 1) * this->amount;
        return Vector3(x, y, 0);
    }
private:
    std::shared_ptr<IRandomSource> source;
    double amount;
};
class ShadowEstimator {
public:
    ShadowEstimator(const Scene& scene, const RenderSettings& settings) : scene(scene), settings(settings) {}
    double getProportionLit(const PointLight& light, const Vector3& point, const Vector3& normal) {
        int numberOfOccludedRays = 0;
        for (int i = 0; i < settings.shadowRayCount; i++) {
            Vector3 lightPosition = light.position() + Vector3::randomInsideUnitSphere() * settings.lightSize;
            Vector3 origin = point + normal * kShadowBias;
            Vector3 direction = (lightPosition - origin).normalised();
            std::optional<RaycastHit> hit = scene.findClosestIntersection(Ray(origin, direction));
            double distanceToLight = (lightPosition - origin).magnitude();
            if (hit.has_value() && hit.value().distance < distanceToLight) numberOfOccludedRays++;
        }
        return 1.0 - (double)numberOfOccludedRays / (double)settings.shadowRayCount;
    }
private:
    const Scene& scene;
    const RenderSettings& settings;
};
''', shadow=r'''
        ShadowEstimator estimator = ShadowEstimator(scene, settings());
        double lit = estimator.getProportionLit(light, P, N);
        colour = colour + diffuse * lit + specular * lit;''', lens=r'''
        std::unique_ptr<ApertureSampler> sampler = std::make_unique<ApertureSampler>(std::make_shared<MathRandom>(), settings().dofAmount);
        std::vector<ColourRGB> colours;
        Ray original = camera.castRay(x, y);
        double t = (settings().dofFocalPlane - original.origin.z) / original.direction.z;
        Vector3 focalPoint = original.evaluateAt(t);
        for (int i = 0; i < settings().dofRayCount; i++) {
            Vector3 newOrigin = original.origin + sampler->getSample();
            Vector3 newDirection = (focalPoint - newOrigin).normalised();
            colours.push_back(trace(scene, Ray(newOrigin, newDirection), settings().bounces));
        }
        ColourRGB average = ColourRGB(0);
        for (const ColourRGB& c : colours) average = average + c * (1.0 / settings().dofRayCount);
        image.set(x, y, average);''')
case('r-recursive-sum', inc='#include <functional>', shadow=r'''
        const std::function<int(int)> arrive = [&](int left) -> int {
            if (left == 0) return 0;
            const Vector3 s = P + N * kShadowBias;
            const Vector3 w = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - s;
            const auto h = scene.findClosestIntersection({s, w.normalised()});
            return (h && h->distance < w.magnitude() ? 0 : 1) + arrive(left - 1);
        };
        colour += (diffuse + specular) * (arrive(settings().shadowRayCount) * 1.0 / settings().shadowRayCount);''', lens=r'''
        const Ray r = camera.castRay(x, y);
        const Vector3 f = r.direction * (settings().dofFocalPlane / r.direction.z);
        const std::function<ColourRGB(int)> sum = [&](int n) -> ColourRGB {
            if (n == 1) {
                const Vector3 o{settings().dofAmount * randomBetween(-1, 1), settings().dofAmount * randomBetween(-1, 1), 0};
                return trace(scene, {o, (f - o).normalised()}, settings().bounces);
            }
            return sum(n / 2) + sum(n - n / 2);
        };
        image.set(x, y, sum(settings().dofRayCount) / settings().dofRayCount);''')
case('r-rays-outside-lights-inside', inc='#include <vector>', edit=[], whole=r'''
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <algorithm>
#include <cmath>
#include <vector>
namespace raytracer {
ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P, const Vector3& N, const Vector3& O) const {
    const auto& lights = scene.pointLights();
    std::vector<double> lit(lights.size(), 0.0);
    for (int ray = 0; ray < settings().shadowRayCount; ++ray)
        for (std::size_t l = 0; l < lights.size(); ++l) {
            const Vector3 s = P + N * kShadowBias;
            const Vector3 w = lights[l].position() + settings().lightSize * Vector3::randomInsideUnitSphere() - s;
            const auto h = scene.findClosestIntersection({s, w.normalised()});
            if (!h || h->distance >= w.magnitude()) lit[l] += 1.0 / settings().shadowRayCount;
        }
    ColourRGB colour = scene.ambientLighting() * object.colour();
    const Vector3 V = (O - P).normalised();
    for (std::size_t l = 0; l < lights.size(); ++l) {
        const Vector3 L = (lights[l].position() - P).normalised();
        const ColourRGB I = lights[l].illuminationAt((lights[l].position() - P).magnitude());
        const Vector3 R = 2 * N.dot(L) * N - L;
        colour += lit[l] * (object.phongKD() * std::max(0.0, N.dot(L)) * object.colour() * I +
                            object.phongKS() * std::pow(std::max(0.0, R.dot(V)), object.phongAlpha()) * lights[l].colour() * I);
    }
    return colour;
}
Image Renderer::render(const Scene& scene) const {
    Camera camera(settings());
    Image image(settings());
    std::vector<ColourRGB> sums(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
    // one lens ray for every pixel, then the next: a preview could be shown after each pass
    for (int pass = 0; pass < settings().dofRayCount; ++pass)
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const Ray r = camera.castRay(x, y);
                const Vector3 f = r.direction * (settings().dofFocalPlane / r.direction.z);
                const Vector3 o{settings().dofAmount * randomBetween(-1, 1), settings().dofAmount * randomBetween(-1, 1), 0};
                sums[static_cast<std::size_t>(y * image.width() + x)] += trace(scene, {o, (f - o).normalised()}, settings().bounces);
            }
    for (int y = image.height(); y-- > 0;)
        for (int x = 0; x < image.width(); ++x) image.set(x, y, sums[static_cast<std::size_t>(y * image.width() + x)] / settings().dofRayCount);
    return image;
}
}
''')
PERRAY = r'''
        const Vector3 start = P + N * kShadowBias;
        ColourRGB gathered;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 lamp = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize;
            const Vector3 way = lamp - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            if (hit && hit->distance < way.magnitude()) continue;
            const Vector3 L = (lamp - P).normalised();
            const ColourRGB I = light.illuminationAt((lamp - P).magnitude());
            gathered += object.colour() * I * (object.phongKD() * std::max(0.0, N.dot(L)));
            gathered += light.colour() * I * (object.phongKS() * std::pow(std::max(0.0, L.reflectIn(N).dot(toViewer)), object.phongAlpha()));
        }
        colour += gathered / settings().shadowRayCount;'''
case('r-phong-each-ray', shadow='        (void)diffuse; (void)specular;' + PERRAY)
case('r-phong-each-ray-threads', shadow='        (void)diffuse; (void)specular;' + PERRAY, inc='#include <thread>', render=r'''
Image Renderer::render(const Scene& scene) const {
    Image image{settings()};
    auto half = [&](int parity) {
        const Camera camera{settings()};
        for (int y = parity; y < image.height(); y += 2)
            for (int x = 0; x < image.width(); ++x) {
                const Ray ray = camera.castRay(x, y);
                const Vector3 focus = ray.direction * (settings().dofFocalPlane / ray.direction.z);
                ColourRGB sum;
                for (int i = 0; i < settings().dofRayCount; ++i) {
                    const Vector3 eye = settings().dofAmount * Vector3{randomBetween(-1, 1), randomBetween(-1, 1), 0};
                    sum += trace(scene, {eye, (focus - eye).normalised()}, settings().bounces);
                }
                image.set(x, y, sum / settings().dofRayCount);
            }
    };
    std::jthread other{half, 1};
    half(0);
    return image;
}
''')
case('r-half-pairs-of-sums', lens=r'''
        // one-liner lovers' version
        const auto [o, d] = camera.castRay(x, y);
        const double A = settings().dofAmount, F = settings().dofFocalPlane;
        ColourRGB c;
        for (int n = settings().dofRayCount; n; --n) { const double i = randomBetween(-A, A), j = randomBetween(-A, A); c += trace(scene, Ray{{i, j, 0}, Vector3{d.x / d.z * F - i, d.y / d.z * F - j, F}.normalised()}, settings().bounces); }
        (void)o;
        image.set(x, y, c *= 1.0 / settings().dofRayCount);''',
  shadow='''        int k = 0;
        for (int n = settings().shadowRayCount; n--;) { const Vector3 s = P + N * kShadowBias, w = light.position() + settings().lightSize * Vector3::randomInsideUnitSphere() - s; const auto h = scene.findClosestIntersection({s, w}); k += !h || h->distance > 1; }
        colour += (diffuse + specular) * (k * 1.0 / settings().shadowRayCount);''')
case('r-template-heavy', inc='#include <concepts>\n#include <type_traits>\n#include <tuple>', pre=r'''
namespace detail {
template <std::invocable F>
auto mean(int n, F&& f) {
    using R = std::invoke_result_t<F>;
    R sum{};
    for (int i = 0; i < n; ++i) sum += f();
    return sum / n;
}
template <class Tag> struct Sampler;
struct Ball {};
struct Square {};
template <> struct Sampler<Ball> { static Vector3 draw() { return Vector3::randomInsideUnitSphere(); } };
template <> struct Sampler<Square> { static Vector3 draw() { return {randomBetween(-1.0, 1.0), randomBetween(-1.0, 1.0), 0.0}; } };
}
''', shadow='''        const Vector3 start = P + N * kShadowBias;
        const double visibility = detail::mean(settings().shadowRayCount, [&]() -> double {
            const Vector3 towards = light.position() + detail::Sampler<detail::Ball>::draw() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection({start, towards.normalised()});
            return hit && hit->distance < towards.magnitude() ? 0.0 : 1.0;
        });
        colour += (diffuse + specular) * visibility;''', lens='''        const Ray pinhole = camera.castRay(x, y);
        const Vector3 focus = pinhole.evaluateAt(settings().dofFocalPlane / pinhole.direction.z);
        image.set(x, y, detail::mean(settings().dofRayCount, [&]() -> ColourRGB {
            const Vector3 eye = detail::Sampler<detail::Square>::draw() * settings().dofAmount;
            return trace(scene, Ray{eye, (focus - eye).normalised()}, settings().bounces);
        }));''')
case('r-twice-the-rays', shadow=SHADOW.replace('settings().shadowRayCount', '(2 * settings().shadowRayCount)'))
case('r-own-everything', pre=OWN + r'''
namespace {
struct Meeting { double t = INFINITY; const SceneObject* what = nullptr; };
Meeting nearest(const Scene& scene, const Ray& ray) {
    Meeting best;
    for (const auto& thing : scene.objects()) {
        double t = INFINITY;
        if (const auto* s = dynamic_cast<const Sphere*>(thing.get())) {
            const Vector3 m = ray.origin - s->centre();
            const double b = m.dot(ray.direction), c = m.dot(m) - s->radius() * s->radius(), D = b * b - c;
            if (D >= 0) {
                if (-b - std::sqrt(D) > 0) t = -b - std::sqrt(D);
                else if (-b + std::sqrt(D) > 0) t = -b + std::sqrt(D);
            }
        } else if (const auto* p = dynamic_cast<const Plane*>(thing.get())) {
            const double down = ray.direction.dot(p->normal());
            if (down != 0) { const double at = (p->point() - ray.origin).dot(p->normal()) / down; if (at > 0) t = at; }
        }
        if (t < best.t) best = {t, thing.get()};
    }
    return best;
}
ColourRGB shade(const Renderer& r, const Scene& scene, const Ray& ray, int depth) {
    const Meeting m = nearest(scene, ray);
    if (!m.what) return kBackgroundColour;
    const Vector3 at = ray.evaluateAt(m.t), n = m.what->getNormalAt(at);
    ColourRGB c = r.illuminate(scene, *m.what, at, n, ray.origin);
    const double k = m.what->reflectivity();
    if (depth == 0 || k == 0) return c;
    return c * (1 - k) + k * shade(r, scene, Ray{at + n * kShadowBias, (-ray.direction).reflectIn(n)}, depth - 1);
}
}
''', shadow=r'''
        const own::V here = own::from(P + N * kShadowBias);
        int seen = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i)
            seen += own::sees(scene, here, own::from(light.position()) + settings().lightSize * own::from(Vector3::randomInsideUnitSphere()));
        colour += (diffuse + specular) * (double(seen) / settings().shadowRayCount);''',
   lens=LENS.replace('trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)', 'shade(*this, scene, Ray{lens, (focus - lens).normalised()}, settings().bounces)'))

if __name__ == '__main__':
    out = pathlib.Path(sys.argv[1])
    bumpy = pathlib.Path(sys.argv[2]).read_text()
    for name, text in CASES.items():
        d = out / name
        d.mkdir(parents=True, exist_ok=True)
        (d / 'Renderer.cpp').write_text(text)
        (d / 'BumpySphere.cpp').write_text(bumpy)
    print(len(CASES))

# name -> body of getNormalAt (or, when it starts with "FILE", the whole file after the includes)
R = {}
R["r01-derivatives-central"] = r'''
    const double pi = std::numbers::pi;
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double u = 0.5 + lambda / (2 * pi);
    const double v = theta / pi;
    const int w = heightMap().width(), h = heightMap().height();
    const int c = std::min(w - 1, static_cast<int>(u * w));
    const int r = std::min(h - 1, static_cast<int>(v * h));
    auto B = [&](int x, int y) { return heightMap().at((x % w + w) % w, std::clamp(y, 0, h - 1)); };
    const double bu = (B(c + 1, r) - B(c - 1, r)) / 2;
    const double bv = (B(c, r + 1) - B(c, r - 1)) / 2;
    const Vector3 pu{std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 pv{std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
    return (n - pu * bu - pv * bv).normalised();
'''
R["r02-quaternion"] = r'''FILE
namespace {
struct Quaternion {
    double w, x, y, z;
    static Quaternion about(const raytracer::Vector3& axis, double angle) {
        const double s = std::sin(angle / 2);
        return {std::cos(angle / 2), axis.x * s, axis.y * s, axis.z * s};
    }
    Quaternion operator*(const Quaternion& q) const {
        return {w * q.w - x * q.x - y * q.y - z * q.z, w * q.x + x * q.w + y * q.z - z * q.y,
                w * q.y - x * q.z + y * q.w + z * q.x, w * q.z + x * q.y - y * q.x + z * q.w};
    }
    raytracer::Vector3 rotate(const raytracer::Vector3& p) const {
        const Quaternion r = *this * Quaternion{0, p.x, p.y, p.z} * Quaternion{w, -x, -y, -z};
        return {r.x, r.y, r.z};
    }
};
}
namespace raytracer {
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    double phi = std::atan2(n.z, n.x);
    if (phi < 0) phi += 2 * M_PI;
    const double theta = std::acos(n.y);
    const HeightMap& m = heightMap();
    int c = static_cast<int>(phi / (2 * M_PI) * m.width());
    int r = static_cast<int>(theta / M_PI * m.height());
    if (c >= m.width()) c = m.width() - 1;
    if (r >= m.height()) r = m.height() - 1;
    const double here = m.at(c, r);
    const double bu = m.at((c + 1) % m.width(), r) - here;
    const double bv = r + 1 < m.height() ? m.at(c, r + 1) - here : 0.0;
    const Vector3 pu{-std::sin(phi), 0, std::cos(phi)};
    const Vector3 pv{std::cos(theta) * std::cos(phi), -std::sin(theta), std::cos(theta) * std::sin(phi)};
    // turning n about n x pu by +a moves it towards pu, so turn by -a
    const Quaternion q = Quaternion::about(n.cross(pu), -std::atan(bu)) * Quaternion::about(n.cross(pv), -std::atan(bv));
    return q.rotate(n).normalised();
}
}
'''
R["r03-tbn-matrix"] = r'''
    using Matrix = std::array<std::array<double, 3>, 3>;
    const Vector3 n = (position - centre()) / radius();
    const double s = std::sqrt(n.x * n.x + n.z * n.z);
    if (s < 1e-9) return n.normalised();
    const Vector3 T{-n.z / s, 0, n.x / s};
    const Vector3 D = Vector3{-n.y * n.x / s, s, -n.y * n.z / s} * -1.0;
    const Matrix tbn{{{T.x, D.x, n.x}, {T.y, D.y, n.y}, {T.z, D.z, n.z}}};
    const int W = heightMap().width();
    const int H = heightMap().height();
    double u = std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi);
    u -= std::floor(u);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const int i = static_cast<int>(std::lround(u * (W - 1)));
    const int j = static_cast<int>(std::lround(v * (H - 1)));
    const int i2 = i == W - 1 ? 0 : i + 1;
    const int j2 = std::min(j + 1, H - 1);
    const std::array<double, 3> t{-(heightMap().at(i2, j) - heightMap().at(i, j)),
                                  -(heightMap().at(i, j2) - heightMap().at(i, j)), 1.0};
    std::array<double, 3> out{};
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b) out[a] += tbn[a][b] * t[b];
    return Vector3{out[0], out[1], out[2]}.normalised();
'''
R["r04-tilt-the-angles"] = r'''
    constexpr double kStrength = 0.3;
    const Vector3 n = Sphere::getNormalAt(position);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double phi = std::atan2(n.z, n.x);
    const auto& map = heightMap();
    const double u = (phi + std::numbers::pi) / (2 * std::numbers::pi);
    const double v = theta / std::numbers::pi;
    const int x = static_cast<int>(u * map.width()) % map.width();
    const int y = std::min(static_cast<int>(v * map.height()), map.height() - 1);
    const double b = map.at(x, y);
    const double du = map.at((x + 1) % map.width(), y) - b;
    const double dv = (y + 1 < map.height() ? map.at(x, y + 1) : b) - b;
    // the normal of a slope that rises towards +phi looks like the normal of a smaller phi
    const double t2 = theta - kStrength * dv;
    const double p2 = phi - kStrength * du;
    return {std::sin(t2) * std::cos(p2), std::cos(t2), std::sin(t2) * std::sin(p2)};
'''
R["r05-displaced-surface"] = r'''FILE
namespace raytracer {
namespace {
constexpr double kPi = std::numbers::pi;
double sample(const HeightMap& map, double u, double v) {
    const double x = u * map.width() - 0.5;
    const double y = v * map.height() - 0.5;
    const int x0 = static_cast<int>(std::floor(x));
    const int y0 = static_cast<int>(std::floor(y));
    const double fx = x - x0, fy = y - y0;
    const auto texel = [&](int c, int r) {
        return map.at((c % map.width() + map.width()) % map.width(), std::clamp(r, 0, map.height() - 1));
    };
    return (1 - fy) * ((1 - fx) * texel(x0, y0) + fx * texel(x0 + 1, y0)) +
           fy * ((1 - fx) * texel(x0, y0 + 1) + fx * texel(x0 + 1, y0 + 1));
}
Vector3 surface(const HeightMap& map, double u, double v) {
    const double lambda = (u - 0.5) * 2 * kPi, theta = v * kPi;
    const double k = 1.0 + 0.02 * sample(map, u, v);
    return Vector3{std::sin(theta) * std::sin(lambda), std::cos(theta), -std::sin(theta) * std::cos(lambda)} * k;
}
}  // namespace
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double u = 0.5 + std::atan2(n.x, -n.z) / (2 * kPi);
    const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / kPi;
    const double du = 0.5 / heightMap().width(), dv = 0.5 / heightMap().height();
    const Vector3 alongU = surface(heightMap(), u + du, v) - surface(heightMap(), u - du, v);
    const Vector3 alongV = surface(heightMap(), u, v + dv) - surface(heightMap(), u, v - dv);
    Vector3 out = alongU.cross(alongV);
    if (!(out.magnitude() > 1e-15)) return n;
    out = out.normalised();
    return out.dot(n) < 0 ? -out : out;
}
}  // namespace raytracer
'''
R["r06-dual-numbers"] = r'''FILE
namespace raytracer {
namespace {
struct Dual {
    double value = 0, slope = 0;
    friend Dual operator*(Dual a, Dual b) { return {a.value * b.value, a.slope * b.value + a.value * b.slope}; }
    friend Dual operator-(Dual a) { return {-a.value, -a.slope}; }
};
Dual sin(Dual a) { return {std::sin(a.value), std::cos(a.value) * a.slope}; }
Dual cos(Dual a) { return {std::cos(a.value), -std::sin(a.value) * a.slope}; }
Vector3 slopeOf(Dual lambda, Dual theta) {
    const Dual x = sin(theta) * cos(lambda), y = cos(theta), z = sin(theta) * sin(lambda);
    return {x.slope, y.slope, z.slope};
}
}  // namespace
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.z, n.x), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const Vector3 pu = slopeOf({lambda, 1}, {theta, 0});
    const Vector3 pv = slopeOf({lambda, 0}, {theta, 1});
    const HeightMap& b = heightMap();
    const double u = lambda < 0 ? lambda / (2 * std::numbers::pi) + 1 : lambda / (2 * std::numbers::pi);
    const int c = std::min(static_cast<int>(u * b.width()), b.width() - 1);
    const int r = std::min(static_cast<int>(theta / std::numbers::pi * b.height()), b.height() - 1);
    const int left = (c + b.width() - 1) % b.width(), up = std::max(r - 1, 0);
    const double bu = b.at(c, r) - b.at(left, r), bv = b.at(c, r) - b.at(c, up);  // backward
    return (n - bu * pu - bv * pv).normalised();
}
}  // namespace raytracer
'''
R["r07-gradient-in-space"] = r'''FILE
namespace raytracer {
namespace {
double heightTowards(const HeightMap& map, const Vector3& direction) {
    const Vector3 d = direction.normalised();
    double u = std::atan2(d.x, d.z) / (2 * std::numbers::pi);
    u -= std::floor(u);
    const double v = std::acos(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi;
    const double x = u * map.width(), y = v * (map.height() - 1);
    const int c = static_cast<int>(x), r = std::min(static_cast<int>(y), map.height() - 2);
    const double fx = x - c, fy = y - r;
    const int c0 = c % map.width(), c1 = (c + 1) % map.width();
    return std::lerp(std::lerp(map.at(c0, r), map.at(c1, r), fx), std::lerp(map.at(c0, r + 1), map.at(c1, r + 1), fx), fy);
}
}  // namespace
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double e = 1.5 / std::max(heightMap().width(), heightMap().height());
    const auto along = [&](const Vector3& axis) {
        return (heightTowards(heightMap(), n + axis * e) - heightTowards(heightMap(), n - axis * e)) / (2 * e);
    };
    Vector3 g{along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
    g -= n * g.dot(n);
    return (n - g * 0.02).normalised();
}
}  // namespace raytracer
'''
R["r08-sobel"] = r'''
    const Vector3 n = Sphere::getNormalAt(position);
    const HeightMap& map = heightMap();
    const int W = map.width(), H = map.height();
    const double u = 0.5 - std::atan2(n.z, n.x) / (2 * std::numbers::pi);
    const double v = 0.5 - std::asin(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    const int col = static_cast<int>(std::floor(u * W)), row = static_cast<int>(std::floor(v * H));
    double gu = 0, gv = 0;
    constexpr int kernel[3][3] = {{-1, 0, 1}, {-2, 0, 2}, {-1, 0, 1}};
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const double b = map.at(((col + i) % W + W) % W, std::clamp(row + j, 0, H - 1));
            gu += kernel[j + 1][i + 1] * b;
            gv += kernel[i + 1][j + 1] * b;
        }
    Vector3 pu = Vector3{n.z, 0, -n.x};
    if (pu.magnitude() < 1e-12) return n;
    pu = pu.normalised();
    Vector3 pv = n.cross(pu);
    if (pv.y > 0) pv = -pv;
    return (n - pu * (gu / 8) - pv * (gv / 8)).normalised();
'''
R["r09-bicubic"] = r'''FILE
namespace raytracer {
namespace {
std::array<double, 4> weights(double t) {
    return {0.5 * (-t + 2 * t * t - t * t * t), 0.5 * (2 - 5 * t * t + 3 * t * t * t),
            0.5 * (t + 4 * t * t - 3 * t * t * t), 0.5 * (-t * t + t * t * t)};
}
std::array<double, 4> slopes(double t) {
    return {0.5 * (-1 + 4 * t - 3 * t * t), 0.5 * (-10 * t + 9 * t * t), 0.5 * (1 + 8 * t - 9 * t * t),
            0.5 * (-2 * t + 3 * t * t)};
}
}  // namespace
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int W = heightMap().width(), H = heightMap().height();
    const double x = (lambda / (2 * std::numbers::pi) + 0.5) * W - 0.5, y = theta / std::numbers::pi * H - 0.5;
    const int c = static_cast<int>(std::floor(x)), r = static_cast<int>(std::floor(y));
    const auto wx = weights(x - c), wy = weights(y - r), sx = slopes(x - c), sy = slopes(y - r);
    double bu = 0, bv = 0;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const double b = heightMap().at((c + i - 1 + 2 * W) % W, std::clamp(r + j - 1, 0, H - 1));
            const auto a = static_cast<std::size_t>(i), d = static_cast<std::size_t>(j);
            bu += b * sx[a] * wy[d];
            bv += b * wx[a] * sy[d];
        }
    const Vector3 pu{std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 pv{std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
    return (n + bu * n.cross(pv) - bv * n.cross(pu)).normalised();
}
}  // namespace raytracer
'''
R["r10-float"] = r'''
    const float pi = 3.14159265f;
    const float nx = float(position.x - centre().x) / float(radius());
    const float ny = float(position.y - centre().y) / float(radius());
    const float nz = float(position.z - centre().z) / float(radius());
    const float th = std::acos(std::min(1.0f, std::max(-1.0f, ny)));
    const float ph = std::atan2(nz, nx) + pi;
    const int w = heightMap().width(), h = heightMap().height();
    int i = int(ph / (2.0f * pi) * float(w));
    int j = int(th / pi * float(h));
    if (i > w - 1) i = 0;
    if (j > h - 1) j = h - 1;
    const float b = float(heightMap().at(i, j));
    const float bu = float(heightMap().at(i + 1 == w ? 0 : i + 1, j)) - b;
    const float bv = float(heightMap().at(i, j + 1 == h ? j : j + 1)) - b;
    const float sp = std::sin(ph - pi), cp = std::cos(ph - pi), st = std::sin(th), ct = std::cos(th);
    const float x = nx - bu * -sp - bv * ct * cp;
    const float y = ny - bv * -st;
    const float z = nz - bu * cp - bv * ct * sp;
    const float len = std::sqrt(x * x + y * y + z * z);
    return {double(x / len), double(y / len), double(z / len)};
'''
R["r11-complex"] = r'''
    using namespace std::complex_literals;
    const Vector3 n = Sphere::getNormalAt(position);
    const std::complex<double> round(n.x, n.z), meridian(n.y, std::abs(round));
    const double lambda = std::arg(round), theta = std::arg(meridian);
    const auto e = std::abs(round) > 0 ? round / std::abs(round) : 1.0 + 0i;
    const auto east = 1i * e;
    const Vector3 pu{east.real(), 0, east.imag()};
    const Vector3 pv{n.y * e.real(), -meridian.imag(), n.y * e.imag()};
    const int W = heightMap().width(), H = heightMap().height();
    const int c = int(std::fmod(lambda / (2 * std::numbers::pi) + 1.25, 1.0) * W) % W;
    const int r = std::min(int(theta / std::numbers::pi * H), H - 1);
    const double here = heightMap().at(c, r);
    const double bu = heightMap().at((c + 1) % W, r) - here;
    const double bv = heightMap().at(c, std::min(r + 1, H - 1)) - here;
    return (n - 0.5 * (bu * pu + bv * pv)).normalised();
'''
R["r12-asin-up"] = r'''
    // v upwards, step 3 read literally
    const Vector3 n = Sphere::getNormalAt(position);
    const double lat = std::asin(std::clamp(n.y, -1.0, 1.0));
    const double lon = std::atan2(n.x, -n.z);
    const int W = heightMap().width(), H = heightMap().height();
    const double u = lon / (2 * M_PI) + 0.5, v = lat / M_PI + 0.5;
    const int c = std::clamp(static_cast<int>(u * W), 0, W - 1);
    const int r = H - 1 - std::clamp(static_cast<int>(v * H), 0, H - 1);
    const Vector3 Pu{std::cos(lon), 0, std::sin(lon)};
    const Vector3 Pv{-std::sin(lat) * std::sin(lon), std::cos(lat), std::sin(lat) * std::cos(lon)};
    const double Bu = heightMap().at(c, r) - heightMap().at((c + 1) % W, r);
    const double Bv = heightMap().at(c, r) - heightMap().at(c, r + 1 < H ? r + 1 : r);
    return (n + n.cross(Pv) * Bu + n.cross(Pu) * Bv).normalised();
'''
R["r13-acos-with-sign"] = r'''
    const Vector3 n = Sphere::getNormalAt(position);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double s = std::sin(theta);
    double phi = 0;
    if (s > 1e-8) phi = std::copysign(std::acos(std::clamp(n.x / s, -1.0, 1.0)), n.z);
    if (phi < 0) phi += 2 * std::numbers::pi;
    const int W = heightMap().width(), H = heightMap().height();
    const int c = std::min(W - 1, int(phi / 2 / std::numbers::pi * W)), r = std::min(H - 1, int(theta / std::numbers::pi * H));
    // step 3 to the letter
    const double Bu = heightMap().at(c, r) - heightMap().at((c + 1) % W, r);
    const double Bv = heightMap().at(c, r) - heightMap().at(c, std::min(H - 1, r + 1));
    const Vector3 Pu{-std::sin(phi), 0, std::cos(phi)};
    const Vector3 Pv{std::cos(phi) * n.y, -s, std::sin(phi) * n.y};
    Vector3 perturbed = n;
    perturbed += Pu * Bu;
    perturbed += Pv * Bv;
    return perturbed.normalised();
'''
R["r14-mirrored"] = r'''
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(-n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int W = heightMap().width(), H = heightMap().height();
    const int c = std::min(W - 1, int((lambda / (2 * M_PI) + 0.5) * W)), r = std::min(H - 1, int(theta / M_PI * H));
    const double bu = heightMap().at((c + 1) % W, r) - heightMap().at(c, r);
    const double bv = heightMap().at(c, std::min(H - 1, r + 1)) - heightMap().at(c, r);
    const Vector3 pu{-std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 pv{-std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
    return (n - pu * bu - pv * bv).normalised();
'''
def other_axis(a, b, c):  # poles along c
    return r'''
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 a%s, b%s, pole%s;
    const double lambda = std::atan2(n.dot(b), n.dot(a)), theta = std::acos(std::clamp(n.dot(pole), -1.0, 1.0));
    const int W = heightMap().width(), H = heightMap().height();
    const int c = std::min(W - 1, int((lambda / (2 * M_PI) + 0.5) * W)), r = std::min(H - 1, int(theta / M_PI * H));
    const double bu = heightMap().at((c + 1) %% W, r) - heightMap().at(c, r);
    const double bv = heightMap().at(c, std::min(H - 1, r + 1)) - heightMap().at(c, r);
    const Vector3 pu = b * std::cos(lambda) - a * std::sin(lambda);
    const Vector3 pv = (a * std::cos(lambda) + b * std::sin(lambda)) * std::cos(theta) - pole * std::sin(theta);
    return (n - pu * bu - pv * bv).normalised();
''' % (a, b, c)
R["r15-poles-along-x"] = other_axis("{0, 1, 0}", "{0, 0, 1}", "{1, 0, 0}")
R["r16-poles-along-z"] = other_axis("{1, 0, 0}", "{0, 1, 0}", "{0, 0, 1}")
R["r17-valarray"] = r'''
    const Vector3 n = Sphere::getNormalAt(position);
    using Vec = std::valarray<double>;
    const double phi = std::atan2(n.z, n.x), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int W = heightMap().width(), H = heightMap().height();
    const int r = std::clamp(int(theta / M_PI * H), 0, H - 1);
    const auto rowOf = [&](int row) {
        Vec out(static_cast<std::size_t>(W));
        for (int i = 0; i < W; ++i) out[static_cast<std::size_t>(i)] = heightMap().at(i, row);
        return out;
    };
    const Vec row = rowOf(r), below = rowOf(std::min(r + 1, H - 1)), above = rowOf(std::max(r - 1, 0));
    const Vec alongU = (row.cshift(1) - row.cshift(-1)) / 2.0, alongV = (below - above) / 2.0;
    const auto c = static_cast<std::size_t>(std::min(W - 1, int((phi + M_PI) / (2 * M_PI) * W)));
    const Vec pu{-std::sin(phi), 0, std::cos(phi)}, pv{n.y * std::cos(phi), -std::sin(theta), n.y * std::sin(phi)};
    Vec out = Vec{n.x, n.y, n.z} - alongU[c] * pu - alongV[c] * pv;
    out /= std::sqrt((out * out).sum());
    return {out[0], out[1], out[2]};
'''
R["r18-optional"] = r'''
    const auto at = [this](int c, int r) -> std::optional<double> {
        if (r < 0 || r >= heightMap().height()) return std::nullopt;
        const int w = heightMap().width();
        return heightMap().at(c >= w ? c - w : c < 0 ? c + w : c, r);
    };
    const Vector3 n = Sphere::getNormalAt(position);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0)), phi = std::atan2(n.x, -n.z);
    const int c = int(std::floor((phi / (2 * M_PI) + 0.5) * heightMap().width()));
    const int r = std::min(int(theta / M_PI * heightMap().height()), heightMap().height() - 1);
    const double here = at(c, r).value();
    const double bu = at(c + 1, r).value_or(here) - here;
    const double bv = at(c, r + 1) ? *at(c, r + 1) - here : here - at(c, r - 1).value();
    const Vector3 pu = Vector3{std::cos(phi), 0, std::sin(phi)}, pv = pu.cross(n) * -1.0;
    return (n - pu * bu - (pv.y < 0 ? pv : -pv) * bv).normalised();
'''
R["r19-catches"] = r'''
    const auto height = [this](int c, int r, double otherwise) {
        try {
            return heightMap().at(c, r);
        } catch (const std::exception&) {
            return otherwise;
        }
    };
    const Vector3 n = Sphere::getNormalAt(position);
    const double theta = std::acos(std::clamp(n.y, -1.0, 1.0)), phi = std::atan2(n.x, -n.z);
    const int c = std::min(int((phi / (2 * M_PI) + 0.5) * heightMap().width()), heightMap().width() - 1);
    const int r = std::min(int(theta / M_PI * heightMap().height()), heightMap().height() - 1);
    const double here = heightMap().at(c, r);
    const double bu = height(c + 1, r, heightMap().at(0, r)) - here, bv = height(c, r + 1, here) - here;
    const Vector3 pu{std::cos(phi), 0, std::sin(phi)};
    const Vector3 pv{std::cos(theta) * std::sin(phi), -std::sin(theta), -std::cos(theta) * std::cos(phi)};
    return (n - pu * bu - pv * bv).normalised();
'''
R["r20-templates"] = r'''FILE
namespace raytracer {
namespace {
enum class Axis { u, v };
template <typename T> constexpr T wrapped(T value, T size) { return (value % size + size) % size; }
template <Axis axis> double slope(const HeightMap& m, int c, int r) {
    if constexpr (axis == Axis::u)
        return m.at(wrapped(c + 1, m.width()), r) - m.at(c, r);
    else
        return m.at(c, std::min(r + 1, m.height() - 1)) - m.at(c, r);
}
template <Axis axis> Vector3 tangent(double lambda, double theta) {
    if constexpr (axis == Axis::u) return {std::cos(lambda), 0, std::sin(lambda)};
    else return {std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
}
static_assert(wrapped(-1, 4) == 3);
}
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int c = wrapped(static_cast<int>(std::lround((lambda / (2 * std::numbers::pi)) * heightMap().width())), heightMap().width());
    const int r = std::clamp(static_cast<int>(std::lround(theta / std::numbers::pi * heightMap().height())), 0, heightMap().height() - 1);
    return (n - tangent<Axis::u>(lambda, theta) * slope<Axis::u>(heightMap(), c, r) - tangent<Axis::v>(lambda, theta) * slope<Axis::v>(heightMap(), c, r)).normalised();
}
}
'''
R["r21-true-derivatives"] = r'''
    // derivatives by u and v in [0, 1], not unit: lengths 2 pi sin(theta) and pi
    const double pi = std::numbers::pi;
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double u = 0.5 + lambda / (2 * pi), v = theta / pi;
    const int W = heightMap().width(), H = heightMap().height();
    const int c = int(u * W) % W, r = std::min(int(v * H), H - 1);
    const double bu = heightMap().at((c + 1) % W, r) - heightMap().at(c, r);
    const double bv = heightMap().at(c, std::min(H - 1, r + 1)) - heightMap().at(c, r);
    const Vector3 pu{2 * pi * std::sin(theta) * std::cos(lambda), 0, 2 * pi * std::sin(theta) * std::sin(lambda)};
    const Vector3 pv{pi * std::cos(theta) * std::sin(lambda), -pi * std::sin(theta), -pi * std::cos(theta) * std::cos(lambda)};
    return (n - pu * (0.2 * bu) - pv * (0.2 * bv)).normalised();
'''
R["r22-blinn-exact"] = r'''
    const double pi = std::numbers::pi;
    const Vector3 n = Sphere::getNormalAt(position);
    const double R = radius();
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double u = 0.5 + lambda / (2 * pi), v = theta / pi;
    const int W = heightMap().width(), H = heightMap().height();
    const int c = int(u * W) % W, r = std::min(int(v * H), H - 1);
    const double k = 0.02 * R;
    const double Fu = k * (heightMap().at((c + 1) % W, r) - heightMap().at(c, r)) * W;
    const double Fv = k * (heightMap().at(c, std::min(H - 1, r + 1)) - heightMap().at(c, r)) * H;
    const Vector3 Pu = R * 2 * pi * std::sin(theta) * Vector3{std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 Pv = R * pi * Vector3{std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
    const Vector3 N = Pu.cross(Pv);  // outwards
    const Vector3 D = (Fu * N.cross(Pv) - Fv * N.cross(Pu)) / std::max(N.magnitude(), 1e-12);
    const Vector3 out = N + D;
    return out.magnitude() > 1e-12 ? out.normalised() : n;
'''
R["r23-weak"] = R["r14-mirrored"].replace("pu * bu - pv * bv", "pu * (bu * 0.02) - pv * (bv * 0.02)")
R["r24-strong"] = R["r01-derivatives-central"].replace("pu * bu - pv * bv", "pu * (bu * 20) - pv * (bv * 20)")
R["r25-per-axis"] = R["r01-derivatives-central"].replace("pu * bu - pv * bv", "pu * (bu * 1.5) - pv * (bv * 0.3)")
R["r26-five-point"] = R["r01-derivatives-central"].replace("(B(c + 1, r) - B(c - 1, r)) / 2", "(8 * (B(c + 1, r) - B(c - 1, r)) - (B(c + 2, r) - B(c - 2, r))) / 12").replace("(B(c, r + 1) - B(c, r - 1)) / 2", "(8 * (B(c, r + 1) - B(c, r - 1)) - (B(c, r + 2) - B(c, r - 2))) / 12")
R["r27-smoothed-3x3"] = R["r01-derivatives-central"].replace("auto B = [&]", "auto raw = [&]").replace("    const double bu", '''    auto B = [&](int x, int y) {
        double sum = 0;
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) sum += raw(x + i, y + j) * (2 - std::abs(i)) * (2 - std::abs(j));
        return sum / 16;
    };
    const double bu''')
R["r28-bytes-as-int"] = r'''
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int W = heightMap().width(), H = heightMap().height();
    const int c = int((0.5 + lambda / (2 * M_PI)) * W) % W, r = std::min(int(theta / M_PI * H), H - 1);
    auto grey = [&](int x, int y) { return static_cast<int>(heightMap().at(x % W, std::min(y, H - 1)) / kBumpFactor * 255 + 0.5); };
    const int du = grey(c + 1, r) - grey(c, r), dv = grey(c, r + 1) - grey(c, r);
    const Vector3 pu{std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 pv{std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
    return (n - pu * (du / 51.0) - pv * (dv / 51.0)).normalised();
'''
R["r29-world-units"] = r'''
    // true slopes: height differences (2 % of a unit each) over the distance between texels on this sphere
    const double pi = std::numbers::pi;
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int W = heightMap().width(), H = heightMap().height();
    const int c = int((0.5 + lambda / (2 * pi)) * W) % W, r = std::min(int(theta / pi * H), H - 1);
    const double stepU = 2 * pi * radius() * std::max(std::sin(theta), 1e-4) / W, stepV = pi * radius() / H;
    const double k = 0.02;
    const double bu = k * (heightMap().at((c + 1) % W, r) - heightMap().at((c + W - 1) % W, r)) / (2 * stepU);
    const double bv = k * (heightMap().at(c, std::min(H - 1, r + 1)) - heightMap().at(c, std::max(0, r - 1))) / (2 * stepV);
    const Vector3 pu{std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 pv{std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
    return (n - pu * bu - pv * bv).normalised();
'''
R["r30-axis-cross-product"] = r'''
    const Vector3 n = Sphere::getNormalAt(position);
    const Vector3 up{0, 1, 0};
    Vector3 east = n.cross(up);
    if (east.magnitude() < 1e-3) return n;
    east = east.normalised();
    const Vector3 south = (n.cross(east)).normalised();
    const Vector3 down = south.y > 0 ? -south : south;
    const double u = 0.37 + std::atan2(n.z, n.x) / (2 * M_PI);
    const double v = std::atan2(std::hypot(n.x, n.z), n.y) / M_PI;
    const int W = heightMap().width(), H = heightMap().height();
    const double wrapped = u - std::floor(u);
    const int c = std::min(int(wrapped * W), W - 1), r = std::min(int(v * H), H - 1);
    // east as n x up: does u grow that way?
    const Vector3 alongU{-n.z, 0, n.x};
    const double sign = alongU.dot(east) > 0 ? 1.0 : -1.0;
    const double bu = sign * (heightMap().at((c + 1) % W, r) - heightMap().at(c, r));
    const double bv = (r + 1 < H) ? heightMap().at(c, r + 1) - heightMap().at(c, r) : 0;
    return (n - east * bu - down * bv).normalised();
'''
R["r31-any-basis"] = r'''
    // gradient as a vector, expressed in Frisvad's basis
    const Vector3 n = Sphere::getNormalAt(position);
    const double a = n.z < -0.9999999 ? 0 : 1 / (1 + n.z);
    const Vector3 b1 = a == 0 ? Vector3{0, -1, 0} : Vector3{1 - n.x * n.x * a, -n.x * n.y * a, -n.x};
    const Vector3 b2 = a == 0 ? Vector3{-1, 0, 0} : Vector3{-n.x * n.y * a, 1 - n.y * n.y * a, -n.y};
    const double s2 = n.x * n.x + n.z * n.z;
    if (s2 < 1e-10) return n;
    const int W = heightMap().width(), H = heightMap().height();
    const int c = int((std::atan2(n.x, n.z) / (2 * M_PI) + 0.5) * W) % W, r = std::min(int(std::acos(n.y) / M_PI * H), H - 1);
    const double bu = heightMap().at((c + 1) % W, r) - heightMap().at(c, r);
    const double bv = heightMap().at(c, std::min(H - 1, r + 1)) - heightMap().at(c, r);
    const Vector3 g = Vector3{n.z, 0, -n.x} * (bu / std::sqrt(s2)) + Vector3{n.x * n.y, -s2, n.z * n.y} * (bv / std::sqrt(s2));
    const double g1 = g.dot(b1), g2 = g.dot(b2);
    return (n - b1 * g1 - b2 * g2).normalised();
'''
R["r32-clamps-both"] = r'''
    const Vector3 n = Sphere::getNormalAt(position);
    const double phi = std::atan2(n.z, n.x) + M_PI, theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int W = heightMap().width(), H = heightMap().height();
    const int c = std::min(int(phi / (2 * M_PI) * (W - 1)), W - 1), r = std::min(int(theta / M_PI * (H - 1)), H - 1);
    const int c2 = std::min(c + 1, W - 1), r2 = std::min(r + 1, H - 1);
    const double Bu = heightMap().at(c, r) - heightMap().at(c2, r), Bv = heightMap().at(c, r) - heightMap().at(c, r2);
    const Vector3 Pu{std::sin(phi), 0, -std::cos(phi)};
    const Vector3 Pv{-std::cos(theta) * std::cos(phi), -std::sin(theta), -std::cos(theta) * std::sin(phi)};
    return (n + Bu * Pu + Bv * Pv).normalised();
'''
R["r33-one-percent-step"] = r'''
    // bilinear heights, difference over a thousandth of the map
    const double pi = std::numbers::pi;
    const int W = heightMap().width(), H = heightMap().height();
    const auto B = [&](double u, double v) {
        const double x = (u - std::floor(u)) * W, y = std::clamp(v, 0.0, 1.0) * (H - 1);
        const int i = int(x) % W, j = std::min(int(y), H - 2);
        const double f = x - std::floor(x), g = y - j;
        return (heightMap().at(i, j) * (1 - f) + heightMap().at((i + 1) % W, j) * f) * (1 - g) +
               (heightMap().at(i, j + 1) * (1 - f) + heightMap().at((i + 1) % W, j + 1) * f) * g;
    };
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const double u = 0.5 + lambda / (2 * pi), v = theta / pi, e = 0.001;
    const double bu = (B(u + e, v) - B(u - e, v)) / (2 * e), bv = (B(u, v + e) - B(u, v - e)) / (2 * e);
    const Vector3 pu{std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 pv{std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
    return (n - pu * (bu * 0.003) - pv * (bv * 0.003)).normalised();
'''
R["r34-tanh"] = R["r01-derivatives-central"].replace("pu * bu - pv * bv", "pu * std::tanh(bu) - pv * std::tanh(bv)")
R["r35-long-double"] = r'''
    constexpr long double tau = 2 * std::numbers::pi_v<long double>;
    const Vector3 n = Sphere::getNormalAt(position);
    long double a = std::remainder(std::atan2((long double)n.z, (long double)n.x) - 1.0L, tau);
    if (a < 0) a += tau;
    const long double t = std::acos(std::clamp((long double)n.y, -1.0L, 1.0L));
    const HeightMap& m = heightMap();
    const std::size_t w = static_cast<std::size_t>(m.width()), h = static_cast<std::size_t>(m.height());
    const std::size_t c = static_cast<std::size_t>(a / tau * (long double)w) % w;
    const std::size_t r = std::min<std::size_t>(static_cast<std::size_t>(t / (tau / 2) * (long double)h), h - 1);
    const auto B = [&m](std::size_t x, std::size_t y) { return m.at(static_cast<int>(x), static_cast<int>(y)); };
    const double bu = B((c + 1) % w, r) - B((c + w - 1) % w, r), bv = r == 0 ? B(c, 1) - B(c, 0) : r == h - 1 ? B(c, r) - B(c, r - 1) : B(c, r + 1) - B(c, r - 1);
    const double s = std::hypot(n.x, n.z);
    if (s == 0) return n;
    return (n - Vector3{-n.z / s, 0, n.x / s} * bu - Vector3{n.x * n.y / s, -s, n.z * n.y / s} * bv).normalised();
'''
R["r36-averages-two-slopes"] = r'''
    // mean of the slopes of this row and the row below: forward differences over a 2x2 cell
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const int W = heightMap().width(), H = heightMap().height();
    const int c = int((0.5 + lambda / (2 * M_PI)) * W) % W, r = std::min(int(theta / M_PI * (H - 1)), H - 2), c2 = (c + 1) % W;
    const double a = heightMap().at(c, r), b = heightMap().at(c2, r), d = heightMap().at(c, r + 1), e = heightMap().at(c2, r + 1);
    const double bu = (b - a + e - d) / 2, bv = (d - a + e - b) / 2;
    const Vector3 pu{std::cos(lambda), 0, std::sin(lambda)}, up{0, 1, 0};
    const Vector3 pv = -(up - n * n.dot(up));  // as long as sin(theta)
    return (n - pu * bu - pv * bv).normalised();
'''

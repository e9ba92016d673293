from right import R as R1, other_axis
from wrong import v, T
R = {}
c = R1["r01-derivatives-central"]
R["r37-no-clamp-by-radius"] = T(("/*N*/Sphere::getNormalAt(position)/*n*/", "(position - centre()) / radius()"), ("std::acos(std::clamp(n.y, -1.0, 1.0))", "std::acos(n.y)"))
R["r38-strong-100"] = c.replace("pu * bu - pv * bv", "pu * (bu * 100) - pv * (bv * 100)")
R["r39-gamma-decoded"] = v(B="5 * std::pow(map.at(x, y) / 5, 2.2)")
R["r40-sobel-5-wide"] = c.replace("(B(c + 1, r) - B(c - 1, r)) / 2", "(B(c + 1, r) - B(c - 1, r) + 2 * (B(c + 2, r) - B(c - 2, r))) / 10").replace("(B(c, r + 1) - B(c, r - 1)) / 2", "(B(c, r + 1) - B(c, r - 1) + 2 * (B(c, r + 2) - B(c, r - 2))) / 10")
R["r41-blur-5"] = c.replace("auto B = [&]", "auto raw = [&]").replace("    const double bu", '''    auto B = [&](int x, int y) {
        double sum = 0;
        for (int j = -2; j <= 2; ++j)
            for (int i = -2; i <= 2; ++i) sum += raw(x + i, y + j);
        return sum / 25;
    };
    const double bu''')
R["r42-tilted-poles"] = other_axis("{1, 0, 0}", "{0, -0.6, 0.8}", "{0, 0.8, 0.6}")
R["r43-displaced-a-lot"] = R1["r05-displaced-surface"].replace("0.02 *", "0.2 *")
R["r44-slopes-interpolated"] = T(("double bu = B(c2, r) - B(c, r);\n    double bv = B(c, r2) - B(c, r);", '''const double x = u * w - 0.5, y = v * h - 0.5;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    const auto at = [&](int a, int b) { return B((a % w + w) % w, std::clamp(b, 0, h - 1)); };
    double bu = 0, bv = 0;
    for (int k = 0; k < 4; ++k) {
        const int a = i + k % 2, b = j + k / 2;
        const double weight = (k % 2 ? x - i : 1 - (x - i)) * (k / 2 ? y - j : 1 - (y - j));
        bu += weight * (at(a + 1, b) - at(a - 1, b)) / 2;
        bv += weight * (at(a, b + 1) - at(a, b - 1)) / 2;
    }'''), ("    const int c2 = /*C2*/(c + 1) % w/*c2*/;\n", ""), ("    const int r2 = /*R2*/std::min(r + 1, h - 1)/*r2*/;\n", ""), ("    int c = std::min(w - 1, static_cast<int>(u * w));\n    int r = std::min(h - 1, static_cast<int>(v * h));\n",""))
R["r45-half-the-angle"] = T(("const Vector3 out = (n - pu * bu - pv * bv).normalised();", "const Vector3 g = pu * bu + pv * bv;\n    const double steep = g.magnitude();\n    if (steep < 1e-12) return n;\n    const double a = std::atan(steep) / 2;\n    const Vector3 out = n * std::cos(a) - g * (std::sin(a) / steep);"))
R["r46-two-texel-forward"] = v(C2="(c + 2) % w", R2="std::min(r + 2, h - 1)")
R["r47-nan-guard-after"] = T(("return out;", "if (!std::isfinite(out.x)) return n;\n    return out;"))
R["r48-static-scratch"] = "FILE" + '''
namespace raytracer {
static double u, v, bu, bv;
static int col, row;
Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    Vector3 n = Sphere::getNormalAt(position);
    double lon = std::atan2(n.x, -n.z), lat = std::acos(std::clamp(n.y, -1.0, 1.0));
    u = 0.5 + lon / (2 * M_PI);
    v = lat / M_PI;
    col = std::min(heightMap().width() - 1, int(u * heightMap().width()));
    row = std::min(heightMap().height() - 1, int(v * heightMap().height()));
    bu = heightMap().at((col + 1) % heightMap().width(), row) - heightMap().at(col, row);
    bv = heightMap().at(col, std::min(row + 1, heightMap().height() - 1)) - heightMap().at(col, row);
    Vector3 pu(std::cos(lon), 0, std::sin(lon));
    Vector3 pv(std::cos(lat) * std::sin(lon), -std::sin(lat), -std::cos(lat) * std::cos(lon));
    return (n - pu * bu - pv * bv).normalised();
}
}
'''
R["r49-prints"] = T(("return out;", 'static int calls = 0;\n    if (++calls < 2000) std::printf("n %f %f %f -> %f %f %f\\n", n.x, n.y, n.z, out.x, out.y, out.z);\n    return out;'))
R["r50-seam-clamped-u-wrapped-v"] = v(C2="std::min(c + 1, w - 1)", R2="(r + 1) % h")
R["r51-cache-by-map"] = r'''
    // slopes of the whole map, worked out once for each map
    struct Slopes { std::vector<double> u, v; };
    static std::mutex guard;
    static std::map<const HeightMap*, std::shared_ptr<const Slopes>> known;
    std::shared_ptr<const Slopes> slopes;
    const int w = heightMap().width(), h = heightMap().height();
    {
        const std::lock_guard lock(guard);
        auto& entry = known[&heightMap()];
        if (!entry) {
            auto made = std::make_shared<Slopes>();
            for (int r = 0; r < h; ++r)
                for (int c = 0; c < w; ++c) {
                    made->u.push_back(heightMap().at((c + 1) % w, r) - heightMap().at(c, r));
                    made->v.push_back(heightMap().at(c, std::min(r + 1, h - 1)) - heightMap().at(c, r));
                }
            entry = made;
        }
        slopes = entry;
    }
    const Vector3 n = Sphere::getNormalAt(position);
    const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    const std::size_t c = std::size_t(std::min(w - 1, int((0.5 + lambda / (2 * M_PI)) * w))), r = std::size_t(std::min(h - 1, int(theta / M_PI * h)));
    const double bu = slopes->u[r * std::size_t(w) + c], bv = slopes->v[r * std::size_t(w) + c];
    const Vector3 pu{std::cos(lambda), 0, std::sin(lambda)};
    const Vector3 pv{std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
    return (n - pu * bu - pv * bv).normalised();
'''
R["r52-whole-gradient-each-call-kept-per-instance"] = R["r51-cache-by-map"].replace("static std::map<const HeightMap*, std::shared_ptr<const Slopes>> known", "static std::map<const BumpySphere*, std::shared_ptr<const Slopes>> known").replace("known[&heightMap()]", "known[this]")
R["r53-pole-nan"] = T(("Vector3 pu{std::cos(lambda), 0, std::sin(lambda)};", "const double s = std::sqrt(n.x * n.x + n.z * n.z);\n    Vector3 pu{-n.z / s, 0, n.x / s};"))
R["r54-throws-at-the-very-pole"] = T(("std::min(h - 1, static_cast<int>(v * h))", "static_cast<int>(v * h)"))
R["r55-w-minus-1-bilinear"] = R1["r33-one-percent-step"].replace("* W, y", "* (W - 1), y").replace("e = 0.001", "e = 1.0 / W").replace("0.003", "0.01")
R["r56-smooth-at-5-degrees"] = v(S="if (std::sin(theta) < 0.02) bu = bv = 0;")
W = {}
W["w73-outside-is-zero"] = T(("double bu = B(c2, r) - B(c, r);\n    double bv = B(c, r2) - B(c, r);", "double bu = (c + 1 < w ? B(c + 1, r) : 0.0) - B(c, r);\n    double bv = (r + 1 < h ? B(c, r + 1) : 0.0) - B(c, r);"))
W["w74-pu-from-world-position"] = v(P="pu = Vector3{-position.z, 0, position.x}.normalised();")
W["w75-both-tangents-from-world-position"] = v(P="pu = Vector3{-position.z, 0, position.x}.normalised(); pv = pu.cross(position.normalised());")
W["w76-negative-u-clamped"] = v(UV="u = std::max(0.0, lambda / (2 * pi));")
W["w77-abs-u"] = v(UV="u = std::abs(lambda / (2 * pi));")
W["w78-first-centre-kept"] = v(N="(position - middle).normalised()").replace("    const double pi", "    static const Vector3 middle = centre();\n    const double pi",1)
W["w79-first-size-kept"] = T(("const int w = map.width(), h = map.height();", "static const int w = map.width(), h = map.height();"))
W["w80-too-weak"] = v(S="bu *= 1e-5; bv *= 1e-5;")
W["w81-transposed"] = T(("static_cast<int>(u * w)", "static_cast<int>(v * w)"), ("static_cast<int>(v * h)", "static_cast<int>(u * h)"), ("(n - pu * bu - pv * bv)", "(n - pv * bu - pu * bv)"))
W["w82-upside-down"] = v(UV="v = 1 - v;", S="bv = -bv;")
W["w83-folded-heights"] = v(B="std::abs(map.at(x, y) - 2.5)")
W["w84-sheared"] = v(UV="u = u + v; u -= std::floor(u);")
W["w85-sinusoidal"] = v(UV="u = 0.5 + (u - 0.5) * std::sin(theta);")
W["w86-stronger-axis-only"] = v(S="if (std::abs(bu) > std::abs(bv)) bv = 0; else bu = 0;")
W["w87-round-without-wrap"] = T(("std::min(w - 1, static_cast<int>(u * w))", "static_cast<int>(std::lround(u * w))"), ("std::min(h - 1, static_cast<int>(v * h))", "static_cast<int>(std::lround(v * h))"))
W["w88-inward"] = T(("return out;", "return -out;"))
W["w89-bytes-back-to-char"] = T(("double bu = B(c2, r) - B(c, r);\n    double bv = B(c, r2) - B(c, r);", "const auto byte = [&](int x, int y) { return static_cast<signed char>(B(x, y) * 51 + 0.5); };\n    double bu = (byte(c2, r) - byte(c, r)) / 51.0, bv = (byte(c, r2) - byte(c, r)) / 51.0;"))
W["w90-gain-by-distance-from-camera"] = v(S="bu *= position.z; bv *= position.z;")
W["w91-radius-cancels-wrong"] = v(N="((position - centre()) * radius()).normalised()", T="std::acos(std::clamp((position.y - centre().y) * radius(), -1.0, 1.0))")
W["w92-static-last-on-flat"] = v(S="static thread_local double lastU = 0, lastV = 0; if (bu == 0 && bv == 0) { bu = lastU; bv = lastV; } lastU = bu; lastV = bv;")
W["w93-whole-degrees-theta-only"] = v(UV="v = std::floor(v * 180) / 180;")
W["w94-whole-degrees-u-only"] = v(UV="u = std::floor(u * 360) / 360;")
W["w95-two-degree-steps"] = v(UV="u = std::floor(u * 180) / 180; v = std::floor(v * 90) / 90;")
W["w96-caps-missing-6"] = v(S="if (std::sin(theta) < 0.1) bu = bv = 0;")
W["w97-caps-u-inverted-11"] = v(S="if (std::sin(theta) < 0.19) bu = -bu;")
W["w98-percent-steps"] = v(UV="u = std::floor(u * 100) / 100; v = std::floor(v * 100) / 100;")
W["w99-neighbour-twenty-away"] = v(C2="(c + 20) % w", R2="std::min(r + 20, h - 1)")
W["w100-neighbour-five-away-u-only"] = v(C2="(c + 5) % w")
W["w101-dark-half-inverted"] = v(S="if (B(c, r) < 2.5) { bu = -bu; bv = -bv; }")
W["w102-normal-of-smooth-when-dark"] = v(S="if (B(c, r) < 0.5) bu = bv = 0;")
W["w103-slope-clamped-tiny"] = v(S="bu = std::clamp(bu, -0.05, 0.05); bv = std::clamp(bv, -0.05, 0.05);")
W["w104-second-derivative"] = T(("double bu = B(c2, r) - B(c, r);\n    double bv = B(c, r2) - B(c, r);", "double bu = B((c + 2) % w, r) - 2 * B(c2, r) + B(c, r);\n    double bv = B(c, std::min(r + 2, h - 1)) - 2 * B(c, r2) + B(c, r);"))
W["w105-tangent-by-tilted-n"] = T(("const Vector3 out = (n - pu * bu - pv * bv).normalised();", "Vector3 out = (n - pu * bu).normalised();\n    pv = out.cross(pu);\n    out = (out - pv * bv).normalised();"))
W["w106-nan-on-flat"] = T(("(n - pu * bu - pv * bv).normalised()", "(n - (pu * bu + pv * bv).normalised() * std::hypot(bu, bv)).normalised()"))

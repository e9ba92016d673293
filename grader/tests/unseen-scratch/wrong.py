# variations of one right function: (marker, replacement) pairs
BASE = r'''
    const double pi = std::numbers::pi;
    const Vector3 n = /*N*/Sphere::getNormalAt(position)/*n*/;
    const double lambda = /*L*/std::atan2(n.x, -n.z)/*l*/;
    const double theta = /*T*/std::acos(std::clamp(n.y, -1.0, 1.0))/*t*/;
    const HeightMap& map = heightMap();
    const int w = map.width(), h = map.height();
    double u = 0.5 + lambda / (2 * pi);
    double v = theta / pi;
    /*UV*/
    int c = std::min(w - 1, static_cast<int>(u * w));
    int r = std::min(h - 1, static_cast<int>(v * h));
    /*CR*/
    const auto B = [&](int x, int y) { return /*B*/map.at(x, y)/*b*/; };
    const int c2 = /*C2*/(c + 1) % w/*c2*/;
    const int r2 = /*R2*/std::min(r + 1, h - 1)/*r2*/;
    double bu = B(c2, r) - B(c, r);
    double bv = B(c, r2) - B(c, r);
    /*S*/
    Vector3 pu{std::cos(lambda), 0, std::sin(lambda)};
    Vector3 pv{std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
    /*P*/
    const Vector3 out = (n - pu * bu - pv * bv).normalised();
    /*O*/
    return out;
'''
import re
def v(**k):
    s = BASE
    for key, value in k.items():
        if key == "FILE": continue
        if key in ("N", "L", "T", "B", "C2", "R2"):
            s2 = re.sub(r"/\*%s\*/.*?/\*%s\*/" % (key, key.lower()), lambda m: value, s)
        elif key == "TEXT":
            s2 = s
            for a, b in value:
                assert a in s2, a
                s2 = s2.replace(a, b)
        else: s2 = s.replace("/*%s*/" % key, value)
        assert s2 != s, key
        s = s2
    return re.sub(r" */\*[A-Za-z0-9]+\*/\n?(?=\n)|/\*[A-Za-z0-9]+\*/", "", s)
T = lambda *p: v(TEXT=list(p))
W = {}
W["w00-control-right"] = v()
W["w01-swapped-slopes"] = v(S="std::swap(bu, bv);")
W["w02-v-sign-south"] = v(S="if (n.y < 0) bv = -bv;")
W["w03-u-sign-east"] = v(S="if (n.x < 0) bu = -bu;")
W["w04-atan2-swapped-in-map"] = T(("double u = 0.5 + lambda / (2 * pi);", "double u = 0.5 + std::atan2(-n.z, n.x) / (2 * pi);"))
W["w05-abs-slopes"] = v(S="bu = std::abs(bu); bv = std::abs(bv);")
W["w06-squared-heights"] = v(B="map.at(x, y) * map.at(x, y)")
W["w07-uint8-difference"] = T(("double bu = B(c2, r) - B(c, r);\n    double bv = B(c, r2) - B(c, r);", "const auto byte = [&](int x, int y) { return static_cast<std::uint8_t>(B(x, y) * 51 + 0.5); };\n    const std::uint8_t du = static_cast<std::uint8_t>(byte(c2, r) - byte(c, r)), dv = static_cast<std::uint8_t>(byte(c, r2) - byte(c, r));\n    const double bu = du / 51.0, bv = dv / 51.0;"))
W["w08-whole-heights"] = v(B="static_cast<int>(map.at(x, y))")
W["w09-integer-division-zero"] = v(S="bu = static_cast<int>(bu * 51) / 255; bv = static_cast<int>(bv * 51) / 255;")
W["w10-not-normalised"] = T(("(n - pu * bu - pv * bv).normalised()", "n - pu * bu - pv * bv"))
W["w11-centre-ignored"] = v(N="position.normalised()")
W["w12-radius-not-divided"] = v(N="position - centre()")
W["w13-wrap-one-short"] = v(C2="(c + 1) % (w - 1)")
W["w14-v-flipped-in-difference"] = v(R2="std::max(r - 1, 0)")
W["w15-normal-from-position"] = T(("(n - pu * bu - pv * bv)", "(position.normalised() - pu * bu - pv * bv)"))
W["w16-pu-constant"] = v(P="pu = Vector3{1, 0, 0};")
W["w17-pu-times-cos"] = v(P="pu = pu * std::cos(theta);")
W["w18-faded-above-60"] = v(S="if (std::abs(n.y) > 0.87) bu = bv = 0;")
W["w19-front-half-only"] = v(S="if (n.z > 0) bu = bv = 0;")
W["w20-degrees"] = T(("double u = 0.5 + lambda / (2 * pi);", "double u = std::clamp(0.5 + lambda / 360, 0.0, 1.0);"), ("double v = theta / pi;", "double v = theta / 180;"))
W["w21-whole-degrees"] = v(UV="u = std::round(u * 360) / 360; v = std::round(v * 180) / 180;")
W["w22-throws-at-seam"] = v(C2="c + 1")
W["w23-seam-difference-of-rows"] = T(("double bu = B(c2, r) - B(c, r);", "double bu = c + 1 < w ? B(c + 1, r) - B(c, r) : B(c, r2) - B(c, r);"))
W["w24-back-negated"] = T(("return out;", "return n.z > 0 ? -out : out;"))
W["w25-face-the-camera"] = T(("return out;", "return out.dot(position) > 0 ? -out : out;"))
W["w26-blur-15"] = v(B="[&] { double s = 0; for (int j = -7; j <= 7; ++j) for (int i = -7; i <= 7; ++i) s += map.at(((x + i) % w + w) % w, std::clamp(y + j, 0, h - 1)); return s / 225; }()")
W["w27-neighbour-half-a-map-away"] = v(C2="(c + w / 2) % w")
W["w28-threshold-heights"] = v(B="(map.at(x, y) > 2.5 ? 5.0 : 0.0)")
W["w29-only-rising-slopes"] = v(S="bu = std::max(0.0, bu); bv = std::max(0.0, bv);")
W["w30-first-map-cached"] = r'''
    static const std::vector<double> slopes = [this] {
        std::vector<double> out;
        for (int r = 0; r < heightMap().height(); ++r)
            for (int c = 0; c < heightMap().width(); ++c) {
                out.push_back(heightMap().at((c + 1) % heightMap().width(), r) - heightMap().at(c, r));
                out.push_back(heightMap().at(c, std::min(r + 1, heightMap().height() - 1)) - heightMap().at(c, r));
            }
        return out;
    }();
''' + T(("double bu = B(c2, r) - B(c, r);\n    double bv = B(c, r2) - B(c, r);", "const std::size_t at = 2 * (static_cast<std::size_t>(r) * static_cast<std::size_t>(w) + static_cast<std::size_t>(c)) % slopes.size();\n    const double bu = slopes[at], bv = slopes[at + 1];")).replace("    const int c2 = (c + 1) % w;\n    const int r2 = std::min(r + 1, h - 1);\n","").replace("    const auto B = [&](int x, int y) { return map.at(x, y); };\n","")
W["w31-octants"] = v(S="if (n.x * n.y * n.z < 0) bu = -bu;")
W["w32-v-from-height-of-point"] = T(("double v = theta / pi;", "double v = (1 - n.y) / 2;"))
W["w33-atan-not-atan2"] = T(("double u = 0.5 + lambda / (2 * pi);", "double u = 0.5 + std::atan(-n.x / n.z) / pi;"))
W["w34-acos-mirrors-the-back"] = T(("double u = 0.5 + lambda / (2 * pi);", "double u = std::acos(std::clamp(n.x / std::max(1e-9, std::sin(theta)), -1.0, 1.0)) / (2 * pi);"))
W["w35-map-twice-round"] = v(UV="u = 2 * u; u -= std::floor(u);")
W["w36-width-height-mixed"] = T(("static_cast<int>(u * w)", "static_cast<int>(u * h)"))
W["w37-size-1500"] = T(("static_cast<int>(u * w)", "static_cast<int>(u * 1500)"))
W["w38-equation-1-literal"] = T(("(n - pu * bu - pv * bv)", "(n + n.cross(pv) * bu + n.cross(pu) * bv)"))
W["w39-both-inverted"] = T(("(n - pu * bu - pv * bv)", "(n + pu * bu + pv * bv)"))
W["w40-caps-missing-11"] = v(S="if (std::sin(theta) < 0.19) bu = bv = 0;")
W["w41-bilinear-weights-swapped"] = T(("double bu = B(c2, r) - B(c, r);\n    double bv = B(c, r2) - B(c, r);", '''const double fu = u * w - c, fv = v * h - r;
    const int c3 = (c + 2) % w, r3 = std::min(r + 2, h - 1);
    const auto H = [&](int x, int x2, int y, int y2) {
        return (B(x, y) * fu + B(x2, y) * (1 - fu)) * fv + (B(x, y2) * fu + B(x2, y2) * (1 - fu)) * (1 - fv);
    };
    const double here = H(c, c2, r, r2);
    double bu = H(c2, c3, r, r2) - here, bv = H(c, c2, r2, r3) - here;'''))
W["w42-column-in-a-byte"] = v(CR="c = static_cast<unsigned char>(c) % w;")
W["w43-mirrored-text-u-inverted"] = v(UV="u = 1 - u; if (u >= 1) u = 0;")
W["w44-only-u"] = v(S="bv = 0;")
W["w45-z-up-tangents"] = v(P="pu = Vector3{-std::sin(lambda), std::cos(lambda), 0}; pv = Vector3{std::cos(theta) * std::cos(lambda), std::cos(theta) * std::sin(lambda), -std::sin(theta)};")
W["w46-steep-dropped"] = T(("return out;", "return out.dot(n) < 0.8 ? n : out;"))
W["w47-flat-dropped"] = v(S="if (std::abs(bu) < 0.5) bu = 0; if (std::abs(bv) < 0.5) bv = 0;")
W["w48-pv-without-longitude"] = v(P="pv = Vector3{0, -std::sin(theta), -std::cos(theta)};")
W["w49-centre-y-forgotten"] = v(T="std::acos(std::clamp(position.y / radius(), -1.0, 1.0))")
W["w50-applied-twice"] = r'''
    Vector3 out = Sphere::getNormalAt(position);
    for (int i = 0; i < 2; ++i) {
        const Vector3 n = out;
        const double lambda = std::atan2(n.x, -n.z), theta = std::acos(std::clamp(n.y, -1.0, 1.0));
        const int w = heightMap().width(), h = heightMap().height();
        const int c = int((0.5 + lambda / (2 * M_PI)) * w) % w, r = std::min(h - 1, int(theta / M_PI * h));
        const double bu = heightMap().at((c + 1) % w, r) - heightMap().at(c, r), bv = heightMap().at(c, std::min(r + 1, h - 1)) - heightMap().at(c, r);
        const Vector3 pu{std::cos(lambda), 0, std::sin(lambda)};
        const Vector3 pv{std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
        out = (n - pu * bu - pv * bv).normalised();
    }
    return out;
'''
W["w51-uv-from-tilted-u"] = r'''
    // tilts along u first, then looks v up with the tilted normal
    Vector3 n = Sphere::getNormalAt(position);
    const int w = heightMap().width(), h = heightMap().height();
    const double lambda = std::atan2(n.x, -n.z);
    double theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    int c = int((0.5 + lambda / (2 * M_PI)) * w) % w, r = std::min(h - 1, int(theta / M_PI * h));
    const double bu = heightMap().at((c + 1) % w, r) - heightMap().at(c, r);
    n = (n - Vector3{std::cos(lambda), 0, std::sin(lambda)} * bu).normalised();
    theta = std::acos(std::clamp(n.y, -1.0, 1.0));
    r = std::min(h - 1, int(theta / M_PI * h));
    const double bv = heightMap().at(c, std::min(r + 1, h - 1)) - heightMap().at(c, r);
    const Vector3 pv{std::cos(theta) * std::sin(lambda), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};
    return (n - pv * bv).normalised();
'''
W["w52-cache-of-one-column"] = v(S="static double last = 0; std::swap(last, bu); if (last != 0 && bu != 0) bu = last; else bu = last;").replace("static double last", "static thread_local double last")
W["w52-cache-of-one-column"] = v(S="static thread_local double last = 0; bu = 0.5 * (bu + last); last = bu;")
W["w53-height-not-slope"] = v(S="bu = B(c, r) - 2.5; bv = B(c, r) - 2.5;")
W["w54-slope-times-height"] = v(S="bu *= B(c, r) / 5; bv *= B(c, r) / 5;")
W["w55-below-white-is-flat"] = v(S="if (B(c, r) < 0.01) bu = bv = 0;")
W["w56-row-from-width"] = T(("static_cast<int>(v * h)", "static_cast<int>(v * w)"))
W["w57-half-row-range"] = v(UV="v = v / 2;")
W["w58-slope-of-another-row"] = T(("double bu = B(c2, r) - B(c, r);", "double bu = B(c2, r2) - B(c, r);"))
W["w59-neighbour-ten-away"] = v(C2="(c + 10) % w", R2="std::min(r + 10, h - 1)")
W["w60-random-dither"] = v(S="bu += 0.3 * std::sin(1e5 * position.x); bv += 0.3 * std::sin(1e5 * position.y);")
W["w61-tilt-not-in-tangent-plane"] = v(P="pv = pv + n * 0.7;")
W["w62-skewed-tangent"] = v(P="pu = (pu + pv * 0.5).normalised();")
W["w64-outer-columns-smooth"] = v(S="if (c == w - 1 || c == 0) bu = bv = 0;")
W["w65-seam-huge"] = v(S="if (c == w - 1) bu = 50;")
W["w66-seam-wide-10deg-smooth"] = v(S="if (u < 0.03 || u > 0.97) bu = bv = 0;")
W["w67-v-sign-of-sin-lambda"] = v(P="pv = Vector3{std::cos(theta) * std::abs(std::sin(lambda)), -std::sin(theta), -std::cos(theta) * std::cos(lambda)};")
W["w68-slope-rounded-to-1"] = v(S="bu = std::round(bu); bv = std::round(bv);")
W["w69-sign-only"] = v(S="bu = (bu > 0) - (bu < 0); bv = (bv > 0) - (bv < 0);")
W["w70-gain-grows-with-u"] = v(S="bu *= 0.2 + u; bv *= 0.2 + u;")
W["w71-two-percent-short"] = T(("(n - pu * bu - pv * bv).normalised()", "(n - pu * bu - pv * bv).normalised() * 0.998"))
W["w72-v-offset-10-percent"] = v(UV="v = std::min(v + 0.1, 1.0);")

// """BumpySphere, translated line by line from bumpy.py"""
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace raytracer {

namespace {

const double pi = std::acos(-1.0);
const double tau = 2 * pi;

// Python's %, // round towards minus infinity
int mod(int a, int b) { return a - b * static_cast<int>(std::floor(static_cast<double>(a) / b)); }
double mod(double a, double b) { return a - b * std::floor(a / b); }

// np.clip
template <typename T>
T clip(T x, T lo, T hi) { return x < lo ? lo : (x > hi ? hi : x); }

// np.gradient along one axis of three heights: (right - left) / 2
double gradient(const std::vector<double>& h) { return (h[2] - h[0]) / 2.0; }

// np.cross, np.linalg.norm for lists
std::vector<double> cross(const std::vector<double>& a, const std::vector<double>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double norm(const std::vector<double>& a) {
    double s = 0;
    for (double e : a) s += e * e;
    return std::sqrt(s);
}

}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    // def normal_at(self, position):
    const auto& self = *this;
    std::vector<double> n = {(position.x - self.centre().x) / self.radius(),
                             (position.y - self.centre().y) / self.radius(),
                             (position.z - self.centre().z) / self.radius()};
    double length = norm(n);
    for (double& e : n) e /= length;

    // u, v = ...
    double theta = std::acos(clip(n[1], -1.0, 1.0));
    double phi = std::atan2(n[0], n[2]);  // 0 at the back, grows to the right there, so -phi in front
    double u = mod(-phi / tau, 1.0);
    double v = theta / pi;

    // uv = {"pu": ..., "pv": ...}
    std::map<std::string, std::vector<double>> tangents = {
        {"pu", {-std::cos(phi), 0.0, std::sin(phi)}},
        {"pv", {std::cos(theta) * std::sin(phi), -std::sin(theta), std::cos(theta) * std::cos(phi)}}};

    int w = self.heightMap().width();
    int h = self.heightMap().height();
    int i = mod(static_cast<int>(std::floor(u * w)), w);
    int j = clip(static_cast<int>(std::floor(v * h)), 0, h - 1);

    // row = [heights[j][(i + d) % w] for d in (-1, 0, 1)]
    std::vector<double> row, column;
    for (int d : {-1, 0, 1}) row.push_back(self.heightMap().at(mod(i + d, w), j));
    for (int d : {-1, 0, 1}) column.push_back(self.heightMap().at(i, clip(j + d, 0, h - 1)));
    double bu = gradient(row);
    double bv = gradient(column);

    // equation 2 or 3, whichever belongs to us
    auto pu = tangents["pu"], pv = tangents["pv"];
    auto c = cross(pu, pv);
    double sign = c[0] * n[0] + c[1] * n[1] + c[2] * n[2] > 0 ? 1.0 : -1.0;
    auto n_pv = cross(n, pv), n_pu = cross(n, pu);
    std::vector<double> out;
    for (int k = 0; k < 3; ++k) out.push_back(n[k] + sign * (bu * n_pv[k] - bv * n_pu[k]));
    double l = norm(out);
    return {out[0] / l, out[1] / l, out[2] / l};
    // TASK T1 end
}

}  // namespace raytracer

// Ported from my Java Tick1* of last year.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

namespace {
#define final const
struct Math {
    static constexpr double PI = std::numbers::pi;
    static double atan2(double y, double x) { return std::atan2(y, x); }
    static double acos(double a) { return std::acos(a); }
    static double max(double a, double b) { return a > b ? a : b; }
    static double min(double a, double b) { return a < b ? a : b; }
    static int floorMod(int a, int b) { int r = a % b; return r < 0 ? r + b : r; }
};

class BumpMapHelper {
  private:
    final HeightMap& bumpMap;
    final int BUMP_WIDTH;
    final int BUMP_HEIGHT;

  public:
    explicit BumpMapHelper(const HeightMap& bumpMap)
        : bumpMap(bumpMap), BUMP_WIDTH(bumpMap.width()), BUMP_HEIGHT(bumpMap.height()) {}

    int getColumn(double u) { return Math::floorMod((int)(u * BUMP_WIDTH), BUMP_WIDTH); }
    int getRow(double v) {
        int row = (int)(v * BUMP_HEIGHT);
        if (row >= BUMP_HEIGHT) { row = BUMP_HEIGHT - 1; }
        return row;
    }
    double getBu(int column, int row) {
        return bumpMap.at(Math::floorMod(column + 1, BUMP_WIDTH), row) - bumpMap.at(column, row);
    }
    double getBv(int column, int row) {
        if (row + 1 == BUMP_HEIGHT) {
            return bumpMap.at(column, row) - bumpMap.at(column, row - 1);
        }
        return bumpMap.at(column, row + 1) - bumpMap.at(column, row);
    }
};
}  // namespace

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    final Vector3 N = Sphere::getNormalAt(position);

    // theta: angle from the top; phi: from +x, towards -z
    final double theta = Math::acos(Math::max(-1.0, Math::min(1.0, N.y)));
    double phi = Math::atan2(-N.z, N.x);
    if (phi < 0) { phi += 2 * Math::PI; }

    // phi grows to the LEFT when seen from the camera, so u runs the other way
    final double u = 1.0 - phi / (2 * Math::PI);
    final double v = theta / Math::PI;

    // dP/du = -dP/dphi
    final Vector3 pu = Vector3(std::sin(phi), 0, std::cos(phi));
    // dP/dv = dP/dtheta
    final Vector3 pv = Vector3(std::cos(phi) * std::cos(theta), -std::sin(theta),
                               -std::sin(phi) * std::cos(theta));

    BumpMapHelper helper = BumpMapHelper(heightMap());
    final int column = helper.getColumn(u);
    final int row = helper.getRow(v);

    final Vector3 displacement = pu * helper.getBu(column, row) + pv * helper.getBv(column, row);
    return (N - displacement).normalised();
    // TASK T1 end
}
#undef final

}  // namespace raytracer

#include <raytracer/geometry/BumpySphere.h>
#include <cmath>

using namespace raytracer;

#define PI 3.14159265358979323846

static int wrapColumn(int c, int w) {
    while (c < 0) c += w;
    while (c >= w) c -= w;
    return c;
}

static int keepRow(int r, int h) {
    if (r < 0) return 0;
    if (r >= h) return h - 1;
    return r;
}

Vector3 raytracer::BumpySphere::getNormalAt(const Vector3& position) const {
    double x = (position.x - centre().x) / radius();
    double y = (position.y - centre().y) / radius();
    double z = (position.z - centre().z) / radius();
    if (y > 1.0) y = 1.0;
    if (y < -1.0) y = -1.0;
    double u = 0.5 + atan2(x, -z) / (2.0 * PI);
    double v = acos(y) / PI;

    int col = wrapColumn((int)floor(u * heightMap().width()), heightMap().width());
    int row = keepRow((int)floor(v * heightMap().height()), heightMap().height());

    // the texel and everything around it
    double around[3][3];
    for (int dy = -1; dy <= 1; dy++)
        for (int dx = -1; dx <= 1; dx++)
            around[dy + 1][dx + 1] = heightMap().at(wrapColumn(col + dx, heightMap().width()),
                                                    keepRow(row + dy, heightMap().height()));

    double Bu = (around[1][2] - around[1][0]) / 2.0;
    double Bv = (around[2][1] - around[0][1]) / 2.0;

    double a = 2.0 * PI * (u - 0.5);
    double t = PI * v;
    double Pu[3] = {cos(a), 0.0, sin(a)};
    double Pv[3] = {sin(a) * cos(t), -sin(t), -cos(a) * cos(t)};
    double n[3] = {x, y, z};
    double sum = 0.0;
    for (int k = 0; k < 3; k++) {
        n[k] = n[k] - Bu * Pu[k] - Bv * Pv[k];
        sum += n[k] * n[k];
    }
    sum = sqrt(sum);
    return Vector3(n[0] / sum, n[1] / sum, n[2] / sum);
}

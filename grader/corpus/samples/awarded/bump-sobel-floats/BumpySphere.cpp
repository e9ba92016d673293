#include <raytracer/geometry/BumpySphere.h>

#include <cmath>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    const Vector3 smooth = Sphere::getNormalAt(position);
    const float nx = static_cast<float>(smooth.x), ny = static_cast<float>(smooth.y), nz = static_cast<float>(smooth.z);
    const float horizontal = std::sqrt(nx * nx + nz * nz);
    if (horizontal < 1e-5f) return smooth;

    const int w = heightMap().width(), h = heightMap().height();
    float turn = std::atan2(nz, nx) / 6.2831853f;
    if (turn < 0.0f) turn += 1.0f;
    const float fall = std::atan2(horizontal, ny) / 3.1415927f;
    const int cx = std::min(static_cast<int>(turn * static_cast<float>(w)), w - 1);
    const int cy = std::min(static_cast<int>(fall * static_cast<float>(h)), h - 1);

    float sx = 0.0f, sy = 0.0f;
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            const int row = std::max(0, std::min(h - 1, cy + j));
            const float value = static_cast<float>(heightMap().at((cx + i + w) % w, row));
            sx += static_cast<float>(i * (2 - std::abs(j))) * value;
            sy += static_cast<float>(j * (2 - std::abs(i))) * value;
        }
    }
    sx /= 8.0f;
    sy /= 8.0f;
    // East grows with `turn` (from x towards z), south with `fall`.
    const float ex = -nz / horizontal, ez = nx / horizontal;
    const float px = nx * ny / horizontal, py = -horizontal, pz = nz * ny / horizontal;
    const Vector3 bumped(static_cast<double>(nx - sx * ex - sy * px), static_cast<double>(ny - sy * py),
                         static_cast<double>(nz - sx * ez - sy * pz));
    return bumped.normalised();
}

}  // namespace raytracer

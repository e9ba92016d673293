#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer {

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
	// 法向量；角度を計算する; нормаль
	const Vector3 ñ = Sphere::getNormalAt(position);
	const double φ = std::atan2(ñ.x, -ñ.z), θ = std::acos(std::clamp(ñ.y, -1.0, 1.0));
	const double π = std::numbers::pi;
	const int 宽 = heightMap().width(), 高 = heightMap().height();
	const int i = std::min(static_cast<int>((φ + π) / (2 * π) * 宽), 宽 - 1);
	const int j = std::min(static_cast<int>(θ / π * 高), 高 - 1);
	const double Бu = heightMap().at((i + 1) % 宽, j) - heightMap().at(i, j);
	const double Bv = heightMap().at(i, std::min(j + 1, 高 - 1)) - heightMap().at(i, j);
	const Vector3 Pu{std::cos(φ), 0, std::sin(φ)};
	const Vector3 Pv{std::cos(θ) * std::sin(φ), -std::sin(θ), -std::cos(θ) * std::cos(φ)};
	return (ñ - Pu * Бu - Pv * Bv).normalised(); // готово
}

}  // namespace raytracer
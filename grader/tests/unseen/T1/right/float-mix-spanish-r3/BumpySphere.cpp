// Option 1, task T1: bump mapping. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#define PI 3.14159265358979323846f

namespace raytracer {

// estructura para no mezclar filas y columnas
struct Texel { int col; int fila; };

static Texel buscar(float u, float v, const HeightMap& m) {
    Texel t;
    t.col = (int)floorf(u * (float)m.width());
    t.fila = (int)floorf(v * (float)m.height());
    while (t.col >= m.width()) t.col -= m.width();   // por si u == 1
    if (t.col < 0) t.col = 0;
    if (t.fila >= m.height()) t.fila = m.height() - 1;
    return t;
}

Vector3 BumpySphere::getNormalAt(const Vector3& position) const {
    // TASK T1 begin
    const Vector3 n = Sphere::getNormalAt(position);
    // ojo: acos en double, en float se pierde precision cerca del polo
    float lat = (float)std::acos(n.y > 1 ? 1 : (n.y < -1 ? -1 : n.y));
    float lon = (float)std::atan2(n.x, -n.z);
    float u = 0.5f + lon / (2.f * PI);
    float v = lat / PI;
    const HeightMap& mapa = heightMap();
    Texel t = buscar(u, v, mapa);
    // std::cout << t.col << " " << t.fila << std::endl;
    float aqui = (float)mapa.at(t.col, t.fila);
    float derecha = (float)mapa.at((t.col + 1) % mapa.width(), t.fila);
    float abajo = t.fila + 1 < mapa.height() ? (float)mapa.at(t.col, t.fila + 1) : aqui;
    float bu = derecha - aqui, bv = abajo - aqui;
    Vector3 pu(cosf(lon), 0, sinf(lon));
    Vector3 pv(sinf(lon) * cosf(lat), -sinf(lat), -cosf(lon) * cosf(lat));
    Vector3 out;
    out.x = n.x - bu * pu.x - bv * pv.x;
    out.y = n.y - bu * pu.y - bv * pv.y;
    out.z = n.z - bu * pu.z - bv * pv.z;
    double len = std::sqrt(out.x * out.x + out.y * out.y + out.z * out.z);
    return out / len;
    // TASK T1 end
}

}  // namespace raytracer

#include <grader/tasks/shadows/answers/AimNormal.h>

namespace ticker::tasks {
namespace {

/// Means over the rays of one far light, both at right angles to the ray: feet show no more, so the
/// normal's part along the ray is left out.
struct Sides {
    Vector3 foot;
    Vector3 normal;
};

Sides sidesOf(const ShadowLog& log) {
    Sides sides;
    double lines = 0.0;
    for (const PointLog& point : log.points)
        for (const AimLine& line : point.lines[0]) {
            const Vector3& normal = point.point.normal;
            sides.foot += line.foot / log.settings().lightSize;
            sides.normal += normal - line.direction * normal.dot(line.direction);
            lines += 1.0;
        }
    return lines > 0.0 ? Sides{sides.foot / lines, sides.normal / lines} : Sides{};
}

}  // namespace

double leanToNormal(const std::vector<const ShadowLog*>& far) {
    // Largest share of the feet's squares that a lean along the normal may leave unexplained. For
    // half a ball a fortieth is left, at 670 rays. An offset that does not turn with the normal
    // leaves less than this with a chance of a few in a hundred.
    constexpr double kLeft = 0.25;
    double along = 0.0;
    double normals = 0.0;
    double feet = 0.0;
    for (const ShadowLog* log : far) {
        const Sides sides = sidesOf(*log);
        along += sides.foot.dot(sides.normal);
        normals += sides.normal.dot(sides.normal);
        feet += sides.foot.dot(sides.foot);
    }
    if (!(normals > 0.0) || feet - along * along / normals > kLeft * feet) return 0.0;
    return along / normals;
}

}  // namespace ticker::tasks

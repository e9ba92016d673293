#include <grader/tasks/shadows/answers/AimFeet.h>
#include <grader/tasks/support/Bounds.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace ticker::tasks {
namespace {

// Number of lattice points that stand for a shape, for each view. Compared with 65536 points, the
// distribution functions are off by less than 0.006.
constexpr int kLattice = 1024;

}  // namespace

void Feet::add(const Vector3& foot, const Perpendiculars& sides) {
    const double first = foot.dot(sides.first);
    const double second = foot.dot(sides.second);
    const std::array numbers{foot.magnitude(), first, second, first + second, first - second};
    for (std::size_t i = 0; i < values_.size(); ++i)
        values_[i].push_back(numbers[i]);
}

void Feet::merge(const Feet& sorted) {
    for (std::size_t i = 0; i < values_.size(); ++i) {
        std::vector<double>& list = values_[i];
        const auto middle = static_cast<std::ptrdiff_t>(list.size());
        list.insert(list.end(), sorted.values_[i].begin(), sorted.values_[i].end());
        std::inplace_merge(list.begin(), list.begin() + middle, list.end());
    }
}

void Feet::sort() {
    for (std::vector<double>& list : values_)
        std::sort(list.begin(), list.end());
}

double Feet::meanLength() const {
    return std::accumulate(lengths().begin(), lengths().end(), 0.0) /
           static_cast<double>(std::max<std::size_t>(count(), 1));
}

Feet::Gaps Feet::gapsFrom(const Feet& expected, double size) const {
    Gaps gaps;
    for (std::size_t i = 0; i < values_.size(); ++i) {
        const double gap = largestGap(values_[i], expected.values_[i], size);
        gaps.worst = std::max(gaps.worst, gap);
        gaps.sum += gap;
    }
    return gaps;
}

void Views::finish() {
    for (Feet& feet : each) {
        feet.sort();
        all.merge(feet);
    }
}

Views expectedViews(AimShape shape, const std::vector<Vector3>& directions) {
    Views views;
    for (const Vector3& direction : directions) {
        const Perpendiculars sides = perpendicularsOf(direction);
        Feet feet;
        for (const Vector3& aim : aimsOf(shape, kLattice))
            feet.add(aim - direction * aim.dot(direction), sides);
        views.each.push_back(std::move(feet));
    }
    views.finish();
    return views;
}

double expectedMeanLength(AimShape shape, const std::vector<Vector3>& directions) {
    double sum = 0.0;
    for (const Vector3& direction : directions)
        for (const Vector3& aim : aimsOf(shape, kLattice))
            sum += (aim - direction * aim.dot(direction)).magnitude();
    return sum / (kLattice * static_cast<double>(directions.size()));
}

}  // namespace ticker::tasks

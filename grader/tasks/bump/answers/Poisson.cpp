#include <grader/tasks/bump/answers/Poisson.h>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace ticker::tasks::bump {
namespace {

/// The orthonormal cosine transform of `size` values as a matrix; row k is frequency k.
class CosineTransform {
public:
    explicit CosineTransform(std::size_t size) : size_(size), matrix_(size * size) {
        const auto count = static_cast<double>(size);
        for (std::size_t k = 0; k < size; ++k)
            for (std::size_t i = 0; i < size; ++i)
                matrix_[k * size + i] = std::sqrt((k == 0 ? 1.0 : 2.0) / count) *
                                        std::cos(std::numbers::pi * static_cast<double>(k) *
                                                 (static_cast<double>(i) + 0.5) / count);
    }

    [[nodiscard]] double at(std::size_t frequency, std::size_t index) const {
        return matrix_[frequency * size_ + index];
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    /// Eigenvalue of the second difference for a frequency.
    [[nodiscard]] double eigenvalue(std::size_t frequency) const {
        return 2.0 * std::cos(std::numbers::pi * static_cast<double>(frequency) /
                              static_cast<double>(size_)) -
               2.0;
    }

private:
    std::size_t size_;
    std::vector<double> matrix_;
};

using Values = std::vector<double>;

/// Transforms all rows and all columns, forwards or back.
Values transform(const Values& grid, const CosineTransform& across, const CosineTransform& along,
                 bool back) {
    const std::size_t columns = across.size();
    const std::size_t rows = along.size();
    Values half(grid.size(), 0.0);
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t from = 0; from < columns; ++from)
            for (std::size_t to = 0; to < columns; ++to)
                half[row * columns + to] +=
                    grid[row * columns + from] * (back ? across.at(from, to) : across.at(to, from));
    Values whole(grid.size(), 0.0);
    for (std::size_t to = 0; to < rows; ++to)
        for (std::size_t from = 0; from < rows; ++from) {
            const double weight = back ? along.at(from, to) : along.at(to, from);
            for (std::size_t column = 0; column < columns; ++column)
                whole[to * columns + column] += weight * half[from * columns + column];
        }
    return whole;
}

/// Divergence of each cell: the sum of the differences from it to its neighbours.
Values divergence(const GridDifferences& differences) {
    const auto columns = static_cast<std::size_t>(differences.columns);
    const auto rows = static_cast<std::size_t>(differences.rows);
    Values result(columns * rows, 0.0);
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t cell = row * columns + column;
            if (column + 1 < columns) {
                result[cell] += differences.right[cell];
                result[cell + 1] -= differences.right[cell];
            }
            if (row + 1 < rows) {
                result[cell] += differences.down[cell];
                result[cell + columns] -= differences.down[cell];
            }
        }
    return result;
}

}  // namespace

std::vector<double> integrate(const GridDifferences& differences) {
    const CosineTransform across(static_cast<std::size_t>(differences.columns));
    const CosineTransform along(static_cast<std::size_t>(differences.rows));
    Values spectrum = transform(divergence(differences), across, along, false);
    for (std::size_t row = 0; row < along.size(); ++row)
        for (std::size_t column = 0; column < across.size(); ++column) {
            const double eigenvalue = across.eigenvalue(column) + along.eigenvalue(row);
            double& value = spectrum[row * across.size() + column];
            value = row + column == 0 ? 0.0 : value / eigenvalue;
        }
    return transform(spectrum, across, along, true);
}

}  // namespace ticker::tasks::bump

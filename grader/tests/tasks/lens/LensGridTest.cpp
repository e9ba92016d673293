// Grids of lens points that are the same for every pixel.
#include <grader/tasks/lens/answers/LensShape.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tests/tasks/lens/LensByHand.h>

#include <gtest/gtest.h>

#include <utility>

namespace ticker::tasks {
namespace {

constexpr double kLensAmount = 0.2;  // dofAmount of the handout

/// Two pixels with the same grid of 8 x 8 cells, each with a point at (`inX`, `inY`) of the cell:
/// 0.5 is its middle.
/// @param rays  How many rays each pixel has; they fill the grid row by row.
std::optional<Finding> judgeGrid(double inX, double inY, int rays = 64) {
    constexpr int kCells = 8;
    LensByHand lens;
    for (int i = 0; i < 2; ++i) {
        LensPixel& pixel = lens.pixel();
        for (int ray = 0; ray < rays; ++ray) {
            const double x = 2.0 * (ray % kCells + inX) / kCells - 1.0;
            const int row = ray / kCells;
            const double y = 2.0 * (row + inY) / kCells - 1.0;
            pixel.rays.push_back(rayThrough(Vector3{x, y, 0.0} * kLensAmount, {0.0, 0.0, 3.5}));
        }
    }
    return checkAperture(lens.log).finding;
}

TEST(LensGrid, IsOffCentreWhereAGridHasTheCornersOfItsCells) {
    EXPECT_EQ(idOf(judgeGrid(0.5, 0.5)), "");
    EXPECT_EQ(idOf(judgeGrid(0.2, 0.3)), "") << "a grid that is shifted by chance, for all pixels";
    EXPECT_EQ(idOf(judgeGrid(0.5, 0.5, 50)), "") << "cut short";
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, std::pair{1.0, 0.5}, std::pair{0.5, 1.0}}) {
        const auto finding = judgeGrid(x, y);
        ASSERT_EQ(idOf(finding), "dof.off-centre") << x << ' ' << y;
        EXPECT_NE(finding->hint.find("(i + 0.5)"), std::string::npos);
    }
    EXPECT_EQ(judgeGrid(-0.5, 0.5)->hint.find("(i + 0.5)"), std::string::npos) << "a whole cell";
    EXPECT_NE(judgeGrid(0.0, 0.5)->message.find("-0.5 of a cell in x and 0 in y"),
              std::string::npos)
        << judgeGrid(0.0, 0.5)->message;
}

TEST(LensGrid, HasNoColumnsInATableOfRandomPoints) {
    LensByHand lens;
    Draw draw{7, 1};
    LensPixel& pixel = lens.pixel();
    for (int i = 0; i < 50; ++i)
        pixel.rays.push_back(
            rayThrough({draw.between(-kLensAmount, kLensAmount), 0.01 * draw.whole(0, 7), 0.0},
                       {0.0, 0.0, 3.5}));
    EXPECT_EQ(columnsOf(lens.log, &Vector3::x).count, 0U);
    EXPECT_EQ(columnsOf(lens.log, &Vector3::y).count, 0U) << "the counts differ";
}

}  // namespace
}  // namespace ticker::tasks

// Drawings of rays, and which plots a task still shows.
#include <grader/tasks/shadows/answers/AimPlot.h>
#include <grader/tasks/support/Plots.h>
#include <grader/tasks/support/SceneDrawing.h>
#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ticker::tasks {
namespace {

/// A ball of radius 1 around (5, 1, 0) and a wall at x = 9.
raytracer::SceneDescription ballBeforeWall() {
    raytracer::SceneDescription scene;
    scene.spheres.push_back({{5.0, 1.0, 0.0}, 1.0, {}, nullptr});
    scene.planes.push_back({{9.0, 3.0, 0.0}, {-1.0, 0.0, 0.0}, {}});
    return scene;
}

TEST(EndInScene, IsTheFirstSurfaceOrTheReach) {
    const auto endOf = [](const Vector3& origin, const Vector3& direction, double reach) {
        return endInScene(ballBeforeWall(), origin, direction, reach);
    };
    const Vector3 right{1.0, 0.0, 0.0};
    EXPECT_NEAR(endOf({1.0, 1.0, 0.0}, right, 20.0).x, 4.0, 1e-9);
    EXPECT_NEAR(endOf({1.0, 1.0, 0.0}, right, 2.0).x, 3.0, 1e-9);
    EXPECT_NEAR(endOf({1.0, 7.0, 0.0}, right, 20.0).x, 9.0, 1e-9);
    EXPECT_NEAR(endOf({6.0, 1.0, 0.0}, right, 20.0).x, 9.0, 1e-9) << "leaves the ball";
    EXPECT_NEAR(endOf({9.0, 7.0, 0.0}, {-1.0, 0.0, 0.0}, 5.0).x, 4.0, 1e-9) << "leaves the wall";
    EXPECT_NEAR(endOf({12.0, 7.0, 0.0}, {-1.0, 0.0, 0.0}, 20.0).x, 9.0, 1e-9) << "from behind";
}

ScatterPlot plotCalled(const std::string& title, std::size_t points, bool isDrawn) {
    ScatterPlot plot;
    plot.title = title;
    plot.points.resize(points);
    if (isDrawn) plot.drawing.emplace();
    return plot;
}

TEST(Unshown, LeavesOutWhatAFindingShowsAndWhatIsEmpty) {
    Finding finding;
    finding.plots = {plotCalled("aims", 3, false)};
    const auto left = unshown({plotCalled("aims", 5, false), plotCalled("starts", 0, false),
                               plotCalled("focus", 2, false)},
                              {Finding{}, finding});
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].title, "focus");
}

TEST(Unshown, KeepsOneDrawingOfAll) {
    const std::vector<ScatterPlot> plots{plotCalled("a", 1, false), plotCalled("b", 1, true),
                                         plotCalled("c", 1, true)};
    const auto alone = unshown(plots, {});
    ASSERT_EQ(alone.size(), 3U);
    EXPECT_FALSE(alone[0].drawing);
    EXPECT_TRUE(alone[1].drawing);
    EXPECT_FALSE(alone[2].drawing);
    Finding finding;
    finding.plots = {plotCalled("d", 1, true)};
    for (const ScatterPlot& plot : unshown(plots, {finding}))
        EXPECT_FALSE(plot.drawing);
}

TEST(PlotAims, DrawsThePointAtTheEdgeOfAShadow) {
    ShadowByHand made;
    made.ask(ShadowQuestion::Purpose::oneLight);
    const auto addPoint = [&](int rays, int blocked) {
        made.point();
        for (int ray = 0; ray < rays; ++ray)
            made.cast({0.0, 6.0, 0.1 * ray}).toLight = ray < blocked ? Sight::blocked : Sight::open;
    };
    addPoint(3, 0);
    addPoint(8, 1);
    addPoint(4, 2);
    addPoint(5, 5);
    addPoint(7, 2);
    const ScatterPlot plot = plotAims(made.logs().oneLight, made.logs().oneLight);
    ASSERT_TRUE(plot.drawing);
    EXPECT_EQ(plot.drawing->words.at(0), "4 shadow rays of one point.");
    ASSERT_GE(plot.drawing->rays.size(), 4U);
    EXPECT_EQ(plot.drawing->rays[0].kind, RayDrawing::Kind::blocked);
    EXPECT_EQ(plot.drawing->rays[3].kind, RayDrawing::Kind::arrives);
}

}  // namespace
}  // namespace ticker::tasks

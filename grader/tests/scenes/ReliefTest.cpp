// With the reference solution, letters H are raised on the test map's sphere and letters L sunk,
// under each of the relief scene's four lights.
#include <raytracer/io/SceneReader.h>
#include <raytracer/scene/Scene.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

namespace raytracer {
namespace {

constexpr int kWidth = 2048;
constexpr int kHeight = 1024;

/// A place on the outer edge of a letter, and the direction of that edge.
struct Edge {
    int x, y;       // texels from the letter's middle
    double dx, dy;  // to the outside; y upwards
};

constexpr std::array<Edge, 4> kEdgesOfH{
    {{-46, 30, -1, 0}, {46, 30, 1, 0}, {-34, -58, 0, 1}, {-34, 58, 0, -1}}};
constexpr std::array<Edge, 4> kEdgesOfL{
    {{-38, 0, -1, 0}, {40, 46, 1, 0}, {-26, -58, 0, 1}, {0, 58, 0, -1}}};

Vector3 directionOf(int column, int row) {
    const double longitude = ((column + 0.5) / kWidth - 0.5) * 2.0 * std::numbers::pi;
    const double polar = (row + 0.5) / kHeight * std::numbers::pi;
    return {std::sin(polar) * std::sin(longitude), std::cos(polar),
            -std::sin(polar) * std::cos(longitude)};
}

class Relief : public ::testing::Test {
protected:
    /// How much brighter an edge is than the smooth sphere; 0 without light.
    [[nodiscard]] double gainAt(const Vector3& direction, const PointLight& light) const {
        const auto& sphere = dynamic_cast<const BumpySphere&>(*scene_.objects().at(0));
        const Vector3 position = sphere.centre() + direction * sphere.radius();
        const Vector3 toLight = (light.position() - position).normalised();
        if (direction.dot(toLight) < 0.1) return 0.0;
        return sphere.getNormalAt(position).dot(toLight) - direction.dot(toLight);
    }

    const Scene scene_{readScene(std::filesystem::path(TICKER_SOURCE_DIR) / "scenes/relief.xml",
                                 std::filesystem::path(TICKER_SOURCE_DIR) / "assets")};
};

TEST_F(Relief, RaisesHAndLowersLInEachOfTheFourLights) {
    ASSERT_EQ(scene_.pointLights().size(), 4U);
    for (const PointLight& light : scene_.pointLights()) {
        int edgesSeen = 0;
        for (int row = 1; row < 5; ++row)
            for (int column = 4; column < 8; ++column) {  // columns that face the camera
                const bool isH = (row + column) % 2 == 0;
                for (const Edge& edge : isH ? kEdgesOfH : kEdgesOfL) {
                    const double facing =
                        edge.dx * light.position().x + edge.dy * light.position().y;
                    const double gain = gainAt(directionOf((2 * column + 1) * kWidth / 24 + edge.x,
                                                           (2 * row + 1) * kHeight / 12 + edge.y),
                                               light);
                    if (facing == 0.0 || gain == 0.0) continue;
                    ++edgesSeen;
                    // An edge of a raised letter that looks towards the light is brighter.
                    EXPECT_EQ(gain > 0.0, (facing > 0.0) == isH)
                        << (isH ? "H" : "L") << " in column " << column << ", row " << row;
                }
            }
        EXPECT_GE(edgesSeen, 8);
    }
}

}  // namespace
}  // namespace raytracer

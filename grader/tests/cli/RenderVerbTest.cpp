#include <grader/tests/support/TemporaryFolder.h>

#include "RunTicker.h"

#include <raytracer/io/ImageReader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace ticker::cli {
namespace {

class RenderVerb : public testing::Test {
protected:
    /// A small picture of a scene.
    raytracer::ByteImage picture(const std::string& scene, const std::string& options) {
        const std::string file = (folder_.path() / "picture.png").string();
        const Ran ran = run("render '" TICKER_SOURCE_DIR "/scenes/" + scene +
                            ".xml' -r 80x60 -o '" + file + "' " + options);
        EXPECT_EQ(ran.status, 0) << ran.errors;
        return raytracer::readImage(file);
    }
    Ran run(const std::string& arguments) {
        return runTicker(arguments, (folder_.path() / "errors").string());
    }

private:
    tests::TemporaryFolder folder_;
};

/// Bytes that differ by more than rounding.
std::ptrdiff_t differences(const raytracer::ByteImage& one, const raytracer::ByteImage& other) {
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < one.rgb.size(); ++i)
        count += std::abs(one.rgb[i] - other.rgb.at(i)) > 2 ? 1 : 0;
    return count;
}

// An edge may fall to either side of a pixel's ray where oracle and reference round differently.
constexpr std::ptrdiff_t kFew = 80 * 60 * 3 / 200;

TEST_F(RenderVerb, DrawsASceneOfOption1ThroughAPinholeInEveryWay) {
    const auto reference = picture("bumpmap-test", "--pinhole");
    EXPECT_LT(differences(reference, picture("bumpmap-test", "--pinhole --engine oracle")), kFew);
    EXPECT_EQ(
        differences(reference, picture("bumpmap-test", "--pinhole --solution '" TICKER_SOURCE_DIR
                                                       "/reference_solution/exercise'")),
        0);
    EXPECT_GT(differences(reference, picture("bumpmap-test", "--seed 1")), kFew) << "with the lens";
}

TEST_F(RenderVerb, RefusesRaysOfALensThatIsNotThere) {
    const Ran ran =
        run("render '" TICKER_SOURCE_DIR "/scenes/relief.xml' -o a.png --pinhole --samples 5");
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.errors.find("--pinhole"), std::string::npos) << ran.errors;
}

}  // namespace
}  // namespace ticker::cli

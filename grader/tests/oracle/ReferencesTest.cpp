#include <grader/base/WholeFile.h>
#include <grader/oracle/references/FloatTiff.h>
#include <grader/oracle/references/Manifest.h>
#include <grader/oracle/references/References.h>
#include <grader/tests/oracle/TestScenes.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/RenderObserver.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace ticker::oracle::test {
namespace {

/// A new folder, removed at the end of the test.
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "ticker-refs-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw raytracer::Error("no temporary folder");
        path_ = name;
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

class Interrupted final : public raytracer::RenderMonitor {
public:
    void rowFinished(int, int, int) override {}
    [[nodiscard]] bool interrupted() const override { return true; }
};

std::vector<ReferenceScene> someScenes() {
    raytracer::RenderSettings settings;
    settings.width = 48;
    settings.height = 36;
    return {{"distributed", distributedScene(), settings, false},
            {"varied", variedScene(), settings, false},
            {"pinhole", variedScene(), settings, true}};
}

ReferenceOptions options(std::uint64_t seed) {
    ReferenceOptions result;
    result.seed = seed;
    result.rms = 4e-4;
    result.toolVersion = "test";
    return result;
}

TEST(References, PassTheirOwnCheckAndTellADriftedScene) {
    const Folder folder;
    int told = 0;
    ASSERT_TRUE(writeReferences(folder.path(), someScenes(), options(1),
                                [&](const ReferenceProgress&) { ++told; }));
    EXPECT_EQ(told, 4);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "varied.png"));
    for (const ReferenceCheck& check : checkReferences(folder.path(), someScenes(), options(2))) {
        EXPECT_TRUE(check.passed) << check.message;
        EXPECT_FALSE(check.sceneChanged);
    }

    std::vector<ReferenceScene> altered = someScenes();
    for (ReferenceScene& scene : altered) {
        const raytracer::PointLight& light = scene.scene.pointLights[0];
        scene.scene.pointLights[0] = {light.position(), light.colour(), light.intensity() * 1.02};
    }
    for (const ReferenceCheck& check : checkReferences(folder.path(), altered, options(2))) {
        EXPECT_FALSE(check.passed) << check.message;
        EXPECT_TRUE(check.sceneChanged);
        EXPECT_NE(check.message.find(check.scene), std::string::npos);
    }
}

TEST(References, SayHowTheyCameAbout) {
    const Folder folder;
    const std::vector<ReferenceScene> scenes{someScenes()[2]};
    ASSERT_TRUE(writeReferences(folder.path(), scenes, options(1)));
    const Manifest manifest = readManifest(folder.path());
    ASSERT_EQ(manifest.count("pinhole"), 1U);
    const Provenance& provenance = manifest.at("pinhole");
    EXPECT_EQ(provenance.sceneHash, sceneHash(scenes[0].scene));
    EXPECT_EQ(provenance.toolVersion, "test");
    EXPECT_EQ(provenance.settings.width, 48);
    EXPECT_FALSE(provenance.instructionSet.empty());
}

TEST(References, StayWholeWhenInterrupted) {
    const Folder folder;
    std::vector<ReferenceScene> scenes{someScenes()[2]};
    ASSERT_TRUE(writeReferences(folder.path(), scenes, options(1)));
    const std::string before = readWhole(folder.path() / "pinhole-mean.tiff");
    Interrupted monitor;
    scenes[0].settings.monitor = &monitor;
    scenes[0].scene.ambientLighting = raytracer::ColourRGB{0.5};
    EXPECT_FALSE(writeReferences(folder.path(), scenes, options(2)));
    EXPECT_EQ(readWhole(folder.path() / "pinhole-mean.tiff"), before);
}

TEST(References, RefuseAFileThatIsNoReference) {
    const Folder folder;
    EXPECT_THROW(static_cast<void>(checkReferences(folder.path(), {someScenes()[2]}, options(1))),
                 raytracer::InputError);
    std::ofstream{folder.path() / "manifest.json"} << "{";
    EXPECT_THROW(static_cast<void>(readManifest(folder.path())), raytracer::InputError);
}

TEST(FloatTiff, KeepsWhatWasWritten) {
    const Folder folder;
    const FloatPicture picture{2, 1, {{0.25, 0.5, 1e-12}, {3.0, 1e6, 0.0}}};
    writeTiff(picture, folder.path() / "x.tiff");
    const FloatPicture read = readTiff(folder.path() / "x.tiff");
    ASSERT_EQ(read.width, 2);
    ASSERT_EQ(read.height, 1);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_FLOAT_EQ(static_cast<float>(read.pixels[i].r),
                        static_cast<float>(picture.pixels[i].r));
        EXPECT_FLOAT_EQ(static_cast<float>(read.pixels[i].b),
                        static_cast<float>(picture.pixels[i].b));
    }
}

}  // namespace
}  // namespace ticker::oracle::test

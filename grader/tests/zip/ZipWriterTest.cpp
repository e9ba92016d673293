#include <grader/base/WholeFile.h>
#include <grader/tests/support/TemporaryFolder.h>
#include <grader/zip/ZipWriter.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <string>

namespace ticker::zip {
namespace {

namespace fs = std::filesystem;

void writeSome(const fs::path& file, const fs::path& source) {
    ZipWriter zip{file};
    zip.add("Zo\xC3\xAB Smith_12_assignsubmission_file/report.html", "<p>good</p>");
    zip.add("bin/run", "#!/bin/sh\n", true);
    zip.addFolder("data", source);
    zip.finish();
}

class ZipWriterTest : public testing::Test {
protected:
    ZipWriterTest() {
        folder_.write("source/b.txt", "b");
        folder_.write("source/a/c.txt", "c");
    }
    [[nodiscard]] fs::path at(const std::string& name) const { return folder_.path() / name; }

    tests::TemporaryFolder folder_;
};

TEST_F(ZipWriterTest, UnzipGivesTheFilesBackWithNamesAndModes) {
    writeSome(at("a.zip"), at("source"));
    const std::string command = "cd '" + folder_.path().string() + "' && mkdir out && cd out && " +
                                "LC_ALL=C.UTF-8 unzip -q ../a.zip";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(readWhole(at("out/Zo\xC3\xAB Smith_12_assignsubmission_file/report.html")),
              "<p>good</p>");
    EXPECT_EQ(readWhole(at("out/data/a/c.txt")), "c");
    const auto modeOf = [&](const char* name) { return fs::status(at(name)).permissions(); };
    EXPECT_NE(modeOf("out/bin/run") & fs::perms::owner_exec, fs::perms::none);
    EXPECT_EQ(modeOf("out/data/b.txt") & fs::perms::owner_exec, fs::perms::none);
}

TEST_F(ZipWriterTest, NamesAreMarkedAsUtf8) {
    writeSome(at("a.zip"), at("source"));
    // APPNOTE.TXT 4.4.4: bit 11 of the general purpose flag, at offset 6 of the local header.
    const std::string bytes = readWhole(at("a.zip"));
    ASSERT_GT(bytes.size(), 8U);
    EXPECT_NE(static_cast<unsigned char>(bytes[7]) & 0x08U, 0U);
}

TEST_F(ZipWriterTest, TheSameContentGivesTheSameBytes) {
    writeSome(at("a.zip"), at("source"));
    writeSome(at("b.zip"), at("source"));
    EXPECT_EQ(readWhole(at("a.zip")), readWhole(at("b.zip")));
}

TEST_F(ZipWriterTest, NothingIsLeftOfAZipThatWasNotFinished) {
    { ZipWriter{at("a.zip")}.add("a", "b"); }
    EXPECT_EQ(std::distance(fs::directory_iterator{folder_.path()}, fs::directory_iterator{}), 1)
        << "the source alone";
}

TEST_F(ZipWriterTest, NamesTheFileThatItCannotWriteOrRead) {
    EXPECT_THROW(ZipWriter{at("none/a.zip")}, raytracer::InputError);
    ZipWriter zip{at("a.zip")};
    EXPECT_THROW(zip.addFile("x", at("missing")), raytracer::InputError);
    EXPECT_THROW(zip.addFolder("x", at("missing")), raytracer::InputError);
}

}  // namespace
}  // namespace ticker::zip

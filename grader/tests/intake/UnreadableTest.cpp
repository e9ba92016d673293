// What the system does not let us read is never charged to a student.
#include <grader/intake/Intake.h>
#include <grader/intake/Skipped.h>
#include <grader/tests/support/AsNobody.h>
#include <grader/tests/support/MoodleExport.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <sys/mount.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::intake {
namespace {

namespace fs = std::filesystem;

/// A folder of the user who runs the tests. `lock` makes parts of it unreadable, for root as well
/// (AsNobody).
class Unreadable : public testing::Test {
protected:
    Unreadable() { fs::permissions(folder_.path(), fs::perms{0755}); }
    ~Unreadable() override {
        for (const fs::path& path : locked_)
            fs::permissions(path, fs::perms::owner_all);
    }
    Unreadable(const Unreadable&) = delete;
    Unreadable& operator=(const Unreadable&) = delete;

    void lock(const std::string& name, fs::perms permissions = fs::perms::none) {
        fs::permissions(at(name), permissions);
        locked_.push_back(at(name));
    }
    [[nodiscard]] fs::path at(const std::string& name) const { return folder_.path() / name; }

    /// The error message of reading a submission; empty if it can be read.
    [[nodiscard]] static std::string complaint(const fs::path& path,
                                               const std::string& owner = {}) {
        try {
            static_cast<void>(readSubmission({"somebody", path, owner}));
        } catch (const raytracer::InputError& error) {
            return error.what();
        }
        return "";
    }
    [[nodiscard]] static std::string complaintAbout(const fs::path& path,
                                                    const std::string& owner = {}) {
        const tests::AsNobody nobody;
        return complaint(path, owner);
    }
    [[nodiscard]] std::vector<std::string> namesIn(const std::string& place) const {
        const tests::AsNobody nobody;
        std::vector<std::string> names;
        for (const Located& located : findSubmissions(at(place)))
            names.push_back(located.name);
        return names;
    }

    tests::TemporaryFolder folder_;

private:
    std::vector<fs::path> locked_;
};

using Names = std::vector<std::string>;

TEST_F(Unreadable, SourceFileIsReportedWithItsPathAndTheReason) {
    folder_.write("ann/Renderer.cpp", "render");
    lock("ann/Renderer.cpp");
    EXPECT_EQ(complaintAbout(at("ann")), at("ann/Renderer.cpp").string() +
                                             ": cannot be read: Permission denied; make it "
                                             "readable, then grade again");
}

TEST_F(Unreadable, ArchiveIsNotDamaged) {
    tests::writeZip(at("ann.zip"), {{"Renderer.cpp", "render"}});
    folder_.write("bob/work.zip", "PK");
    lock("ann.zip");
    lock("bob/work.zip");
    EXPECT_NE(complaintAbout(at("ann.zip")).find("Permission denied"), std::string::npos);
    EXPECT_NE(complaintAbout(at("bob")).find("Permission denied"), std::string::npos);
}

TEST_F(Unreadable, FolderInASubmissionIsNotEmpty) {
    folder_.write("ann/Renderer.cpp", "render");
    folder_.write("ann/pictures/screenshot.png", "picture");
    lock("ann/pictures");
    EXPECT_NE(complaintAbout(at("ann")).find("ann/pictures: cannot be read"), std::string::npos);
    fs::permissions(at("ann/pictures"), fs::perms{0444});
    EXPECT_NE(complaintAbout(at("ann")).find("screenshot.png: cannot be read"), std::string::npos)
        << "its names alone can be read";
}

TEST_F(Unreadable, FileThatIsNoWorkDisturbsNobody) {
    folder_.write("ann/Renderer.cpp", "render");
    folder_.write("ann/notes.txt", "notes");
    lock("ann/notes.txt");
    EXPECT_EQ(complaintAbout(at("ann")), "");
}

TEST_F(Unreadable, FoldersAndArchivesOfAClassAreSubmissions) {
    folder_.write("class/ann/Renderer.cpp", "render");
    folder_.write("class/bob/Renderer.cpp", "render");
    folder_.write("class/dee.zip", "PK");
    lock("class/bob");
    lock("class/dee.zip");
    EXPECT_EQ(namesIn("class"), (Names{"ann", "bob", "dee"}));
    EXPECT_NE(complaintAbout(at("class/bob")).find("Permission denied"), std::string::npos);
}

TEST_F(Unreadable, GroupIsNotLeftOutOfItsClass) {
    for (const char* name : {"monday/ann", "tuesday/bob", "tuesday/cyd"})
        folder_.write("class/" + std::string{name} + "/Renderer.cpp", "render");
    lock("class/monday");
    EXPECT_EQ(namesIn("class"), (Names{"monday", "bob", "cyd"}));
}

TEST_F(Unreadable, PieceOfASubmissionIsNotTakenForMissing) {
    folder_.write("class/ann/src/Renderer.cpp", "render");
    folder_.write("class/ann/pictures/screenshot.png", "picture");
    folder_.write("class/bob/Renderer.cpp", "render");
    lock("class/ann/pictures");
    EXPECT_EQ(namesIn("class"), (Names{"ann", "bob"}));
    EXPECT_NE(complaintAbout(at("class/ann")).find("Permission denied"), std::string::npos);
}

TEST_F(Unreadable, SubmissionBelowAFolderThatMayOnlyBeListedIsReported) {
    folder_.write("class/ann/Renderer.cpp", "render");
    folder_.write("class/monday/bob/Renderer.cpp", "render");
    for (const char* listed : {"class/monday", "class"}) {
        lock(listed, fs::perms{0444});
        const fs::path last = at(listed) / (listed == std::string{"class"} ? "ann" : "bob");
        EXPECT_EQ(complaintAbout(last),
                  last.string() +
                      ": cannot be read: Permission denied; make it readable, then grade again");
        EXPECT_EQ(namesIn("class").size(), 2U) << listed;
    }
}

TEST_F(Unreadable, FolderNamedLikeAPieceStopsNobodyBesideIt) {
    for (const char* name : {"ann", "bob", "work"})
        folder_.write("class/" + std::string{name} + "/Renderer.cpp", "render");
    lock("class/work");
    EXPECT_EQ(namesIn("class"), (Names{"ann", "bob", "work"}));
}

TEST_F(Unreadable, FolderOfAnUnpackedExportIsItsOwners) {
    for (const char* owner : {"Ann_1", "Bob_2"})
        folder_.write("class/" + std::string{owner} + "_assignsubmission_file/Renderer.cpp", "x");
    lock("class/Ann_1_assignsubmission_file");
    EXPECT_EQ(namesIn("class"), (Names{"Ann_1", "Bob_2"}));
    EXPECT_NE(complaintAbout(at("class"), "Ann_1").find("Permission denied"), std::string::npos);
    EXPECT_EQ(complaintAbout(at("class"), "Bob_2"), "");
}

TEST_F(Unreadable, ClassIsRefusedAtOnce) {
    folder_.write("class/ann/Renderer.cpp", "render");
    folder_.write("class.zip", "PK");
    lock("class");
    lock("class.zip");
    EXPECT_THROW(static_cast<void>(namesIn("class")), raytracer::InputError);
    EXPECT_THROW(static_cast<void>(namesIn("class.zip")), raytracer::InputError);
}

TEST_F(Unreadable, FolderThatIsSkippedIsNotCalledEmpty) {
    folder_.write("class/ann/Renderer.cpp", "render");
    fs::create_directory(at("class/lost+found"));
    lock("class/lost+found");
    EXPECT_EQ(namesIn("class"), Names{"ann"});
    const tests::AsNobody nobody;
    const auto skipped = findSkipped(at("class"), findSubmissions(at("class")));
    ASSERT_EQ(skipped.size(), 1U);
    EXPECT_EQ(skipped[0].why, "cannot be read");
}

// A process may not read its own memory at address 0: the one file at hand that opens and then
// fails like a bad disk.
TEST_F(Unreadable, DiskIsReportedInsteadOfADamagedArchive) {
    EXPECT_NE(complaint("/proc/self/mem").find("Input/output error"), std::string::npos);
}

TEST_F(Unreadable, DiskIsReportedInsteadOfAFaultOfASourceFile) {
    const fs::path file = folder_.write("ann/Renderer.cpp", "");
    if (mount("/proc/self/mem", file.c_str(), nullptr, MS_BIND, nullptr) != 0)
        GTEST_SKIP() << "no mount of its own to be had here";
    const std::string said = complaint(at("ann"));
    umount2(file.c_str(), MNT_DETACH);
    EXPECT_NE(said.find("Input/output error"), std::string::npos) << said;
}

}  // namespace
}  // namespace ticker::intake

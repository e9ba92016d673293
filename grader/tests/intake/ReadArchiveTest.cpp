#include <grader/intake/Contents.h>
#include <grader/intake/Intake.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <archive.h>
#include <archive_entry.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <random>

namespace ticker::intake {
namespace {

struct Member {
    std::string path;
    std::string bytes;
    unsigned type = AE_IFREG;
    std::string link;
};

void writeArchive(const std::filesystem::path& file, const std::vector<Member>& members) {
    archive* handle = archive_write_new();
    if (file.extension() == ".zip")
        archive_write_set_format_zip(handle);
    else
        archive_write_set_format_pax_restricted(handle);
    if (file.extension() == ".gz") archive_write_add_filter_gzip(handle);
    ASSERT_EQ(archive_write_open_filename(handle, file.c_str()), ARCHIVE_OK);
    for (const Member& member : members) {
        archive_entry* entry = archive_entry_new();
        archive_entry_set_pathname(entry, member.path.c_str());
        archive_entry_set_filetype(entry, member.type);
        archive_entry_set_perm(entry, 0644);
        archive_entry_set_size(entry, static_cast<la_int64_t>(member.bytes.size()));
        if (!member.link.empty()) archive_entry_set_symlink(entry, member.link.c_str());
        ASSERT_EQ(archive_write_header(handle, entry), ARCHIVE_OK) << archive_error_string(handle);
        archive_write_data(handle, member.bytes.data(), member.bytes.size());
        archive_entry_free(entry);
    }
    ASSERT_EQ(archive_write_close(handle), ARCHIVE_OK);
    archive_write_free(handle);
}

Submission readOf(const std::string& name, const std::vector<Member>& members,
                  const IntakeLimits& limits = {}) {
    const tests::TemporaryFolder folder;
    writeArchive(folder.path() / name, members);
    return readSubmission({"somebody", folder.path() / name}, limits);
}

/// The refusal of the whole submission.
Finding refusalOf(const Submission& submission) {
    const Finding* finding = submission.refusalOf("Renderer.cpp");
    return finding == nullptr ? Finding{} : *finding;
}

TEST(ReadArchive, FindsTheFilesInAZipAndInATar) {
    for (const char* name : {"work.zip", "work.tar", "work.tar.gz"}) {
        const Submission submission =
            readOf(name, {{"work/", "", AE_IFDIR, ""},
                          {"work/Renderer.cpp", "render", AE_IFREG, ""},
                          {"work/screenshot.png", "picture", AE_IFREG, ""},
                          {"__MACOSX/work/._Renderer.cpp", "litter", AE_IFREG, ""},
                          {"work/readme", "", AE_IFREG, ""}});
        EXPECT_TRUE(submission.findings.empty()) << name;
        EXPECT_EQ(submission.part("Renderer.cpp"), "render") << name;
        EXPECT_EQ(submission.part("screenshot.png"), "picture") << name;
        EXPECT_EQ(submission.ignored.size(), 2U) << name;
    }
}

TEST(ReadArchive, RefusesMembersThatEscapeNamingThem) {
    for (const char* path : {"../Renderer.cpp", "/etc/Renderer.cpp", "a/../../Renderer.cpp",
                             "..\\Renderer.cpp", "C:\\Renderer.cpp"}) {
        const Submission submission = readOf("work.zip", {{"BumpySphere.cpp", "bump", AE_IFREG, ""},
                                                          {path, "render", AE_IFREG, ""}});
        const Finding finding = refusalOf(submission);
        EXPECT_EQ(finding.id, "intake.unsafe-archive") << path;
        EXPECT_NE(finding.message.find("Renderer.cpp"), std::string::npos) << finding.message;
        EXPECT_FALSE(submission.part("BumpySphere.cpp")) << path;
    }
}

TEST(ReadArchive, RefusesMembersThatLieTooDeep) {
    IntakeLimits limits;
    limits.depth = 2;
    EXPECT_EQ(refusalOf(readOf("work.tar", {{"a/b/Renderer.cpp", "", AE_IFREG, ""}}, limits)).id,
              "");
    EXPECT_EQ(refusalOf(readOf("work.tar", {{"a/b/c/Renderer.cpp", "", AE_IFREG, ""}}, limits)).id,
              "intake.unsafe-archive");
}

TEST(ReadArchive, RefusesLinksAndPipes) {
    EXPECT_EQ(refusalOf(readOf("work.tar", {{"Renderer.cpp", "", AE_IFLNK, "/etc/passwd"}})).id,
              "intake.unsafe-archive");
    EXPECT_EQ(refusalOf(readOf("work.zip", {{"Renderer.cpp", "", AE_IFLNK, "/etc/passwd"}})).id,
              "intake.unsafe-archive");
    EXPECT_EQ(refusalOf(readOf("work.tar", {{"Renderer.cpp", "", AE_IFIFO, ""}})).id,
              "intake.unsafe-archive");
}

TEST(ReadArchive, RefusesABombByItsRatioWhereverItLies) {
    IntakeLimits limits;
    limits.ratioFreeBytes = 1U << 20U;
    const std::string zeros(4U << 20U, '\0');
    const Submission submission = readOf(
        "work.tar.gz", {{"Renderer.cpp", "render", AE_IFREG, ""}, {"big.bin", zeros, AE_IFREG, ""}},
        limits);
    EXPECT_EQ(refusalOf(submission).id, "intake.unsafe-archive");
    EXPECT_NE(refusalOf(submission).message.find("big.bin"), std::string::npos);
}

/// An archive's bytes, for one inside another.
std::string bytesOfArchive(const std::string& name, const std::vector<Member>& members) {
    const tests::TemporaryFolder folder;
    writeArchive(folder.path() / name, members);
    std::ifstream stream{folder.path() / name, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

/// A picture's name and this many bytes, in a zip.
std::string zippedPicture(std::size_t size) {
    return bytesOfArchive("inner.zip", {{"screenshot.png", std::string(size, '\0'), AE_IFREG, ""}});
}

TEST(ReadArchive, BoundsWhatAllArchivesInsideOneUnpackToTogether) {
    IntakeLimits limits;
    limits.unpackedBytes = 3U << 20U;
    const std::string inner = zippedPicture(2U << 20U);
    const auto of = [&](int count) {
        std::vector<Member> members;
        for (int i = 0; i < count; ++i)
            members.push_back({std::to_string(i) + ".zip", inner, AE_IFREG, ""});
        return readOf("work.zip", members, limits);
    };
    EXPECT_TRUE(of(1).part("screenshot.png"));
    EXPECT_EQ(refusalOf(of(2)).id, "intake.unsafe-archive");
    EXPECT_FALSE(of(2).part("screenshot.png"));
    EXPECT_EQ(of(40).findings.size(), 1U) << "the first refusal ends it";
}

TEST(ReadArchive, FindsABombThatIsSpreadOverManyArchives) {
    IntakeLimits limits;
    limits.ratioFreeBytes = 3U << 20U;
    const std::string inner = zippedPicture(2U << 20U);
    EXPECT_EQ(refusalOf(readOf("work.zip", {{"a.zip", inner, AE_IFREG, ""}}, limits)).id,
              "intake.missing-file");
    EXPECT_EQ(
        refusalOf(readOf("work.zip",
                         {{"a.zip", inner, AE_IFREG, ""}, {"b.zip", inner, AE_IFREG, ""}}, limits))
            .id,
        "intake.unsafe-archive");
}

TEST(ReadArchive, CountsTheMembersOfAllArchivesInsideOneTogether) {
    IntakeLimits limits;
    limits.members = 10;
    std::vector<Member> members;
    for (int i = 0; i < 5; ++i)
        members.push_back({std::to_string(i), "", AE_IFREG, ""});
    const std::string inner = bytesOfArchive("inner.zip", members);
    EXPECT_EQ(refusalOf(readOf("work.zip", {{"a.zip", inner, AE_IFREG, ""}}, limits)).id,
              "intake.missing-file");
    EXPECT_EQ(
        refusalOf(readOf("work.zip",
                         {{"a.zip", inner, AE_IFREG, ""}, {"b.zip", inner, AE_IFREG, ""}}, limits))
            .id,
        "intake.too-large");
}

// A pax header may give every member a name of a megabyte, which compresses to nothing.
TEST(ReadArchive, RefusesANameThatIsLongerThanAnyPath) {
    const std::string name(3000, 'n');
    EXPECT_EQ(refusalOf(readOf("work.tar", {{name + "/Renderer.cpp", "", AE_IFREG, ""}})).id, "");
    const Finding finding =
        refusalOf(readOf("work.tar", {{name + name + "/Renderer.cpp", "", AE_IFREG, ""}}));
    EXPECT_EQ(finding.id, "intake.unsafe-archive");
    EXPECT_LT(finding.message.size(), 1000U);
}

// The list is made of every archive in a class folder that has only archives.
TEST(ListArchive, StopsAtABombOfNames) {
    const tests::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "names.tar.gz";
    std::vector<Member> members;
    for (int i = 0; i < 100; ++i)
        members.push_back({std::string(10'000, 'n') + std::to_string(i), "", AE_IFREG, ""});
    writeArchive(file, members);
    constexpr std::uint64_t kMost = 500'000;
    const MemberList list = listArchive(file, kMost);
    const std::size_t bytes =
        std::accumulate(list.paths.begin(), list.paths.end(), std::size_t{0},
                        [](std::size_t sum, const std::string& path) { return sum + path.size(); });
    EXPECT_LE(bytes, kMost);
    EXPECT_EQ(list.paths.size(), 49U);
    EXPECT_NE(list.damage.find("names"), std::string::npos) << list.damage;
    EXPECT_EQ(listArchive(file, 2 * kMost + 1000).damage, "");
}

// Changes the type of a tar's first member, and its header's checksum.
void setTypeOfFirst(const std::filesystem::path& file, char type) {
    constexpr std::size_t kSumAt = 148;
    constexpr std::size_t kTypeAt = 156;
    std::fstream stream{file, std::ios::in | std::ios::out | std::ios::binary};
    std::string header(512, '\0');
    stream.read(header.data(), 512);
    header[kTypeAt] = type;
    header.replace(kSumAt, 8, 8, ' ');
    unsigned sum = 0;
    for (const char c : header)
        sum += static_cast<unsigned char>(c);
    std::array<char, 8> octal{};
    std::snprintf(octal.data(), octal.size(), "%06o", sum);
    header.replace(kSumAt, 8, octal.data(), 8);
    stream.seekp(0);
    stream.write(header.data(), 512);
}

// GNU tar's folders may have contents, which libarchive unpacks only to skip them: without bounds.
TEST(ReadArchive, RefusesAFolderWithContents) {
    const tests::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "work.tar";
    writeArchive(file,
                 {{"work", "contents", AE_IFREG, ""}, {"Renderer.cpp", "render", AE_IFREG, ""}});
    setTypeOfFirst(file, 'D');
    const Submission submission = readSubmission({"somebody", file});
    EXPECT_EQ(refusalOf(submission).id, "intake.unsafe-archive");
}

TEST(ReadArchive, RefusesTooManyMembers) {
    IntakeLimits limits;
    limits.members = 10;
    std::vector<Member> members;
    for (int i = 0; i < 11; ++i)
        members.push_back({std::to_string(i), "", AE_IFREG, ""});
    EXPECT_EQ(refusalOf(readOf("work.zip", members, limits)).id, "intake.too-large");
}

TEST(ReadArchive, AsksAboutOneNameTwice) {
    const Submission submission = readOf(
        "work.zip", {{"Renderer.cpp", "one", AE_IFREG, ""}, {"Renderer.cpp", "two", AE_IFREG, ""}});
    EXPECT_EQ(refusalOf(submission).id, "intake.ambiguous");
}

TEST(ReadArchive, RefusesWhatIsNoArchive) {
    const tests::TemporaryFolder folder;
    folder.write("work.zip", "this is no archive");
    const Submission submission = readSubmission({"somebody", folder.path() / "work.zip"});
    EXPECT_EQ(refusalOf(submission).id, "intake.unsafe-archive");
}

TEST(ReadArchive, SurvivesDamage) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path() / "work.zip";
    writeArchive(file, {{"Renderer.cpp", std::string(5000, 'r'), AE_IFREG, ""},
                        {"screenshot.png", std::string(3000, 'p'), AE_IFREG, ""}});
    std::ifstream stream{file, std::ios::binary};
    const std::string bytes{std::istreambuf_iterator<char>{stream}, {}};
    std::mt19937 generator{3};
    for (int round = 0; round < 300; ++round) {
        std::string damaged =
            bytes.substr(0, round % 3 == 0 ? generator() % bytes.size() : bytes.size());
        for (int i = 0; i < 3 && !damaged.empty(); ++i)
            damaged[generator() % damaged.size()] = static_cast<char>(generator() & 0xFFU);
        folder.write("work.zip", damaged);
        const Submission submission = readSubmission({"somebody", file});
        EXPECT_LE(submission.part("Renderer.cpp").value_or("").size(), 256U << 10U);
    }
}

TEST(ReadArchive, SaysWhereAFileCannotBeRead) {
    EXPECT_THROW(static_cast<void>(readSubmission({"somebody", "/nowhere.zip"})),
                 raytracer::InputError);
}

}  // namespace
}  // namespace ticker::intake

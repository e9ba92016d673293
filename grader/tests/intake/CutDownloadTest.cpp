// A class download that broke off, or was damaged on its way, does not count against students.
#include <grader/intake/ClassExport.h>
#include <grader/intake/Intake.h>
#include <grader/tests/support/MoodleExport.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace ticker::intake {
namespace {

namespace fs = std::filesystem;
using tests::NamedBytes;

std::string bytesOf(const fs::path& file) {
    std::ifstream stream{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

// Bytes that cannot be compressed, so that every cut lies inside of a student's file.
std::string noise(unsigned seed) {
    std::mt19937 generator{seed};
    std::string bytes(3000, '\0');
    for (char& c : bytes)
        c = static_cast<char>(generator() & 0xFFU);
    return bytes;
}

const std::vector<NamedBytes> kMoodle{{"Ann Lee_1_assignsubmission_file/screenshot.png", noise(1)},
                                      {"Bob_2_assignsubmission_file/screenshot.png", noise(2)},
                                      {"Cy_3_assignsubmission_file/screenshot.png", noise(3)}};
const std::vector<NamedBytes> kCanvas{{"leeann_4711_90210_screenshot.png", noise(1)},
                                      {"kimbo_late_99_90305_screenshot.png", noise(2)}};

/// The error message for a zip of this content; empty if its submissions are found.
std::string complaintAbout(const tests::TemporaryFolder& folder, const std::string& bytes) {
    try {
        static_cast<void>(findSubmissions(folder.write("class.zip", bytes)));
    } catch (const raytracer::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(CutDownload, IsRefusedAsAWholeWhereverItWasCut) {
    for (const auto& members : {kMoodle, kCanvas}) {
        const tests::TemporaryFolder folder;
        tests::writeZip(folder.path() / "whole.zip", members);
        const std::string whole = bytesOf(folder.path() / "whole.zip");
        const std::size_t works = whole.find("PK\x01\x02");
        ASSERT_NE(works, std::string::npos);
        EXPECT_EQ(complaintAbout(folder, whole), "");
        for (std::size_t cut = 200; cut < works; cut += 97) {
            const std::string complaint = complaintAbout(folder, whole.substr(0, cut));
            EXPECT_EQ(complaint.find((folder.path() / "class.zip").string()), 0U) << complaint;
            EXPECT_NE(complaint.find("download it again"), std::string::npos) << complaint;
        }
    }
}

TEST(CutDownload, IsNotTakenForTheWorkOfThoseWhoAreInIt) {
    const tests::TemporaryFolder folder;
    tests::writeZip(folder.path() / "class.zip", kMoodle);
    const auto located = findSubmissions(folder.path() / "class.zip");
    const std::string whole = bytesOf(folder.path() / "class.zip");
    folder.write("class.zip", whole.substr(0, whole.size() / 2));
    for (const Located& each : located)
        EXPECT_THROW(static_cast<void>(readSubmission(each)), raytracer::InputError) << each.name;
}

TEST(CutDownload, DamageInsideAMemberIsNotItsOwners) {
    const tests::TemporaryFolder folder;
    tests::writeZip(folder.path() / "class.zip", kMoodle);
    std::string bytes = bytesOf(folder.path() / "class.zip");
    const std::size_t second = bytes.find("PK\x03\x04", bytes.find("Ann Lee_1"));
    bytes[second + 1500] = static_cast<char>(bytes[second + 1500] ^ 0x55);
    folder.write("class.zip", bytes);
    for (const Located& each : findSubmissions(folder.path() / "class.zip")) {
        if (each.owner == "Bob_2")
            EXPECT_THROW(static_cast<void>(readSubmission(each)), raytracer::InputError);
        else
            EXPECT_TRUE(readSubmission(each).part("screenshot.png")) << each.name;
    }
}

TEST(CutDownload, OfOneStudentIsAFindingInThatStudentsWork) {
    const tests::TemporaryFolder folder;
    tests::writeZip(folder.path() / "ann.zip", {{"work/Renderer.cpp", noise(1)}});
    const std::string whole = bytesOf(folder.path() / "ann.zip");
    folder.write("ann.zip", whole.substr(0, whole.size() / 2));
    const auto located = findSubmissions(folder.path() / "ann.zip");
    ASSERT_EQ(located.size(), 1U);
    const Submission ann = readSubmission(located[0]);
    ASSERT_FALSE(ann.findings.empty());
    EXPECT_EQ(ann.findings[0].finding.id, "intake.unsafe-archive");
}

TEST(CutDownload, ThatAStudentImitatesStopsNobodyElse) {
    const tests::TemporaryFolder folder;
    folder.write("class/ann/Renderer.cpp", "ann");
    tests::writeZip(folder.path() / "class/mallory.zip", kMoodle);
    const std::string whole = bytesOf(folder.path() / "class/mallory.zip");
    folder.write("class/mallory.zip", whole.substr(0, whole.size() / 2));
    const auto located = findSubmissions(folder.path() / "class");
    ASSERT_EQ(located.size(), 2U);
    EXPECT_EQ(readSubmission(located[0]).part("Renderer.cpp"), "ann");
    EXPECT_EQ(readSubmission(located[1]).findings.at(0).finding.id, "intake.unsafe-archive");
}

}  // namespace
}  // namespace ticker::intake

// Messages about a file that does not give a program.
#include <grader/pipeline/Grade.h>
#include <grader/tests/pipeline/TestGrader.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker::pipeline {
namespace {

using tests::taskOf;

SubmissionResult gradeBumpySphere(const std::string& source) {
    intake::Submission work;
    work.name = "somebody";
    work.parts["BumpySphere.cpp"] = source;
    return gradeSubmission(work, tests::testGrader(), 1);
}

/// The reference with a text in front.
std::string referenceAfter(const std::string& text) {
    return text + tests::readFile("reference_solution/exercise/BumpySphere.cpp");
}

const Finding& onlyFinding(const SubmissionResult& result) {
    const TaskReport& task = taskOf(result, "T1");
    EXPECT_EQ(task.state, TaskState::blocked);
    EXPECT_EQ(task.findings.size(), 1U);
    return task.findings.at(0);
}

TEST(BuildWords, SayOfAFileWithoutCodeThatItIsEmptyAndAskNoCompiler) {
    for (const char* source : {"", "\xEF\xBB\xBF", " \r\n\t\n", "// Sorry.\n/* Next year. */\n"}) {
        const SubmissionResult result = gradeBumpySphere(source);
        const Finding& finding = onlyFinding(result);
        EXPECT_EQ(finding.id, "build.failed");
        EXPECT_TRUE(finding.message == "BumpySphere.cpp is empty." ||
                    finding.message.starts_with("BumpySphere.cpp holds no code"))
            << finding.message;
        EXPECT_NE(finding.hint.find("hand in the BumpySphere.cpp"), std::string::npos);
        EXPECT_EQ(result.verdict, Verdict::notAwarded);
        EXPECT_EQ(result.timing.compileMs, 0.0);
        EXPECT_TRUE(result.diagnostics.empty());
    }
}

TEST(BuildWords, SayOfTooMuchStaticDataThatItIsTooMuch) {
    const SubmissionResult result = gradeBumpySphere(
        referenceAfter("char room[10ULL << 30U];\nchar* roomEnd() { return room + 5; }\n"));
    const Finding& finding = onlyFinding(result);
    EXPECT_EQ(finding.id, "build.failed");
    EXPECT_NE(finding.message.find("static variables"), std::string::npos) << finding.message;
    EXPECT_EQ(finding.message.find("reloc"), std::string::npos) << finding.message;
}

TEST(BuildWords, NameTheFunctionThatALinkerMisses) {
    const SubmissionResult bump = gradeBumpySphere("int x = 1;\n");
    EXPECT_TRUE(onlyFinding(bump).message.starts_with(
        "BumpySphere.cpp defines no BumpySphere::getNormalAt"))
        << onlyFinding(bump).message;

    intake::Submission work;
    work.name = "somebody";
    work.parts["Renderer.cpp"] =
        "#include <raytracer/render/Renderer.h>\n"
        "using namespace raytracer;\n"
        "Image Renderer::render(const Scene&) const { return Image{settings()}; }\n";
    const TaskReport task = taskOf(gradeSubmission(work, tests::testGrader(), 1), "T2.1");
    EXPECT_TRUE(task.reason.starts_with("Renderer.cpp defines no Renderer::illuminate"))
        << task.reason;
}

// More than a program may have, but still within the linker's limits.
TEST(BuildWords, SayHowMuchMemoryTooLargeStaticDataTakes) {
    const SubmissionResult result = gradeBumpySphere(
        referenceAfter("char room[1'700'000'000];\nchar* roomEnd() { return room + 5; }\n"));
    const Finding& finding = onlyFinding(result);
    EXPECT_EQ(finding.id, "run.memory");
    EXPECT_NE(finding.message.find("take 1701 MB"), std::string::npos) << finding.message;
    EXPECT_NE(finding.message.find("1500 MB"), std::string::npos) << finding.message;
}

TEST(BuildWords, NameAnAssemblersErrorAndNoTemporaryFile) {
    const SubmissionResult result = gradeBumpySphere(referenceAfter("asm(\"nonsense\");\n"));
    const Finding& finding = onlyFinding(result);
    EXPECT_EQ(finding.id, "build.failed");
    EXPECT_NE(finding.message.find("Error: no such instruction"), std::string::npos)
        << finding.message;
    ASSERT_EQ(result.diagnostics.size(), 1U);
    EXPECT_EQ(result.diagnostics[0].text.find("/tmp"), std::string::npos)
        << result.diagnostics[0].text;
}

}  // namespace
}  // namespace ticker::pipeline

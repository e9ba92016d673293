// Archives that students hand in.
#include "../support/Files.h"
#include "../support/TemporaryFolder.h"
#include "Fuzz.h"

#include <grader/base/Utf8.h>
#include <grader/corpus/Entry.h>
#include <grader/intake/Intake.h>

#include <algorithm>

namespace ticker::fuzz {
namespace {

namespace fs = std::filesystem;

// Small limits, so that one input is fast.
intake::IntakeLimits limits() {
    intake::IntakeLimits limits;
    limits.sourceBytes = 4096;
    limits.screenshotBytes = 4096;
    limits.unpackedBytes = 1U << 20U;
    limits.members = 64;
    limits.ratioFreeBytes = 64U << 10U;
    return limits;
}

void check(const intake::Submission& submission) {
    for (const std::string& part : defaultExercise().parts())
        if (const auto& bytes = submission.part(part))
            require(bytes->size() <= intake::byteLimitOf(part, limits()), "parts are bounded");
    require(std::ranges::all_of(submission.ignored,
                                [](const std::string& name) { return asUtf8(name) == name; }),
            "names are UTF-8");
}

std::string written(const std::string& name, std::vector<corpus::Member> members) {
    const tests::TemporaryFolder folder;
    fs::create_directory(folder.path() / "out");
    corpus::Entry made;
    made.made = {{name, corpus::MadeArchive{std::move(members)}}};
    writeSubmission(made, "/nowhere", folder.path() / "out");
    return tests::readFile((folder.path() / "out" / name).string());
}

}  // namespace

bool give(std::string_view input) {
    static const tests::TemporaryFolder folder;
    folder.write("submission.zip", input);
    const intake::Submission submission =
        intake::readSubmission({"name", folder.path() / "submission.zip"}, limits());
    check(submission);
    return std::ranges::none_of(submission.findings, [](const intake::IntakeFinding& finding) {
        return finding.finding.id == "intake.unsafe-archive";
    });
}

std::vector<std::string> seeds() {
    using corpus::Member;
    const std::vector<Member> good{{"me/BumpySphere.cpp", Member::Kind::file, "// bumpy\n"},
                                   {"me/Renderer.cpp", Member::Kind::file, "// renderer\n"},
                                   {"me/screenshot.png", Member::Kind::file, "\x89PNG\r\n"},
                                   {"me/notes \xC3\xA4.txt", Member::Kind::file, "notes"}};
    const std::vector<Member> bad{{"Renderer.cpp", Member::Kind::file, "x", 300},
                                  {"link", Member::Kind::symbolicLink, "/etc/passwd"},
                                  {"../up", Member::Kind::file, "up"}};
    return {written("a.zip", good), written("a.tar", good), written("a.zip", bad),
            written("a.tar", bad)};
}

}  // namespace ticker::fuzz

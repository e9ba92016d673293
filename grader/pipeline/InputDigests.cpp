#include <grader/pipeline/InputDigests.h>

#include <grader/base/Digest.h>
#include <grader/sandbox/HelperProgram.h>

#include <algorithm>

namespace ticker::pipeline {
namespace fs = std::filesystem;
namespace {

Digest& addParts(Digest& digest, const intake::Submission& submission, const Exercise& exercise) {
    for (const std::string& part : exercise.parts()) {
        const auto& bytes = submission.part(part);
        digest.add(bytes ? "there" : "missing").add(bytes.value_or(""));
    }
    return digest;
}

std::string filesOf(const intake::Submission& submission, const Exercise& exercise) {
    Digest digest;
    addParts(digest.add(submission.name), submission, exercise);
    for (const std::string& path : submission.ignored)
        digest.add(path);
    for (const intake::IntakeFinding& found : submission.findings)
        digest.add(found.finding.id).add(found.finding.message);
    return digest.text();
}

}  // namespace

std::string toolBuild(const build::Kit& kit, const std::vector<fs::path>& data) {
    Digest digest;
    digest.addFile("/proc/self/exe")
        .addFile(kit.folder() / "kit.json")
        .addFile(kit.folder() / "lib" / "libkit.a")
        .addFile(kit.folder() / "lib" / "probe.o");
    for (const std::string& file : kit.files())
        digest.add(kit.templateSource(file)).addFile(kit.folder() / kit.templateObject(file));
    for (const char* helper : {"ticker-jail", "ticker-decode"})
        digest.addFile(sandbox::findProgram(helper));
    std::vector<fs::path> files;
    for (const fs::path& folder : data)
        for (const fs::directory_entry& entry : fs::directory_iterator{folder})
            if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    for (const fs::path& file : files)
        digest.add(file.filename().string()).addFile(file);
    return digest.text();
}

Inputs inputsOf(const intake::Submission& submission, const Grader& grader, std::uint64_t seed) {
    return {filesOf(submission, *grader.exercise), grader.build,
            howDigest(grader, sandbox::toString(grader.sandbox.level()), seed)};
}

std::string howDigest(const Grader& grader, std::string_view sandboxLevel, std::uint64_t seed) {
    Digest how;
    how.add(grader.rubricText)
        .add(sandboxLevel)
        .add(grader.exercise->name)
        .add(grader.option)
        .add(std::to_string(seed));
    return how.text();
}

std::uint64_t questionSeed(const intake::Submission& submission, std::uint64_t seed,
                           const Exercise& exercise) {
    Digest digest;
    addParts(digest.add(std::to_string(seed)), submission, exercise);
    constexpr int kHexadecimal = 16;
    return std::stoull(digest.text().substr(0, 16), nullptr, kHexadecimal);
}

}  // namespace ticker::pipeline

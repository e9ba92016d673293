#include <grader/pipeline/Inputs.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <string_view>

namespace ticker::pipeline {
namespace fs = std::filesystem;
namespace {

/// SHA-256 over a list of texts, each with its length, so that no two lists give the same bytes.
class Digest {
public:
    Digest() { check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr)); }

    Digest& add(std::string_view text) {
        addBytes(fmt::format("{}:", text.size()));
        addBytes(text);
        return *this;
    }

    Digest& addFile(const fs::path& file) {
        std::ifstream stream{file, std::ios::binary};
        std::string block(1U << 20U, '\0');
        while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) ||
               stream.gcount() > 0)
            addBytes({block.data(), static_cast<std::size_t>(stream.gcount())});
        return add("");
    }

    /// The first 128 bits, which is enough against accidents and against students.
    [[nodiscard]] std::string text() {
        std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
        check(EVP_DigestFinal_ex(context_.get(), bytes.data(), nullptr));
        std::string hex;
        for (std::size_t i = 0; i < 16; ++i)
            hex += fmt::format("{:02x}", bytes.at(i));
        return hex;
    }

private:
    static void check(int done) {
        if (done != 1) throw raytracer::Error("the system's libcrypto gives no SHA-256");
    }

    void addBytes(std::string_view bytes) {
        check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()));
    }

    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_{EVP_MD_CTX_new(),
                                                                     EVP_MD_CTX_free};
};

Digest& addParts(Digest& digest, const intake::Submission& submission) {
    for (const intake::Part part : intake::kParts) {
        const auto& bytes = submission.part(part);
        digest.add(bytes ? "there" : "missing").add(bytes.value_or(""));
    }
    return digest;
}

std::string filesOf(const intake::Submission& submission) {
    Digest digest;
    addParts(digest.add(submission.name), submission);
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
    Digest how;
    how.add(grader.rubricText)
        .add(sandbox::toString(grader.sandbox.level()))
        .add(std::to_string(static_cast<int>(grader.option)))
        .add(std::to_string(seed));
    return {filesOf(submission), grader.build, how.text()};
}

std::uint64_t questionSeed(const intake::Submission& submission, std::uint64_t seed) {
    Digest digest;
    addParts(digest.add(std::to_string(seed)), submission);
    constexpr int kHexadecimal = 16;
    return std::stoull(digest.text().substr(0, 16), nullptr, kHexadecimal);
}

}  // namespace ticker::pipeline

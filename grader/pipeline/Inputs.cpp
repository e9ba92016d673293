#include <grader/pipeline/Inputs.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <openssl/evp.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>

namespace ticker::pipeline {
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

    Digest& addFile(const std::filesystem::path& file) {
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

std::string filesOf(const intake::Submission& submission) {
    Digest digest;
    digest.add(submission.name);
    for (const intake::Part part : intake::kParts) {
        const auto& bytes = submission.part(part);
        digest.add(bytes ? "there" : "missing").add(bytes.value_or(""));
    }
    for (const std::string& path : submission.ignored)
        digest.add(path);
    for (const intake::IntakeFinding& found : submission.findings)
        digest.add(found.finding.id).add(found.finding.message);
    return digest.text();
}

}  // namespace

std::string toolBuild(const build::Kit& kit, const std::vector<SpecScene>& scenes) {
    Digest digest;
    digest.addFile("/proc/self/exe")
        .addFile(kit.folder() / "kit.json")
        .addFile(kit.folder() / "lib" / "libkit.a")
        .addFile(kit.folder() / "lib" / "probe.o");
    for (const SpecScene& scene : scenes) {
        const std::vector<std::uint8_t>& bytes = scene.expected.rgb;
        digest.add({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
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

}  // namespace ticker::pipeline

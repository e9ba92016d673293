#include <grader/base/Digest.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>

namespace ticker {
namespace {

void checkDigest(int done) {
    if (done != 1) throw raytracer::Error("the system's libcrypto gives no SHA-256");
}

}  // namespace

struct Digest::Context {
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> handle{EVP_MD_CTX_new(),
                                                                   EVP_MD_CTX_free};
};

Digest::Digest() : context_(std::make_unique<Context>()) {
    checkDigest(EVP_DigestInit_ex(context_->handle.get(), EVP_sha256(), nullptr));
}

Digest::~Digest() = default;

Digest& Digest::add(std::string_view text) {
    addBytes(fmt::format("{}:", text.size()));
    addBytes(text);
    return *this;
}

Digest& Digest::addFile(const std::filesystem::path& file) {
    std::ifstream stream{file, std::ios::binary};
    std::string block(1U << 20U, '\0');
    while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) ||
           stream.gcount() > 0)
        addBytes({block.data(), static_cast<std::size_t>(stream.gcount())});
    return add("");
}

std::string Digest::text() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
    checkDigest(EVP_DigestFinal_ex(context_->handle.get(), bytes.data(), nullptr));
    std::string hex;
    for (std::size_t i = 0; i < 16; ++i)
        hex += fmt::format("{:02x}", bytes.at(i));
    return hex;
}

void Digest::addBytes(std::string_view bytes) {
    checkDigest(EVP_DigestUpdate(context_->handle.get(), bytes.data(), bytes.size()));
}

}  // namespace ticker

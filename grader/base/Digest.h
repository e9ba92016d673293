#ifndef TICKER_BASE_DIGEST_H
#define TICKER_BASE_DIGEST_H

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace ticker {

/// SHA-256 over a list of texts and files. A text is preceded by its length, so that no two lists
/// of texts give the same bytes; a file is not.
class Digest {
public:
    Digest();
    ~Digest();
    Digest(const Digest&) = delete;
    Digest& operator=(const Digest&) = delete;

    Digest& add(std::string_view text);
    /// The bytes of a file, followed by an empty text; a file that cannot be opened counts as
    /// empty.
    Digest& addFile(const std::filesystem::path& file);

    /// The first 128 bits in hexadecimal, which is enough against accidents and against students.
    /// Nothing can be added afterwards.
    [[nodiscard]] std::string text();

private:
    void addBytes(std::string_view bytes);

    struct Context;
    std::unique_ptr<Context> context_;
};

}  // namespace ticker

#endif

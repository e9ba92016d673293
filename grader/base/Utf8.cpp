#include <grader/base/Utf8.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ticker {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

struct Decoded {
    std::uint32_t codePoint = 0;
    std::size_t bytes = 0;  // 0: not UTF-8
};

std::size_t lengthFrom(unsigned char first) {
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first < 0xE0) return 2;
    if (first >= 0xE0 && first < 0xF0) return 3;
    if (first >= 0xF0 && first < 0xF5) return 4;
    return 0;
}

Decoded decode(std::string_view text) {
    const auto byteAt = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t bytes = lengthFrom(byteAt(0));
    if (bytes == 0 || bytes > text.size()) return {};
    if (bytes == 1) return {byteAt(0), 1};
    std::uint32_t codePoint = byteAt(0) & (0xFFU >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byteAt(i) & 0xC0U) != 0x80U) return {};
        codePoint = (codePoint << 6U) | (byteAt(i) & 0x3FU);
    }
    const bool overlong = (bytes == 3 && codePoint < 0x800) || (bytes == 4 && codePoint < 0x10000);
    const bool surrogate = codePoint >= 0xD800 && codePoint < 0xE000;
    if (overlong || surrogate || codePoint > 0x10FFFF) return {};
    return {codePoint, bytes};
}

bool mayMislead(std::uint32_t c) {
    const bool control = (c < 0x20 && c != '\t' && c != '\n') || (c >= 0x7F && c < 0xA0);
    const bool bidirectional = (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069) ||
                               c == 0x200E || c == 0x200F || c == 0x061C;
    const bool noCharacter = (c & 0xFFFEU) == 0xFFFEU;
    return control || bidirectional || noCharacter;
}

/// What moves a cursor or begins a line: C0, DEL, C1, and U+2028 and U+2029.
bool isControl(std::uint32_t c) {
    return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x2028 || c == 0x2029;
}

/// `text` as valid UTF-8: invalid bytes, and characters for which `isUnwanted` is true, become
/// U+FFFD.
template <typename Unwanted>
std::string cleaned(std::string_view text, Unwanted&& isUnwanted) {
    std::string clean;
    clean.reserve(text.size());
    while (!text.empty()) {
        const Decoded next = decode(text);
        const std::size_t bytes = std::max<std::size_t>(next.bytes, 1);
        clean +=
            next.bytes == 0 || isUnwanted(next.codePoint) ? kReplacement : text.substr(0, bytes);
        text.remove_prefix(bytes);
    }
    return clean;
}

}  // namespace

std::string cleanText(std::string_view text) {
    std::string lines;
    lines.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text.substr(i, 2) != "\r\n") lines += text[i];
    return cleaned(lines, mayMislead);
}

std::string asUtf8(std::string_view text) {
    return cleaned(text, [](std::uint32_t c) { return c == 0; });
}

std::string asPlainLine(std::string_view text) {
    return cleaned(text, isControl);
}

std::string lowerCase(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

}  // namespace ticker

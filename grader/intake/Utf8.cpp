#include <grader/intake/Utf8.h>

#include <algorithm>

namespace ticker::intake {
namespace {

// How many bytes of valid UTF-8 begin here; 0: none.
std::size_t sequenceLength(std::string_view rest) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(rest[i]); };
    const auto continues = [&](std::size_t i) {
        return i < rest.size() && (byte(i) & 0xC0U) == 0x80U;
    };
    if (byte(0) < 0x80) return byte(0) == 0 ? 0 : 1;
    if (byte(0) >= 0xC2 && byte(0) <= 0xDF && continues(1)) return 2;
    if ((byte(0) & 0xF0U) == 0xE0U && continues(1) && continues(2)) {
        const bool overlong = byte(0) == 0xE0 && byte(1) < 0xA0;
        const bool surrogate = byte(0) == 0xED && byte(1) >= 0xA0;
        return overlong || surrogate ? 0 : 3;
    }
    if (byte(0) >= 0xF0 && byte(0) <= 0xF4 && continues(1) && continues(2) && continues(3)) {
        const bool overlong = byte(0) == 0xF0 && byte(1) < 0x90;
        const bool tooLarge = byte(0) == 0xF4 && byte(1) >= 0x90;
        return overlong || tooLarge ? 0 : 4;
    }
    return 0;
}

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

// Of a valid sequence: what moves a cursor or begins a line. C0, DEL, C1, and U+2028 and U+2029.
bool isControl(std::string_view character) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
    if (character.size() == 1) return byte(0) < 0x20 || byte(0) == 0x7F;
    if (character.size() == 2) return byte(0) == 0xC2 && byte(1) < 0xA0;
    return character == "\xE2\x80\xA8" || character == "\xE2\x80\xA9";
}

/// `text` as valid UTF-8, without the characters that `isUnwanted` names.
template <typename Unwanted>
std::string cleaned(std::string_view text, Unwanted&& isUnwanted) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = sequenceLength(text);
        const std::string_view character = text.substr(0, length);
        result += length == 0 || isUnwanted(character) ? kReplacement : character;
        text.remove_prefix(std::max<std::size_t>(1, length));
    }
    return result;
}

}  // namespace

std::string asUtf8(std::string_view text) {
    return cleaned(text, [](std::string_view) { return false; });
}

std::string asPlainLine(std::string_view text) {
    return cleaned(text, isControl);
}

}  // namespace ticker::intake

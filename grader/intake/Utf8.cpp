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

}  // namespace

std::string asUtf8(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = sequenceLength(text);
        if (length == 0)
            result += "\xEF\xBF\xBD";
        else
            result += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(1, length));
    }
    return result;
}

}  // namespace ticker::intake

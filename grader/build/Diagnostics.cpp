#include <grader/build/Diagnostics.h>

#include <algorithm>
#include <cctype>

namespace ticker::build {
namespace {

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

// The compiler driver names objects ccXXXXXX.o, in the scratch folder.
void nameObjects(std::string& text, std::string_view fileName) {
    constexpr std::size_t kNameLength = 8;
    for (std::size_t at = text.find("/cc"); at != std::string::npos;
         at = text.find("/cc", at + 1)) {
        const std::size_t end = at + 1 + kNameLength;
        if (end + 2 > text.size() || text.compare(end, 2, ".o") != 0) continue;
        const bool isName = std::all_of(text.begin() + static_cast<std::ptrdiff_t>(at + 1),
                                        text.begin() + static_cast<std::ptrdiff_t>(end),
                                        [](unsigned char c) { return std::isalnum(c) != 0; });
        if (!isName) continue;
        std::size_t begin = at;
        while (begin > 0 && std::isgraph(static_cast<unsigned char>(text[begin - 1])) != 0 &&
               text[begin - 1] != '(')
            --begin;
        text.replace(begin, end + 2 - begin, fileName);
        at = begin;
    }
}

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

std::string readableDiagnostics(std::string_view output,
                                const std::vector<std::filesystem::path>& hidden,
                                std::string_view fileName) {
    std::string text{output};
    for (const std::filesystem::path& folder : hidden)
        replaceAll(text, folder.string() + "/", "");
    replaceAll(text, "include/raytracer/", "raytracer/");
    nameObjects(text, fileName);
    text = asUtf8(text);
    if (text.size() <= kMostDiagnostics) return text;
    const std::size_t line = text.rfind('\n', kMostDiagnostics);
    text.resize(line == std::string::npos ? 0 : line + 1);
    return text + "(more was left out)\n";
}

}  // namespace ticker::build

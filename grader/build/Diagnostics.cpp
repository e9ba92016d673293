#include <grader/build/Diagnostics.h>

#include <grader/base/Utf8.h>

#include <algorithm>
#include <cctype>

namespace ticker::build {
namespace {

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

// The compiler driver names its temporary files ccXXXXXX plus this ending, in the scratch folder.
void nameTemporary(std::string& text, std::string_view ending, std::string_view name) {
    constexpr std::size_t kNameLength = 8;
    for (std::size_t at = text.find("/cc"); at != std::string::npos;
         at = text.find("/cc", at + 1)) {
        const std::size_t end = at + 1 + kNameLength;
        if (end + ending.size() > text.size() || text.compare(end, ending.size(), ending) != 0)
            continue;
        const bool isName = std::all_of(text.begin() + static_cast<std::ptrdiff_t>(at + 1),
                                        text.begin() + static_cast<std::ptrdiff_t>(end),
                                        [](unsigned char c) { return std::isalnum(c) != 0; });
        if (!isName) continue;
        std::size_t begin = at;
        while (begin > 0 && std::isgraph(static_cast<unsigned char>(text[begin - 1])) != 0 &&
               text[begin - 1] != '(')
            --begin;
        text.replace(begin, end + ending.size() - begin, name);
        at = begin;
    }
}

}  // namespace

std::string readableDiagnostics(std::string_view output,
                                const std::vector<std::filesystem::path>& hidden,
                                std::string_view fileName) {
    std::string text{output};
    for (const std::filesystem::path& folder : hidden)
        replaceAll(text, folder.string() + "/", "");
    replaceAll(text, "include/raytracer/", "raytracer/");
    nameTemporary(text, ".o", fileName);
    // Line numbers refer to the assembler code, so they must not follow the plain name of the
    // student's file.
    nameTemporary(text, ".s", std::string{fileName} + " (as assembler code)");
    text = asUtf8(text);
    if (text.size() <= kMostDiagnostics) return text;
    const std::size_t line = text.rfind('\n', kMostDiagnostics);
    text.resize(line == std::string::npos ? 0 : line + 1);
    return text + "(more was left out)\n";
}

}  // namespace ticker::build

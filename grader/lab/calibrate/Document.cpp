#include <grader/lab/calibrate/Document.h>

#include <grader/base/WholeFile.h>

#include <optional>

namespace ticker::calibrate {
namespace {

struct Span {
    std::size_t begin;
    std::size_t end;
};

std::string opening(const std::string& name) {
    return "<!-- calibrate: " + name + " -->\n";
}

constexpr const char* kClosing = "<!-- end -->\n";

std::optional<Span> spanOf(const std::string& document, const std::string& name) {
    const std::size_t mark = document.find(opening(name));
    if (mark == std::string::npos) return std::nullopt;
    const std::size_t begin = mark + opening(name).size();
    const std::size_t end = document.find(kClosing, begin);
    if (end == std::string::npos) return std::nullopt;
    return Span{begin, end};
}

}  // namespace

std::string sectionOf(const std::string& document, const std::string& name) {
    const std::optional<Span> span = spanOf(document, name);
    return span ? document.substr(span->begin, span->end - span->begin) : "";
}

std::string withSection(const std::string& document, const std::string& name,
                        const std::string& text) {
    const std::string whole = text.empty() || text.back() == '\n' ? text : text + "\n";
    if (const std::optional<Span> span = spanOf(document, name))
        return document.substr(0, span->begin) + whole + document.substr(span->end);
    return document + "\n## " + name + "\n" + opening(name) + whole + kClosing;
}

void writeIfChanged(const std::string& text, const std::filesystem::path& file) {
    if (readIfThere(file) != text) writeAtomically(text, file);
}

}  // namespace ticker::calibrate

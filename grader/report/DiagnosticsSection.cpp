#include <grader/report/Escape.h>
#include <grader/report/PageParts.h>

#include <fmt/core.h>
#include <algorithm>
#include <charconv>
#include <vector>

namespace ticker::report {
namespace {

constexpr std::size_t kMostErrors = 8;  // later errors are mostly consequences
constexpr int kLinesAround = 3;

std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// "File.cpp:12:5: error: what": a compiler message with a position in the file.
struct Remark {
    int line = 0;
    std::string_view kind;  ///< "error" or "warning"
    std::string_view message;
};

bool takePrefix(std::string_view& text, std::string_view prefix) {
    if (text.substr(0, prefix.size()) != prefix) return false;
    text.remove_prefix(prefix.size());
    return true;
}

/// Removes "12:" from the front; returns 0 without such a number.
int takeNumber(std::string_view& text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const auto length = static_cast<std::size_t>(end - text.data());
    if (error != std::errc{} || length >= text.size() || text[length] != ':') return 0;
    text.remove_prefix(length + 1);
    return number;
}

std::vector<Remark> remarksOf(const Diagnostics& said) {
    std::vector<Remark> remarks;
    for (std::string_view rest : linesOf(said.text)) {
        if (!takePrefix(rest, said.file + ":")) continue;
        const int line = takeNumber(rest);
        if (line < 1) continue;
        (void)takeNumber(rest);  // the column; gcc's excerpt below has a caret
        for (const std::string_view kind : {"error", "warning"}) {
            std::string_view message = rest;
            if (takePrefix(message, fmt::format(" fatal {}: ", kind)) ||
                takePrefix(message, fmt::format(" {}: ", kind)))
                remarks.push_back({line, kind, message});
        }
    }
    return remarks;
}

std::string excerpt(const std::vector<std::string_view>& source, int line) {
    const int last = std::min(line + kLinesAround, static_cast<int>(source.size()));
    if (line > last) return "";
    std::string html = "<pre class=\"source\"><code>";
    for (int number = std::max(1, line - kLinesAround); number <= last; ++number) {
        const std::string text = escapeHtml(source[static_cast<std::size_t>(number - 1)]);
        const bool named = number == line;
        html += fmt::format("{}<span class=\"number\">{:>4}</span> {}{}\n", named ? "<mark>" : "",
                            number, text, named ? "</mark>" : "");
    }
    return html + "</code></pre>";
}

std::string_view sourceOf(const SubmissionResult& result, std::string_view file) {
    for (const SourceText& source : result.sources)
        if (source.file == file) return source.bytes;
    return {};
}

std::string ofFile(const Diagnostics& said, std::string_view text) {
    const std::vector<std::string_view> source = linesOf(text);
    std::string html = fmt::format("<h3>{}</h3>", escapeHtml(said.file));
    const std::vector<Remark> remarks = remarksOf(said);
    const std::size_t shown = std::min(remarks.size(), kMostErrors);
    for (std::size_t i = 0; i < shown; ++i) {
        const Remark& remark = remarks[i];
        html += fmt::format("<div class=\"remark\"><p>{} line {}: {}</p>{}</div>",
                            badge(remark.kind == "error" ? "fail" : "warn", remark.kind),
                            remark.line, escapeHtml(remark.message), excerpt(source, remark.line));
    }
    if (remarks.size() > shown)
        html += fmt::format("<p class=\"soft\">{} more follow.</p>", remarks.size() - shown);
    return html + fmt::format(
                      "<details{}><summary>The compiler's own words</summary><pre>{}</pre>"
                      "</details>",
                      remarks.empty() ? " open" : "", escapeHtml(said.text));
}

}  // namespace

std::string diagnosticsSection(const SubmissionResult& result) {
    std::string html;
    for (const Diagnostics& said : result.diagnostics)
        if (!said.text.empty()) html += ofFile(said, sourceOf(result, said.file));
    if (html.empty()) return "";
    return "<section id=\"compiler\"><h2>What the compiler said</h2>" + html + "</section>";
}

}  // namespace ticker::report

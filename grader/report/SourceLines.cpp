#include <grader/report/Escape.h>
#include <grader/report/SourceLines.h>

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

namespace ticker::report {
namespace {

constexpr int kLinesAround = 3;

bool takePrefix(std::string_view& text, std::string_view prefix) {
    if (text.substr(0, prefix.size()) != prefix) return false;
    text.remove_prefix(prefix.size());
    return true;
}

/// Takes a line number such as "12:" from the front; 0 if the text begins otherwise.
int takeNumber(std::string_view& text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const auto length = static_cast<std::size_t>(end - text.data());
    if (error != std::errc{} || length >= text.size() || text[length] != ':') return 0;
    text.remove_prefix(length + 1);
    return number;
}

}  // namespace

std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::vector<Remark> remarksOf(const Diagnostics& said) {
    std::vector<Remark> remarks;
    for (std::string_view rest : linesOf(said.text)) {
        if (!takePrefix(rest, said.file + ":")) continue;
        const int line = takeNumber(rest);
        if (line < 1) continue;
        (void)takeNumber(rest);  // the column: gcc's own excerpt below has the caret
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

}  // namespace ticker::report

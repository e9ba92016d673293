#include <grader/report/Escape.h>
#include <grader/report/PageParts.h>
#include <grader/report/PageSources.h>

#include <fmt/core.h>
#include <cctype>

namespace ticker::report {

std::string badge(std::string_view kind, std::string_view words) {
    return fmt::format(R"(<span class="badge {}">{}</span>)", kind, escapeHtml(words));
}

std::string address(std::string_view path) {
    std::string encoded;
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || std::string_view{"-_.~/"}.find(c) != std::string_view::npos)
            encoded += c;
        else
            encoded += fmt::format("%{:02X}", byte);
    }
    return encoded;
}

std::string pageHead(std::string_view title, std::string_view css) {
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
        "<meta name=\"color-scheme\" content=\"light dark\">"
        "<title>{}</title><style>{}{}</style></head><body>"
        "<a class=\"skip\" href=\"#main\">Skip to the content</a>",
        escapeHtml(title), commonCss(), css);
}

}  // namespace ticker::report

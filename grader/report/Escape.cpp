#include <grader/report/Escape.h>

#include <algorithm>

namespace ticker::report {

std::string escapeHtml(std::string_view text) {
    std::string escaped;
    for (const char c : cleanText(text)) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

std::string escapeCsv(std::string_view text) {
    std::string field = cleanText(text);
    if (!field.empty() && std::string_view{"=+-@\t"}.find(field.front()) != std::string_view::npos)
        field.insert(field.begin(), '\'');
    if (field.find_first_of(",\"\n") == std::string::npos) return field;
    std::string quoted;
    quoted += '"';
    for (const char c : field) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    quoted += '"';
    return quoted;
}

std::string escapeLine(std::string_view text) {
    std::string line = cleanText(text);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
    return line;
}

}  // namespace ticker::report

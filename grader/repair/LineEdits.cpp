#include <grader/base/JsonLines.h>
#include <grader/base/Utf8.h>
#include <grader/repair/LineEdits.h>

#include <algorithm>

namespace ticker::repair {
namespace {

/// The edit without the text that stays the same at both ends.
TextEdit trimmed(std::string_view source, TextEdit edit) {
    while (edit.begin < edit.end && !edit.text.empty() && source[edit.begin] == edit.text.front()) {
        ++edit.begin;
        edit.text.erase(0, 1);
    }
    while (edit.begin < edit.end && !edit.text.empty() &&
           source[edit.end - 1] == edit.text.back()) {
        --edit.end;
        edit.text.pop_back();
    }
    return edit;
}

std::size_t beginOfLine(std::string_view source, std::size_t at) {
    const std::size_t newline = at == 0 ? std::string_view::npos : source.rfind('\n', at - 1);
    return newline == std::string_view::npos ? 0 : newline + 1;
}

std::size_t endOfLine(std::string_view source, std::size_t at) {
    return std::min(source.find('\n', at), source.size());
}

/// Lines as people read them, and as a result file keeps them.
std::string shown(std::string_view lines) {
    if (lines.ends_with('\r')) lines.remove_suffix(1);
    return cleanText(lines);
}

}  // namespace

std::vector<RepairEdit> lineEdits(std::string_view source, const std::vector<TextEdit>& edits) {
    std::vector<RepairEdit> lines;
    std::vector<TextEdit> sorted;
    for (const TextEdit& edit : edits)
        sorted.push_back(trimmed(source, edit));
    std::ranges::sort(sorted, {}, &TextEdit::begin);
    for (std::size_t i = 0; i < sorted.size();) {
        const std::size_t begin = beginOfLine(source, sorted[i].begin);
        std::size_t end = endOfLine(source, std::max(sorted[i].begin, sorted[i].end));
        std::vector<TextEdit> together;
        for (; i < sorted.size() && sorted[i].begin <= end; ++i) {
            together.push_back({sorted[i].begin - begin, sorted[i].end - begin, sorted[i].text});
            end = std::max(end, endOfLine(source, sorted[i].end));
        }
        const std::string_view from = source.substr(begin, end - begin);
        if (auto to = withEdits(from, together)) {
            if (to->find_first_not_of(" \t\r\n") == std::string::npos) to->clear();
            lines.push_back({lineOfByte(source, begin + 1), shown(from), shown(*to)});
        }
    }
    return lines;
}

}  // namespace ticker::repair

#include <grader/report/platforms/CsvFile.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace ticker::report {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Number of bytes of the quoted string at the start of `text`; npos if it is not closed.
std::size_t quotedLength(std::string_view text) {
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '\\') {
            ++i;
        } else if (text[i] == '"') {
            if (i + 1 == text.size() || text[i + 1] != '"') return i + 1;
            ++i;
        }
    }
    return std::string_view::npos;
}

std::size_t fieldLength(std::string_view text) {
    std::size_t start = 0;
    if (text.starts_with('"')) {
        start = quotedLength(text);
        if (start == std::string_view::npos) return start;
    }
    return std::min(text.find_first_of(",\r\n", start), text.size());
}

std::string_view lineEnd(std::string_view text) {
    if (text.starts_with("\r\n")) return text.substr(0, 2);
    return text.substr(0, std::min<std::size_t>(text.size(), 1));
}

int newlinesIn(std::string_view text) {
    return static_cast<int>(std::ranges::count(text, '\n'));
}

}  // namespace

CsvFile::CsvFile(std::string_view text, const std::string& name) {
    if (text.starts_with(kByteOrderMark)) {
        mark_ = kByteOrderMark;
        text.remove_prefix(mark_.size());
    }
    int line = 1;
    while (!text.empty()) {
        Record record;
        record.line = line;
        while (true) {
            const std::size_t length = fieldLength(text);
            if (length == std::string_view::npos)
                throw raytracer::InputError(name, line, "a quote that begins here never ends");
            record.fields.emplace_back(text.substr(0, length));
            line += newlinesIn(record.fields.back());
            text.remove_prefix(length);
            if (!text.starts_with(',')) break;
            text.remove_prefix(1);
        }
        record.end = lineEnd(text);
        line += newlinesIn(record.end);
        text.remove_prefix(record.end.size());
        records_.push_back(std::move(record));
    }
    if (records_.empty()) throw raytracer::InputError(name, 0, "empty; expected a header");
    for (const Record& record : records_)
        if (record.fields.size() != columns())
            throw raytracer::InputError(
                name, record.line,
                fmt::format(
                    "{} fields; the header has {}. Hand in the file as it was downloaded; a "
                    "field that ends in a backslash breaks its row for every reader",
                    record.fields.size(), columns()));
}

std::string CsvFile::value(std::size_t row, std::size_t column) const {
    const std::string& raw = records_.at(row).fields.at(column);
    if (!raw.starts_with('"')) return raw;
    const std::size_t length = quotedLength(raw);
    std::string plain;
    for (std::size_t i = 1; i + 1 < length; ++i) {
        if (raw[i] == '\\' && i + 2 < length)
            plain += raw[i++];
        else if (raw[i] == '"')
            ++i;
        plain += raw[i];
    }
    return plain + raw.substr(length);
}

void CsvFile::set(std::size_t row, std::size_t column, std::string_view value) {
    std::string quoted = "\"";
    for (const char c : value) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    records_.at(row).fields.at(column) = quoted + '"';
}

std::string CsvFile::text() const {
    std::string text = mark_;
    for (const Record& record : records_) {
        for (std::size_t i = 0; i < record.fields.size(); ++i)
            text += (i == 0 ? "" : ",") + record.fields[i];
        text += record.end;
    }
    return text;
}

}  // namespace ticker::report

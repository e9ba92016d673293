#include <grader/tests/support/MoodleImport.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace ticker::tests {
namespace {

// As PHP's fputcsv: quotes around fields with one of these characters; a quote after a backslash
// stays single.
std::string writtenLikePhp(const std::string& field) {
    if (field.find_first_of(" ,\"\\\n\r\t") == std::string::npos) return field;
    std::string text = "\"";
    bool escaped = false;
    for (const char c : field) {
        if (c == '"' && !escaped) text += '"';
        escaped = c == '\\';
        text += c;
    }
    return text + '"';
}

std::string line(const std::vector<std::string>& fields) {
    std::string text;
    for (const std::string& field : fields)
        text += (text.empty() ? "" : ",") + writtenLikePhp(field);
    return text + "\n";
}

/// Reads one field and its separator.
std::string takeField(std::string_view& text) {
    std::string field;
    if (!text.empty() && text.front() == '"') {
        std::size_t i = 1;
        for (; i < text.size(); ++i) {
            if (text[i] == '\\' && i + 1 < text.size()) {
                field += text[i++];
            } else if (text[i] == '"') {
                if (i + 1 >= text.size() || text[i + 1] != '"') break;
                ++i;
            }
            field += text[i];
        }
        text.remove_prefix(std::min(i + 1, text.size()));
    }
    const std::size_t end = std::min(text.find_first_of(",\n"), text.size());
    field += text.substr(0, end);
    text.remove_prefix(end);
    if (field.ends_with('\r')) field.pop_back();
    return field;
}

std::size_t columnOf(const std::vector<std::string>& header, const std::string& name) {
    const auto found = std::ranges::find(header, name);
    if (found == header.end()) throw std::runtime_error("Moodle finds no column " + name);
    return static_cast<std::size_t>(found - header.begin());
}

std::time_t timeOf(const std::string& date) {
    std::tm parts{};
    if (strptime(date.c_str(), "%A, %d %B %Y, %I:%M %p", &parts) == nullptr) return 0;
    return timegm(&parts);
}

constexpr std::string_view kIdentifierWord = "Participant ";

std::string identifierOf(int id) {
    return std::string{kIdentifierWord} + std::to_string(id);
}

/// The number after the word; 0 for an identifier without a number.
int participantOf(const std::string& identifier) {
    const std::size_t begin = std::min(kIdentifierWord.size(), identifier.size());
    return std::atoi(identifier.substr(begin).c_str());
}

/// Places in a row of a worksheet of what Moodle reads.
struct Columns {
    explicit Columns(const std::vector<std::string>& header)
        : identifier(columnOf(header, "Identifier")),
          grade(columnOf(header, "Grade")),
          modified(columnOf(header, "Last modified (grade)")),
          feedback(columnOf(header, "Feedback comments")) {}

    std::size_t identifier;
    std::size_t grade;
    std::size_t modified;
    std::size_t feedback;
};

bool isGrade(const MoodleAssignment& assignment, const std::string& text) {
    if (text.empty()) return false;
    if (!assignment.scale.empty())
        return std::ranges::find(assignment.scale, text) != assignment.scale.end();
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (*end != '\0' || number < 0.0) return false;
    return !(assignment.dropsZeros && number == 0.0);
}

bool isOutOfRange(const MoodleAssignment& assignment, const std::string& grade) {
    return assignment.scale.empty() && std::strtod(grade.c_str(), nullptr) > assignment.maximum;
}

/// Whether Moodle has a later grade than the worksheet. A worksheet's dates have no seconds.
bool isStale(const MoodleRecord& record, const std::string& modified) {
    constexpr std::time_t kMinute = 60;
    return record.gradedAt > timeOf(modified) + kMinute;
}

MoodleAssignment::Row outcomeOf(const MoodleAssignment& assignment, const MoodleRecord& record,
                                const std::string& grade, bool stale) {
    using Row = MoodleAssignment::Row;
    if (!isGrade(assignment, grade)) return Row::noGrade;
    if (grade == record.grade) return Row::sameGrade;
    if (stale) return Row::stale;
    if (record.locked) return Row::locked;
    if (isOutOfRange(assignment, grade)) return Row::outOfRange;
    return Row::taken;
}

}  // namespace

std::vector<std::vector<std::string>> readLikePhp(std::string_view csv) {
    if (csv.starts_with("\xEF\xBB\xBF")) csv.remove_prefix(3);
    std::vector<std::vector<std::string>> records;
    while (!csv.empty()) {
        std::vector<std::string> record{takeField(csv)};
        while (csv.starts_with(',')) {
            csv.remove_prefix(1);
            record.push_back(takeField(csv));
        }
        if (csv.starts_with('\n')) csv.remove_prefix(1);
        records.push_back(std::move(record));
    }
    return records;
}

std::string moodleDate(std::time_t when) {
    if (when == 0) return "-";
    std::tm parts{};
    gmtime_r(&when, &parts);
    std::array<char, 80> text{};
    std::strftime(text.data(), text.size(), "%A, %e %B %Y, %I:%M %p", &parts);
    return text.data();
}

std::string MoodleAssignment::worksheet(const std::vector<MoodleStudent>& students) const {
    std::vector<std::string> header{"Identifier"};
    if (!blind) header.insert(header.end(), {"Full name", "Email address"});
    header.emplace_back("Status");
    if (teams) header.emplace_back("Group");
    header.insert(header.end(), {"Grade", scale.empty() ? "Maximum Grade" : "Scale",
                                 "Grade can be changed", "Last modified (submission)",
                                 "Online text", "Last modified (grade)", "Feedback comments"});
    std::string text = (byteOrderMark ? "\xEF\xBB\xBF" : "") + line(header);
    for (const MoodleStudent& student : students) {
        const auto known = records.find(student.id);
        const MoodleRecord record = known == records.end() ? MoodleRecord{} : known->second;
        std::vector<std::string> row{identifierOf(student.id)};
        if (!blind) row.insert(row.end(), {student.fullName, "x@example.org"});
        row.emplace_back("Submitted for grading - ");
        if (teams) row.push_back(student.group);
        std::ostringstream most;
        most << maximum << ".00";
        row.insert(row.end(), {record.grade, scale.empty() ? most.str() : "A scale",
                               record.locked ? "No" : "Yes", moodleDate(1'700'000'000),
                               student.onlineText, moodleDate(record.gradedAt), record.feedback});
        text += line(row);
    }
    return text;
}

std::map<std::string, MoodleAssignment::Row> MoodleAssignment::upload(std::string_view csv,
                                                                      std::time_t now) {
    const auto rows = readLikePhp(csv);
    const Columns columns{rows.at(0)};
    std::map<std::string, Row> fared;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const std::string& identifier = rows[i].at(columns.identifier);
        const auto known = records.find(participantOf(identifier));
        if (known == records.end()) {
            fared[identifier] = Row::unknownPerson;
            continue;
        }
        MoodleRecord& record = known->second;
        const std::string& grade = rows[i].at(columns.grade);
        const bool stale = isStale(record, rows[i].at(columns.modified));
        const Row outcome = outcomeOf(*this, record, grade, stale);
        fared[identifier] = outcome;
        if (outcome == Row::taken) {
            record.grade = grade;
            record.gradedAt = now;
        }
        // Moodle overlooks a column of comments whose index is 0.
        if (!stale && columns.feedback > 0) record.feedback = rows[i].at(columns.feedback);
    }
    return fared;
}

bool MoodleAssignment::uploadFeedback(const std::string& path) {
    std::vector<std::string> parts;
    std::istringstream stream{path};
    for (std::string part; std::getline(stream, part, '/');)
        parts.push_back(part);
    if (parts.empty() || parts.back().starts_with('.') || parts.back().starts_with('~'))
        return false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::vector<std::string> info;
        std::istringstream words{parts[i]};
        for (std::string word; info.size() < 4 && std::getline(words, word, '_');)
            info.push_back(word);
        if (info.size() < 4 || (wantsFiveParts && !parts[i].ends_with("_file_"))) continue;
        if (info[1].empty() || info[1].find_first_not_of("0123456789") != std::string::npos)
            continue;
        const auto known = records.find(std::atoi(info[1].c_str()));
        if (known == records.end() || info[2] != "assignsubmission" || info[3] != "file") continue;
        std::string rest;
        for (std::size_t j = i + 1; j < parts.size(); ++j)
            rest += (rest.empty() ? "" : "/") + parts[j];
        known->second.files.push_back(rest);
        return true;
    }
    return false;
}

}  // namespace ticker::tests

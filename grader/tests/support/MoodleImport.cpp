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

std::string identifierOf(int id) {
    return "Participant " + std::to_string(id);
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
    const std::size_t id = columnOf(rows.at(0), "Identifier");
    const std::size_t grade = columnOf(rows.at(0), "Grade");
    const std::size_t modified = columnOf(rows.at(0), "Last modified (grade)");
    const std::size_t feedback = columnOf(rows.at(0), "Feedback comments");
    std::map<std::string, Row> fared;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const std::string& name = rows[i].at(id);
        Row& row = fared[name];
        const int participant =
            std::atoi(name.substr(std::min<std::size_t>(12, name.size())).c_str());
        const auto known = records.find(participant);
        if (known == records.end()) {
            row = Row::unknownPerson;
            continue;
        }
        MoodleRecord& record = known->second;
        const std::string& wanted = rows[i].at(grade);
        const bool isWord = std::ranges::find(scale, wanted) != scale.end();
        const bool stale = record.gradedAt > timeOf(rows[i].at(modified)) + 60;
        char* end = nullptr;
        const double number = std::strtod(wanted.c_str(), &end);
        const bool isDropped = dropsZeros && scale.empty() && number == 0.0;
        if (wanted.empty() || isDropped || (scale.empty() ? *end != '\0' || number < 0.0 : !isWord))
            row = Row::noGrade;
        else if (wanted == record.grade)
            row = Row::sameGrade;
        else if (stale)
            row = Row::stale;
        else if (record.locked)
            row = Row::locked;
        else if (scale.empty() && number > maximum)
            row = Row::outOfRange;
        else
            row = Row::taken;
        if (row == Row::taken) {
            record.grade = wanted;
            record.gradedAt = now;
        }
        // Moodle overlooks a column of comments whose index is 0.
        if (!stale && feedback > 0) record.feedback = rows[i].at(feedback);
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

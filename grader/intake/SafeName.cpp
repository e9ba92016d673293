#include <grader/intake/SafeName.h>

#include <grader/base/Utf8.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace ticker::intake {
namespace {

// Cuts a name to that many bytes at the end of a character; keeps the "_123" at the end of a Moodle
// name.
std::string shortened(std::string name, std::size_t longest) {
    if (name.size() <= longest) return name;
    const std::size_t mark = name.find_last_not_of("0123456789");
    std::string id = mark != std::string::npos && name[mark] == '_' ? name.substr(mark) : "";
    if (id.size() > longest / 2) id.clear();
    name.resize(longest - id.size());
    while (!name.empty() && (static_cast<unsigned char>(name.back()) & 0xC0U) == 0x80U)
        name.pop_back();
    if (!name.empty() && static_cast<unsigned char>(name.back()) >= 0xC0U) name.pop_back();
    return name + id;
}

// Files that ticker and grader/integrations write into OUT beside the submissions' folders, in
// lower case, since some file systems ignore case. Names that begin with a dot are never
// submissions.
constexpr std::array kFilesOfOut{
    "canvas-comments.zip",  "canvas-gradebook.csv", "index.html",     "moodle-feedback.zip",
    "moodle-worksheet.csv", "results.json",         "results.sqlite", "results.sqlite-journal",
    "results.sqlite-shm",   "results.sqlite-wal",   "seed",           "similar.html",
    "similar.json",         "summary.csv"};

bool isOfOut(const std::string& name) {
    const std::string small = lowerCase(name);
    const bool isLogOfATask = small.starts_with("task-") && small.ends_with(".log");
    return isLogOfATask || std::ranges::find(kFilesOfOut, small) != kFilesOfOut.end();
}

}  // namespace

std::string safeName(const std::string& wanted) {
    constexpr std::size_t kLongest = 100;
    std::string name;
    for (const char c : asUtf8(wanted)) {
        const auto byte = static_cast<unsigned char>(c);
        const bool harmful = byte < 0x20 || byte == 0x7F ||
                             std::string_view{"/\\:*?\"<>|"}.find(c) != std::string_view::npos;
        name += harmful ? '_' : c;
    }
    name = shortened(std::move(name), kLongest);
    while (name.starts_with('.') || name.starts_with('-') || name.starts_with(' '))
        name.erase(0, 1);
    if (name.empty()) return "submission";
    return isOfOut(name) ? name + "-submission" : name;
}

std::string uniqueName(const std::string& name, std::set<std::string>& taken) {
    std::string result = name;
    for (int i = 2; !taken.insert(result).second; ++i)
        result = fmt::format("{}-{}", name, i);
    return result;
}

}  // namespace ticker::intake

#include <grader/base/Utf8.h>
#include <grader/intake/Contents.h>
#include <grader/result/GeneralFindings.h>

#include <raytracer/base/Text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <system_error>
#include <utility>

namespace ticker::intake {
namespace {

std::string_view lastComponent(std::string_view path) {
    return path.substr(path.find_last_of('/') + 1);
}

void dropEnd(std::string& text, std::string_view end) {
    if (text.ends_with(end)) text.resize(text.size() - end.size());
}

void dropSpaces(std::string& text) {
    while (text.ends_with(' '))
        text.pop_back();
    text.erase(0, text.find_first_not_of(' '));
}

// "renderer (1)", "renderer-2", "renderer - copy" -> "renderer"
void dropDecoration(std::string& stem) {
    dropEnd(stem, "copy");
    dropSpaces(stem);
    dropEnd(stem, ")");
    while (!stem.empty() && std::isdigit(static_cast<unsigned char>(stem.back())) != 0)
        stem.pop_back();
    while (!stem.empty() && std::string_view{" (-_"}.find(stem.back()) != std::string_view::npos)
        stem.pop_back();
}

// True for files of the framework that have the name of a part. They come with a whole project.
bool isOfTheKit(std::string_view path, const Exercise& exercise) {
    return std::ranges::any_of(exercise.frameworkFiles, [&](const std::string& own) {
        return path == own || (path.ends_with(own) && path[path.size() - own.size() - 1] == '/');
    });
}

}  // namespace

std::optional<std::string> partOf(std::string_view path, const Exercise& exercise) {
    if (isOfTheKit(path, exercise)) return std::nullopt;
    std::string name = lowerCase(std::string{lastComponent(path)});
    dropSpaces(name);
    dropEnd(name, ".txt");
    const std::size_t dot = name.find_last_of('.');
    if (dot == std::string::npos) return std::nullopt;
    std::string extension = name.substr(dot);
    if (extension == ".cc" || extension == ".cxx") extension = ".cpp";
    std::string stem = name.substr(0, dot);
    dropDecoration(stem);
    dropSpaces(stem);
    for (const std::string& part : exercise.parts())
        if (stem + extension == lowerCase(part)) return part;
    return std::nullopt;
}

bool isArchive(std::string_view path) {
    const std::string name = lowerCase(std::string{lastComponent(path)});
    return name.ends_with(".zip") || name.ends_with(".tar") || name.ends_with(".tar.gz") ||
           name.ends_with(".tgz");
}

bool isLitter(std::string_view path) {
    std::size_t begin = 0;
    while (begin <= path.size()) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        const std::string_view component = path.substr(begin, end - begin);
        if (component == "__MACOSX" || component == ".git" || component.starts_with("._"))
            return true;
        begin = end + 1;
    }
    return false;
}

Finding refusal(const FindingText& text, std::string message, std::string hint) {
    Finding finding;
    finding.id = text.id;
    finding.severity = Severity::fail;
    finding.message = std::move(message);
    finding.hint = std::move(hint);
    finding.section = "Test and submit";
    return finding;
}

std::uint64_t byteLimitOf(std::string_view part, const IntakeLimits& limits) {
    return part == kScreenshotPart ? limits.screenshotBytes : limits.sourceBytes;
}

Finding tooLarge(std::string_view path, std::uint64_t limit, const Exercise& exercise) {
    return refusal(
        kIntakeTooLarge,
        fmt::format("{} is larger than {} KiB.", raytracer::inQuotes(path), limit >> 10U),
        exercise.hasScreenshot()
            ? fmt::format("Hand in the file that you wrote, and the picture as {} writes it.",
                          exercise.name)
            : "Hand in the file that you wrote.");
}

raytracer::InputError unreadable(const std::filesystem::path& path, int error) {
    return {asPlainLine(path.string()), 0,
            fmt::format("cannot be read: {}; make it readable, then grade again",
                        std::generic_category().message(error))};
}

}  // namespace ticker::intake

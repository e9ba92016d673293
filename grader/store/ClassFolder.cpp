#include <grader/store/ClassFolder.h>

#include <grader/base/UtcText.h>
#include <grader/base/Utf8.h>
#include <grader/result/ProvenLine.h>
#include <grader/result/ResultJson.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <system_error>

namespace ticker::store {
namespace fs = std::filesystem;
namespace {

constexpr const char* kResult = "result.json";

std::vector<std::string> foldersWithResults(const fs::path& out) {
    std::error_code error;
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator{out, error})
        if (fs::is_regular_file(entry.path() / kResult, error))
            names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

bool hasResult(const fs::path& out, const std::string& submission) {
    std::error_code error;
    return fs::is_regular_file(resultFile(out, submission), error);
}

// The folder gives the name; a moved result.json contains another one.
SubmissionResult readNamed(const fs::path& out, const std::string& submission) {
    const fs::path file = resultFile(out, submission);
    SubmissionResult result = readResultJson(file);
    if (result.submission != cleanText(submission))
        throw raytracer::InputError(
            file.string(), 0,
            fmt::format("is the result of \"{}\", not of its folder", result.submission));
    result.submission = submission;
    return result;
}

raytracer::InputError noResults(const fs::path& out) {
    const std::size_t beside = foldersWithResults(out).size();
    return {out.string(), 0,
            beside == 0 ? "holds no results; expected the OUT of ticker grade"
                        : fmt::format("its results.sqlite is empty, but {} lie beside it; \"ticker "
                                      "collect OUT\" takes them in",
                                      beside)};
}

}  // namespace

fs::path resultFile(const fs::path& out, const std::string& submission) {
    return out / submission / kResult;
}

bool isKnown(const std::optional<ResultRow>& row, const SubmissionResult& result) {
    return row && row->verdict == result.verdict && row->inputs == result.inputs &&
           row->toolVersion == result.toolVersion && row->proven == provenLines(result);
}

std::optional<SubmissionResult> readWholeResult(const fs::path& out,
                                                const std::string& submission) {
    if (!hasResult(out, submission)) return std::nullopt;
    try {
        return readNamed(out, submission);
    } catch (const raytracer::InputError&) {
        return std::nullopt;
    }
}

std::vector<ClassEntry> readClass(const fs::path& out, Unreadable unreadable) {
    std::vector<std::string> names;
    std::map<std::string, Decision> decisions;
    if (Store::isIn(out)) {
        const Store store{out};
        for (const ResultRow& row : store.results())
            if (hasResult(out, row.submission)) names.push_back(row.submission);
        for (Decision& decision : store.decisions())
            decisions[decision.submission] = std::move(decision);
    } else {
        names = foldersWithResults(out);
    }
    if (names.empty()) throw noResults(out);
    std::vector<ClassEntry> entries;
    for (const std::string& name : names) {
        auto result =
            unreadable == Unreadable::leaveOut ? readWholeResult(out, name) : readNamed(out, name);
        if (!result) continue;
        ClassEntry entry{std::move(*result), {}};
        if (const auto found = decisions.find(name); found != decisions.end())
            entry.decision = std::move(found->second);
        entries.push_back(std::move(entry));
    }
    return entries;
}

void expectResults(const fs::path& out, const Store& store) {
    if (store.results().empty()) throw noResults(out);
}

Collected collect(const fs::path& out, Store& store) {
    Collected collected;
    for (const std::string& name : foldersWithResults(out)) {
        try {
            const SubmissionResult result = readNamed(out, name);
            if (isKnown(store.find(name), result)) {
                ++collected.known;
                continue;
            }
            store.put(result, utcNow());
            ++collected.taken;
        } catch (const raytracer::InputError& problem) {
            collected.unreadable.emplace_back(problem.what());
        }
    }
    return collected;
}

std::string utcNow() {
    return utcText(std::time(nullptr));
}

}  // namespace ticker::store

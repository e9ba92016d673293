#include <grader/cli/ClassPaths.h>
#include <grader/intake/SafeName.h>
#include <grader/intake/Skipped.h>
#include <grader/report/Escape.h>

#include <grader/exercise/Exercise.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

namespace ticker::cli {
namespace {

std::vector<intake::Located> wholePath(const std::string& path, const std::string& out) {
    const std::filesystem::path whole = std::filesystem::absolute(path).lexically_normal();
    const std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename();
    return {{name.empty() ? "submission" : name, whole, "", out}};
}

// Name of another exercise, whose files a submission contains; empty if it contains none, or if the
// submission cannot be read, also for want of memory, which its grading reports later.
std::string otherExerciseOf(const intake::Located& located, const intake::IntakeLimits& limits) {
    try {
        return intake::readSubmission(located, limits).otherExercise;
    } catch (const std::exception&) {
        return "";
    }
}

/// Names of the submissions that contain files of `other` instead of the wanted exercise's.
std::vector<std::string> broughtFor(const Exercise& other, const std::vector<intake::Located>& all,
                                    const intake::IntakeLimits& limits) {
    std::vector<std::string> names;
    for (const intake::Located& located : all)
        if (otherExerciseOf(located, limits) == other.name) names.push_back(located.name);
    return names;
}

// The first submission of a name keeps it. The others get new names, which no submission has.
void makeUnique(std::vector<intake::Located>& all) {
    std::set<std::string> taken;
    std::vector<intake::Located*> repeated;
    for (intake::Located& located : all)
        if (!taken.insert(located.name).second) repeated.push_back(&located);
    for (intake::Located* located : repeated)
        located->name = intake::uniqueName(located->name, taken);
}

std::vector<intake::Located> submissionsIn(const std::string& path, const ClassPaths& from) {
    return from.single ? wholePath(path, from.out)
                       : intake::findSubmissions(path, *from.exercise, from.out);
}

}  // namespace

std::vector<intake::Located> locate(const ClassPaths& from) {
    std::vector<intake::Located> all;
    for (const std::string& path : from.paths)
        std::ranges::move(submissionsIn(path, from), std::back_inserter(all));
    makeUnique(all);
    if (all.empty())
        throw raytracer::InputError(from.paths.front(), 0,
                                    "no submission here; expected " +
                                        enumerated(from.exercise->files(), "or") +
                                        " in a folder, a zip, or a folder of such");
    return all;
}

void expectOneExercise(const ClassPaths& from, const std::vector<intake::Located>& submissions,
                       std::span<const Exercise> others) {
    if (from.single) return;
    const std::string& wanted = from.exercise->name;
    for (const Exercise& other : others) {
        if (other.name == wanted) continue;
        // Where no file is of the wanted exercise, the whole class looks like one submission.
        const std::vector<intake::Located> all =
            submissions.size() > 1 ? submissions : locate({from.paths, false, &other, from.out});
        const std::vector<std::string> names =
            broughtFor(other, all, {.exercise = from.exercise, .others = others});
        if (names.empty() || all.size() < 2) continue;
        throw raytracer::InputError(
            "", 0,
            names.size() == all.size()
                ? fmt::format(
                      "these are submissions to {0}, not to {1}; --exercise {0} grades them",
                      other.name, wanted)
                : fmt::format("{} of {} submissions bring files of {}, not of {}: \"{}\"{}; grade "
                              "each exercise's submissions in a folder of their own",
                              names.size(), all.size(), other.name, wanted,
                              report::escapeLine(names.front()), names.size() > 1 ? ", ..." : ""));
    }
}

std::vector<intake::Located> shareOf(std::vector<intake::Located> all, const std::string& share) {
    const std::string_view words = share;
    const std::size_t slash = std::min(words.find('/'), words.size());
    const auto part = raytracer::parseCount(words.substr(0, slash));
    const auto parts = raytracer::parseCount(words.substr(std::min(slash + 1, words.size())));
    if (!part || !parts || *part < 1 || *part > *parts)
        throw raytracer::InputError("--share " + share, 0, "expected I/N with 1 <= I <= N");
    std::vector<intake::Located> mine;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (i % *parts == *part - 1) mine.push_back(std::move(all[i]));
    return mine;
}

std::string skippedLine(const ClassPaths& from) {
    if (from.single) return {};
    std::vector<intake::Skipped> all;
    for (const std::string& path : from.paths)
        std::ranges::move(intake::findSkipped(path, submissionsIn(path, from), from.out),
                          std::back_inserter(all));
    if (all.empty()) return {};
    constexpr std::size_t kMostNames = 10;
    std::string line = "skipped:";
    for (std::size_t i = 0; i < std::min(all.size(), kMostNames); ++i)
        line += fmt::format("{} {} ({})", i == 0 ? "" : ",", report::escapeLine(all[i].name),
                            all[i].why);
    if (all.size() > kMostNames) line += fmt::format(" and {} more", all.size() - kMostNames);
    return line;
}

}  // namespace ticker::cli

#include <grader/base/Utf8.h>
#include <grader/intake/Intake.h>
#include <grader/intake/OtherExercise.h>
#include <grader/result/GeneralFindings.h>

#include <raytracer/base/Text.h>

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

namespace ticker::intake {
namespace {

// A source is text with one byte for each ASCII character: UTF-8, or an older encoding that differs
// in comments only.
bool isText(std::string_view bytes) {
    const auto begins = [&](std::string_view mark) { return bytes.starts_with(mark); };
    if (begins("\xFF\xFE") || begins("\xFE\xFF")) return false;
    return bytes.find('\0') == std::string_view::npos;
}

Finding notText(std::string_view path) {
    return refusal(kIntakeNotText,
                   fmt::format("{} is no plain text: it is binary, or saved as UTF-16.",
                               raytracer::inQuotes(path)),
                   "Save the file as UTF-8 and hand it in again.");
}

Finding ambiguous(const std::string& part, const std::vector<const Candidate*>& candidates) {
    std::string paths;
    for (const Candidate* candidate : candidates)
        paths += (paths.empty() ? "" : ", ") + raytracer::inQuotes(candidate->path);
    return refusal(kIntakeAmbiguous,
                   fmt::format("More than one file may be {}, and they differ: {}.", part, paths),
                   "Hand in one of them only; the tool never chooses.");
}

// A file name that was probably meant to be `part`.
std::optional<std::string> nearMiss(std::string_view part, const Contents& contents) {
    const std::array known{part};
    for (const std::string& path : contents.others) {
        if (isLitter(path)) continue;
        const std::string_view name = std::string_view{path}.substr(path.find_last_of('/') + 1);
        if (raytracer::nearestName(name, known)) return path;
    }
    return std::nullopt;
}

bool isSource(const Candidate& candidate) {
    return candidate.part != kScreenshotPart;
}

// Opens a zip beside the picture or alone. If source files lie beside it, a zip is ignored: it is
// an older state, or a copy. After a refusal nothing more is opened.
void openArchives(Contents& contents, const IntakeLimits& limits) {
    const bool hasSource = std::ranges::any_of(contents.candidates, isSource);
    for (const Packed& packed : std::exchange(contents.archives, {})) {
        if (hasSource || !contents.refusals.empty()) {
            contents.others.push_back(asUtf8(packed.path));
            continue;
        }
        Contents inner = readArchive(packed, limits, contents.unpacked);
        contents.unpacked = inner.unpacked;
        for (Candidate& candidate : inner.candidates) {
            candidate.path.insert(0, packed.path + "/");
            contents.candidates.push_back(std::move(candidate));
        }
        for (const Packed& deeper : inner.archives)
            inner.others.push_back(asUtf8(deeper.path));
        for (const std::string& other : inner.others)
            contents.others.push_back(asUtf8(packed.path) + "/" + other);
        std::ranges::move(inner.refusals, std::back_inserter(contents.refusals));
    }
}

/// Builds a submission from the contents.
class Assembly {
public:
    Assembly(std::string name, Contents contents, const IntakeLimits& limits)
        : exercise_(*limits.exercise),
          contents_(std::move(contents)),
          other_(otherExercise(contents_, exercise_, limits.others)) {
        submission_.name = std::move(name);
    }

    [[nodiscard]] Submission take() {
        for (Finding& finding : contents_.refusals)
            submission_.findings.push_back({std::nullopt, std::move(finding)});
        if (other_ != nullptr) {
            submission_.otherExercise = other_->name;
            submission_.findings.push_back({std::nullopt, belongsElsewhere(*other_, exercise_)});
        }
        if (submission_.findings.empty()) {
            for (const std::string& part : exercise_.parts())
                choose(part);
            reportMissing();
        }
        for (const std::string& other : contents_.others)
            submission_.ignored.push_back(asPlainLine(other));
        return std::move(submission_);
    }

private:
    void choose(const std::string& part) {
        std::vector<const Candidate*> candidates;
        for (const Candidate& candidate : contents_.candidates)
            if (candidate.part == part) candidates.push_back(&candidate);
        if (candidates.empty()) return;
        const Candidate& first = *candidates.front();
        const bool allEqual = std::ranges::all_of(candidates, [&](const Candidate* other) {
            return other->bytes == first.bytes && !other->refusal;
        });
        if (candidates.size() > 1 && !allEqual)
            submission_.findings.push_back({part, ambiguous(part, candidates)});
        else if (first.refusal)
            submission_.findings.push_back({part, *first.refusal});
        else if (part != kScreenshotPart && !isText(first.bytes))
            submission_.findings.push_back({part, notText(first.path)});
        else
            accept(part, candidates);
    }

    void accept(const std::string& part, const std::vector<const Candidate*>& candidates) {
        submission_.parts[part] = candidates.front()->bytes;
        for (std::size_t i = 1; i < candidates.size(); ++i)
            contents_.others.push_back(asUtf8(candidates[i]->path));
    }

    [[nodiscard]] bool isMissing(std::string_view part) const {
        return !submission_.part(part) && submission_.refusalOf(part) == nullptr;
    }

    // One source is enough. A missing one is reported only if a similar name exists, or if there is
    // no source at all.
    void reportMissing() {
        const std::vector<std::string> files = exercise_.files();
        const bool noSource =
            std::ranges::all_of(files, [&](const std::string& file) { return isMissing(file); });
        bool hinted = false;
        for (const std::string& part : exercise_.parts()) {
            const auto near = isMissing(part) ? nearMiss(part, contents_) : std::nullopt;
            if (!near) continue;
            hinted = hinted || part != kScreenshotPart;
            Finding finding = refusal(
                kIntakeMissingFile, fmt::format("There is no {}.", part),
                fmt::format("Did you mean {}? Rename it to {}.", raytracer::inQuotes(*near), part));
            submission_.findings.push_back({part, std::move(finding)});
        }
        if (noSource && !hinted)
            submission_.findings.push_back(
                {std::nullopt, refusal(kIntakeMissingFile,
                                       (files.size() > 1 ? "There is neither " : "There is no ") +
                                           enumerated(files, "nor") + ".",
                                       whatToHandIn())});
    }

    [[nodiscard]] std::string whatToHandIn() const {
        const std::string sources = exercise_.options.size() > 1
                                        ? "the file of the option that you chose"
                                        : enumerated(exercise_.files(), "and");
        return fmt::format("Hand in {}{}.", sources,
                           exercise_.hasScreenshot() ? ", and screenshot.png" : "");
    }

    const Exercise& exercise_;
    Contents contents_;
    const Exercise* other_;  ///< null: these files are of `exercise_`, or of none
    Submission submission_;
};

}  // namespace

Submission readSubmission(const Located& located, const IntakeLimits& limits) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(located.path, error);
    if (error) throw unreadable(located.path, error.value());
    Contents contents = std::filesystem::is_directory(status)
                            ? readFolder(located.path, limits, located.owner, located.out)
                            : readArchive(located.path, limits, located.owner);
    openArchives(contents, limits);
    return Assembly{located.name, std::move(contents), limits}.take();
}

}  // namespace ticker::intake

#include <grader/report/platforms/MoodleWorksheet.h>

#include <grader/base/Utf8.h>
#include <grader/report/Escape.h>
#include <grader/report/platforms/CsvFile.h>
#include <grader/report/platforms/MoodleColumns.h>
#include <grader/report/platforms/MoodleFeedback.h>
#include <grader/report/platforms/SubmissionId.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <set>

namespace ticker::report {
namespace {

std::string nameOf(const std::string& submission) {
    const std::string id = idOf(submission);
    return id.empty() ? submission : submission.substr(0, submission.size() - id.size() - 1);
}

/// A team's name as in the names of the export's files: Moodle drops some characters, and file
/// systems and intake replace others.
std::string inFileNames(std::string_view name) {
    std::string kept;
    for (const char c : name)
        if (std::string_view{"&<>\"`|':\\/"}.find(c) == std::string_view::npos)
            kept += std::string_view{"_?*"}.find(c) == std::string_view::npos ? c : ' ';
    return kept;
}

/// What is left of a team's name whichever punctuation was dropped on the way.
std::string withoutPunctuation(std::string_view name) {
    std::string letters;
    for (const char c : name)
        if (const auto byte = static_cast<unsigned char>(c);
            byte >= 0x80 || std::isalnum(byte) != 0)
            letters += c;
    return letters;
}

/// Finds the submission of a row. A submission that fits several rows gets none of them: a wrong
/// mark is worse than an empty row.
class Finder {
public:
    /// @param teams  All of the worksheet; empty where it has persons.
    Finder(const std::vector<StudentView>& views, const std::set<std::string>& teams) {
        if (!teams.empty()) {
            pairUp(views, teams, inFileNames);
            pairUp(views, teams, withoutPunctuation);
            return;
        }
        for (const auto& [id, found] : viewsById(views))
            if (found.size() == 1)
                views_[id] = found.front();
            else
                doubtful_.insert(found.begin(), found.end());
    }

    /// @param name  A team's name or a person's id.
    [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const {
        const auto found = views_.find(name);
        if (found == views_.end()) return std::nullopt;
        return found->second;
    }
    [[nodiscard]] bool isDoubtful(std::size_t view) const { return doubtful_.contains(view); }

private:
    /// Pairs a team and a submission where these two alone have one form of their names. The number
    /// in a submission's name says nothing: it is the team's, the worksheet has the persons'.
    void pairUp(const std::vector<StudentView>& views, const std::set<std::string>& teams,
                std::string (*form)(std::string_view)) {
        std::map<std::string, std::set<std::string>> teamsByForm;
        for (const std::string& team : teams)
            teamsByForm[form(team)].insert(team);
        std::map<std::string, std::vector<std::size_t>> viewsByForm;
        for (std::size_t i = 0; i < views.size(); ++i)
            viewsByForm[form(nameOf(views[i].result().submission))].push_back(i);
        for (const auto& [name, found] : viewsByForm) {
            const auto wanted = teamsByForm.find(name);
            if (name.empty() || wanted == teamsByForm.end()) continue;
            if (found.size() == 1 && wanted->second.size() == 1)
                pair(*wanted->second.begin(), found.front());
            else
                for (const std::size_t view : found)
                    if (!paired_.contains(view)) doubtful_.insert(view);
        }
    }

    void pair(const std::string& team, std::size_t view) {
        if (paired_.insert(view).second) views_[team] = view;
    }

    std::map<std::string, std::size_t> views_;  // by what `find` takes
    std::set<std::size_t> paired_;              // with a team
    std::set<std::size_t> doubtful_;
};

class Filler {
public:
    Filler(CsvFile file, std::string name, const std::vector<StudentView>& views,
           const std::optional<ScaleWords>& scale)
        : file_(std::move(file)),
          name_(std::move(name)),
          columns_(moodleColumns(file_, name_)),
          views_(views),
          scale_(scale) {
        if (columns_.scale && !scale_)
            throw raytracer::InputError(
                name_, 1, "this assignment is graded by a scale; say its words with --scale");
    }

    MoodleGrades fill() {
        const Finder finder{views_, teams()};
        for (std::size_t row = 1; row < file_.rows(); ++row) {
            const std::string id = digitsAtEnd(file_.value(row, columns_.id));
            const auto view = finder.find(textAt(row, columns_.group).value_or(id));
            if (!view) continue;
            used_.insert(*view);
            if (const std::string why = whyNot(row, views_[*view].result()); !why.empty())
                grades_.remarks.push_back(fmt::format(
                    "{}: left as it is, {}", escapeLine(views_[*view].result().submission), why));
            else
                grade(row, id, *view);
        }
        for (std::size_t i = 0; i < views_.size(); ++i)
            if (!used_.contains(i))
                grades_.remarks.push_back(
                    fmt::format("{}: {}", escapeLine(views_[i].result().submission),
                                finder.isDoubtful(i) ? doubt() : "no row of the worksheet fits"));
        grades_.worksheet = file_.text();
        if (std::string warning = dateWarning(file_, columns_); !warning.empty())
            grades_.warnings.push_back(std::move(warning));
        if (!columns_.scale && zeros_ > 0) grades_.warnings.push_back(zerosWarning());
        return std::move(grades_);
    }

private:
    [[nodiscard]] std::set<std::string> teams() const {
        std::set<std::string> teams;
        for (std::size_t row = 1; columns_.group && row < file_.rows(); ++row)
            teams.insert(file_.value(row, *columns_.group));
        return teams;
    }

    [[nodiscard]] std::string_view doubt() const {
        return columns_.group ? "left out, its name fits several teams, or other submissions have "
                                "it, too: enter the mark by hand"
                              : kSharedId;
    }

    [[nodiscard]] std::string zerosWarning() const {
        return fmt::format(
            "{} of the marks {} 0, which the newest Moodle drops: look for \"Set grade ... to "
            "0.00\" "
            "in its preview. If that is missing, use a scale (--scale) instead of points",
            zeros_, zeros_ == 1 ? "is" : "are");
    }

    [[nodiscard]] std::optional<std::string> textAt(
        std::size_t row, const std::optional<std::size_t>& column) const {
        if (!column) return std::nullopt;
        return file_.value(row, *column);
    }

    [[nodiscard]] std::string whyNot(std::size_t row, const SubmissionResult& result) const {
        if (result.verdict == Verdict::needsReview) return "a person has to decide";
        if (result.verdict == Verdict::notGraded) return "it was not graded";
        if (lowerCase(textAt(row, columns_.mayChange).value_or("")) == "no")
            return "Moodle locked it";
        return "";
    }

    [[nodiscard]] std::string gradeOf(std::size_t row, const SubmissionResult& result) const {
        if (columns_.scale)
            return result.verdict == Verdict::awarded ? scale_->awarded : scale_->notAwarded;
        double maximum = result.maxScore;
        if (const auto text = textAt(row, columns_.maximum)) {
            const auto [end, error] =
                std::from_chars(text->data(), text->data() + text->size(), maximum);
            if (error != std::errc{} || !(maximum > 0.0))
                throw raytracer::InputError(
                    name_, 0, fmt::format("\"{}\" is no maximum grade", escapeLine(*text)));
        }
        const double share = result.maxScore > 0.0 ? result.score / result.maxScore : 0.0;
        return fmt::format("{:.2f}", share * maximum);
    }

    void grade(std::size_t row, const std::string& id, std::size_t view) {
        const SubmissionResult& result = views_[view].result();
        file_.set(row, columns_.grade, gradeOf(row, result));
        if (result.score <= 0.0) ++zeros_;
        if (columns_.feedback) file_.set(row, *columns_.feedback, moodleFeedback(views_[view]));
        grades_.graded.push_back({id, view});
    }

    CsvFile file_;
    std::string name_;
    MoodleColumns columns_;
    const std::vector<StudentView>& views_;
    const std::optional<ScaleWords>& scale_;
    std::set<std::size_t> used_;
    std::size_t zeros_ = 0;
    MoodleGrades grades_;
};

}  // namespace

MoodleGrades fillMoodleWorksheet(std::string_view worksheet, const std::string& name,
                                 const std::vector<StudentView>& views,
                                 const std::optional<ScaleWords>& scale) {
    refuseIfResaved(worksheet, name);
    return Filler{CsvFile{worksheet, name}, name, views, scale}.fill();
}

std::vector<NamedText> moodleFeedbackFiles(const std::vector<MoodleParticipant>& graded,
                                           const std::vector<StudentView>& views,
                                           const std::vector<std::string>& pages) {
    std::vector<NamedText> files;
    for (const MoodleParticipant& participant : graded) {
        // Moodle reads the text between the first two underscores as the id, and before 4.1.10
        // requires an underscore at the end.
        std::string name = nameOf(views.at(participant.view).result().submission);
        std::ranges::replace(name, '_', ' ');
        std::ranges::replace(name, '/', ' ');
        files.push_back({fmt::format("{}_{}_assignsubmission_file_/student.html", cleanText(name),
                                     participant.id),
                         pages.at(participant.view)});
    }
    return files;
}

}  // namespace ticker::report

#include <grader/similar/Matcher.h>
#include <grader/similar/PlainLines.h>
#include <grader/similar/Similar.h>

#include <algorithm>
#include <map>
#include <span>
#include <utility>

namespace ticker::similar {
namespace {

using Lines = std::vector<std::string>;

std::string joined(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line + "\n";
    return text;
}

/// The characters of a plain line that are neither space nor preprocessor.
std::size_t codeIn(const std::string& line) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos || line[begin] == '#') return 0;
    return static_cast<std::size_t>(std::ranges::count_if(line, [](char c) { return c != ' '; }));
}

void blank(Lines& lines, const std::vector<LineRange>& ranges) {
    for (const LineRange& range : ranges)
        for (int line = range.first; line <= range.last; ++line)
            if (static_cast<std::size_t>(line) <= lines.size())
                lines[static_cast<std::size_t>(line) - 1].clear();
}

std::size_t codeIn(const Lines& lines) {
    std::size_t sum = 0;
    for (const std::string& line : lines)
        sum += codeIn(line);
    return sum;
}

/// The mean of both directions, by the pair with the smaller index first.
std::map<std::pair<std::size_t, std::size_t>, int> percents(const std::vector<Share>& shares) {
    std::map<std::pair<std::size_t, std::size_t>, int> sums;
    for (const Share& share : shares)
        sums[std::minmax(share.file, share.other)] += share.percent;
    for (auto& [pair, sum] : sums)
        sum /= 2;
    return sums;
}

/// The files of a class without the code that they have from elsewhere.
class Comparer {
public:
    Comparer(const std::vector<StudentFile>& files, const std::vector<std::string>& known,
             const sandbox::Sandbox& sandbox)
        : matcher_(sandbox), common_(files.size()) {
        std::vector<Lines> plain;
        std::vector<std::string> texts;
        for (const StudentFile& file : files) {
            plain.push_back(plainLines(file.text));
            texts.push_back(joined(plain.back()));
        }
        if (files.empty()) return;
        std::vector<std::string> plainKnown;
        for (const std::string& text : known)
            plainKnown.push_back(joined(plainLines(text)));
        for (const Match& match : matcher_.against(texts, plainKnown))
            common_[match.left].push_back(match.passage.left);
        for (std::size_t i = 0; i < files.size(); ++i) {
            blank(plain[i], common_[i]);
            own_.push_back(joined(plain[i]));
            if (codeIn(plain[i]) >= kLeastCode) compared_.push_back(i);
        }
    }

    [[nodiscard]] Comparison percentages(int least) const {
        Comparison comparison;
        comparison.common = common_;
        comparison.compared = compared_.size();
        if (compared_.size() < 2) return comparison;
        std::vector<std::string> texts;
        for (const std::size_t i : compared_)
            texts.push_back(own_[i]);
        for (const auto& [pair, percent] : percents(matcher_.shares(texts)))
            if (percent >= least)
                comparison.pairs.push_back(
                    {compared_[pair.first], compared_[pair.second], percent, {}});
        std::ranges::stable_sort(comparison.pairs, std::ranges::greater{}, &SimilarPair::percent);
        return comparison;
    }

    // Each pair is a run of the matcher.
    void addPassages(Comparison& comparison) const {
        const std::size_t shown = std::min(kMostPairs, comparison.pairs.size());
        for (SimilarPair& pair : std::span{comparison.pairs}.first(shown))
            pair.passages = matcher_.between(own_[pair.left], own_[pair.right]);
    }

private:
    Matcher matcher_;
    std::vector<std::vector<LineRange>> common_;
    std::vector<std::string> own_;       // blank lines where the code is from elsewhere
    std::vector<std::size_t> compared_;  // indices of the files with enough own code
};

}  // namespace

Comparison comparePercentages(const std::vector<StudentFile>& files,
                              const std::vector<std::string>& known,
                              const sandbox::Sandbox& sandbox, int leastPercent) {
    return Comparer{files, known, sandbox}.percentages(leastPercent);
}

Comparison compareFiles(const std::vector<StudentFile>& files,
                        const std::vector<std::string>& known, const sandbox::Sandbox& sandbox,
                        int leastPercent) {
    const Comparer comparer{files, known, sandbox};
    Comparison comparison = comparer.percentages(leastPercent);
    comparer.addPassages(comparison);
    return comparison;
}

}  // namespace ticker::similar

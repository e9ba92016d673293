#include <grader/lab/similar/Evaluate.h>

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
#include <utility>

namespace ticker::similar {
namespace {

constexpr std::array kLeastPercents{30, 40, 50, 60};
// Two entries of the corpus with this many equal long lines come from one author, or one was made
// from the other: they are no independent pair.
constexpr std::size_t kSameAuthor = 4;
constexpr std::size_t kLongLine = 12;
// A copy whose second half is another student's takes that half from the file this many entries
// further on.
constexpr std::size_t kOtherStep = 7;

using Percents = std::map<std::pair<std::size_t, std::size_t>, int>;

Percents percentsOf(const Comparison& comparison) {
    Percents percents;
    for (const SimilarPair& pair : comparison.pairs)
        percents[{pair.left, pair.right}] = pair.percent;
    return percents;
}

int at(const Percents& percents, std::size_t left, std::size_t right) {
    const auto found = percents.find({left, right});
    return found == percents.end() ? 0 : found->second;
}

std::set<std::string> longLines(const std::string& text, const std::set<std::string>& without) {
    std::set<std::string> lines;
    std::istringstream stream{text};
    for (std::string line; std::getline(stream, line);) {
        line.erase(std::min(line.find("//"), line.size()));
        std::erase(line, ' ');
        if (line.size() >= kLongLine && line.front() != '#' && !without.contains(line))
            lines.insert(line);
    }
    return lines;
}

bool haveOneAuthor(const std::set<std::string>& one, const std::set<std::string>& other) {
    std::vector<std::string> both;
    std::ranges::set_intersection(one, other, std::back_inserter(both));
    return both.size() >= kSameAuthor;
}

/// The percentages of all pairs of compared files by different authors.
std::vector<int> independentPercents(const Originals& originals, const Comparison& comparison,
                                     const std::vector<bool>& isCompared) {
    std::set<std::string> known;
    for (const std::string& text : originals.known)
        known.merge(longLines(text, {}));
    std::vector<std::set<std::string>> lines;
    for (const StudentFile& file : originals.files)
        lines.push_back(longLines(file.text, known));
    const Percents percents = percentsOf(comparison);
    std::vector<int> independent;
    for (std::size_t left = 0; left < lines.size(); ++left)
        for (std::size_t right = left + 1; right < lines.size(); ++right)
            if (isCompared[left] && isCompared[right] && !haveOneAuthor(lines[left], lines[right]))
                independent.push_back(at(percents, left, right));
    return independent;
}

/// The percentage of each compared original with its copy.
std::vector<int> copyPercents(const Originals& originals, Disguise disguise,
                              const sandbox::Sandbox& sandbox,
                              const std::vector<bool>& isCompared) {
    const std::vector<StudentFile>& files = originals.files;
    std::vector<StudentFile> all = files;
    for (std::size_t i = 0; i < files.size(); ++i)
        all.push_back({files[i].submission + "-copied", copyOf(originals, i, disguise)});
    const Percents percents = percentsOf(comparePercentages(all, originals.known, sandbox, 1));
    std::vector<int> copies;
    for (std::size_t i = 0; i < files.size(); ++i)
        if (isCompared[i]) copies.push_back(at(percents, i, files.size() + i));
    return copies;
}

Listed listedOf(const std::vector<int>& percents, int least) {
    return {static_cast<std::size_t>(
                std::ranges::count_if(percents, [&](int each) { return each >= least; })),
            percents.size()};
}

/// Which files have enough code of their own to be compared: those whose exact copy is recognised.
std::vector<bool> comparedFiles(const Originals& originals, const sandbox::Sandbox& sandbox) {
    std::vector<StudentFile> twice = originals.files;
    twice.insert(twice.end(), originals.files.begin(), originals.files.end());
    const Percents percents = percentsOf(comparePercentages(twice, originals.known, sandbox, 100));
    std::vector<bool> isCompared;
    for (std::size_t i = 0; i < originals.files.size(); ++i)
        isCompared.push_back(at(percents, i, originals.files.size() + i) == 100);
    return isCompared;
}

std::string share(const Listed& listed) {
    return fmt::format("{} of {}", listed.listed, listed.all);
}

double part(std::size_t some, std::size_t all) {
    return all == 0 ? 1.0 : static_cast<double>(some) / static_cast<double>(all);
}

}  // namespace

std::string copyOf(const Originals& originals, std::size_t index, Disguise disguise) {
    const std::vector<StudentFile>& files = originals.files;
    return disguised(disguise, files[index].text, originals.names,
                     files[(index + kOtherStep) % files.size()].text);
}

std::vector<Row> evaluate(const Originals& originals, const sandbox::Sandbox& sandbox) {
    const std::vector<bool> isCompared = comparedFiles(originals, sandbox);
    const std::vector<int> independent = independentPercents(
        originals, comparePercentages(originals.files, originals.known, sandbox, 1), isCompared);
    std::array<std::vector<int>, kDisguises.size()> copies;
    for (std::size_t i = 0; i < kDisguises.size(); ++i)
        copies[i] = copyPercents(originals, kDisguises[i], sandbox, isCompared);
    std::vector<Row> rows;
    for (const int least : kLeastPercents) {
        Row row{originals.file, least, listedOf(independent, least), {}};
        for (std::size_t i = 0; i < kDisguises.size(); ++i)
            row.copies[i] = listedOf(copies[i], least);
        rows.push_back(row);
    }
    return rows;
}

std::string tableOf(const std::vector<Row>& rows) {
    std::string text = "| file | listed from | pairs of two authors |";
    std::string line = "\n|---|---|---|";
    for (const Disguise disguise : kDisguises) {
        text += fmt::format(" {} |", toString(disguise));
        line += "---|";
    }
    text += " recall | precision |" + line + "---|---|\n";
    for (const Row& row : rows) {
        Listed all;
        text +=
            fmt::format("| {} | {} % | {} |", row.file, row.leastPercent, share(row.independent));
        for (const Listed& listed : row.copies) {
            text += fmt::format(" {} |", share(listed));
            all.listed += listed.listed;
            all.all += listed.all;
        }
        text += fmt::format(" {:.2f} | {:.2f} |\n", part(all.listed, all.all),
                            part(all.listed, all.listed + row.independent.listed));
    }
    return text;
}

}  // namespace ticker::similar

#include <grader/session/LineDiff.h>

#include <grader/report/SourceLines.h>

#include <algorithm>
#include <cstddef>

namespace ticker::session {
namespace {

using Lines = std::vector<std::string_view>;

constexpr std::size_t kMostLines = 2000;

/// Length of the longest common subsequence of the lines from i on and the lines from j on.
class Table {
public:
    Table(const Lines& one, const Lines& other)
        : width_(other.size() + 1), lengths_((one.size() + 1) * width_) {
        for (std::size_t i = one.size(); i-- > 0;)
            for (std::size_t j = other.size(); j-- > 0;)
                lengths_[i * width_ + j] = one[i] == other[j]
                                               ? at(i + 1, j + 1) + 1
                                               : std::max(at(i + 1, j), at(i, j + 1));
    }
    [[nodiscard]] int at(std::size_t i, std::size_t j) const { return lengths_[i * width_ + j]; }

private:
    std::size_t width_;
    std::vector<int> lengths_;
};

void diffMiddle(const Lines& one, const Lines& other, std::vector<DiffLine>& diff) {
    const bool isLarge = std::max(one.size(), other.size()) > kMostLines;
    const Table common = isLarge ? Table{{}, {}} : Table{one, other};
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < one.size() || j < other.size()) {
        if (!isLarge && i < one.size() && j < other.size() && one[i] == other[j]) {
            diff.push_back({' ', one[i]});
            ++i;
            ++j;
        } else if (j == other.size() ||
                   (i < one.size() && (isLarge || common.at(i + 1, j) >= common.at(i, j + 1)))) {
            diff.push_back({'-', one[i++]});
        } else {
            diff.push_back({'+', other[j++]});
        }
    }
}

}  // namespace

std::vector<DiffLine> lineDiff(std::string_view before, std::string_view after) {
    Lines one = report::linesOf(before);
    Lines other = report::linesOf(after);
    const auto [endOne, endOther] = std::ranges::mismatch(one, other);
    std::vector<DiffLine> diff;
    for (auto line = one.begin(); line != endOne; ++line)
        diff.push_back({' ', *line});
    one.erase(one.begin(), endOne);
    other.erase(other.begin(), endOther);
    Lines tail;
    while (!one.empty() && !other.empty() && one.back() == other.back()) {
        tail.push_back(one.back());
        one.pop_back();
        other.pop_back();
    }
    diffMiddle(one, other, diff);
    for (auto line = tail.rbegin(); line != tail.rend(); ++line)
        diff.push_back({' ', *line});
    return diff;
}

}  // namespace ticker::session

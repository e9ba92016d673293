#ifndef TICKER_TASKS_SUPPORT_DECK_H
#define TICKER_TASKS_SUPPORT_DECK_H

#include <grader/tasks/support/Draw.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace ticker::tasks {

/// Puts the values into a random order.
template <class T>
void shuffle(Draw& draw, std::vector<T>& values) {
    for (std::size_t i = values.size(); i > 1; --i) {
        const auto other = static_cast<std::size_t>(draw.whole(0, static_cast<int>(i) - 1));
        // No std::swap, which a vector of bool does not have.
        const T held = values[i - 1];
        values[i - 1] = values[other];
        values[other] = held;
    }
}

/// Deals values in random order, all of them once before any comes again: whatever the seed, each
/// is as frequent as the others.
template <class T>
class Deck {
public:
    /// @param draw    Must outlive this object.
    /// @param values  At least one; a value that is to come more often stands there several times.
    Deck(Draw& draw, std::vector<T> values)
        : draw_(&draw), values_(std::move(values)), next_(values_.size()) {}

    [[nodiscard]] T deal() {
        if (next_ == values_.size()) {
            shuffle(*draw_, values_);
            next_ = 0;
        }
        return values_[next_++];
    }

private:
    Draw* draw_;
    std::vector<T> values_;
    std::size_t next_;
};

/// A range that a number is drawn from.
struct Between {
    double low = 0.0;
    double high = 0.0;

    [[nodiscard]] double number(Draw& draw) const { return draw.between(low, high); }
};

}  // namespace ticker::tasks

#endif

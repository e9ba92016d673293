#ifndef TICKER_TASKS_SUPPORT_DECK_H
#define TICKER_TASKS_SUPPORT_DECK_H

#include <grader/tasks/support/Draw.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace ticker::tasks {

/// A range that a number is drawn from.
struct Between {
    double low = 0.0;
    double high = 0.0;
};

/// Values in random order, each as often as the others: of as many draws as there are values, none
/// is left out. After that they are shuffled again.
template <typename Value>
class Deck {
public:
    /// @param values  At least one; what stands there twice comes twice as often.
    explicit Deck(std::vector<Value> values) : values_(std::move(values)), next_(values_.size()) {}

    [[nodiscard]] Value next(Draw& draw) {
        if (next_ == values_.size()) shuffle(draw);
        return values_[next_++];
    }

private:
    void shuffle(Draw& draw) {
        for (std::size_t i = values_.size() - 1; i > 0; --i)
            std::swap(values_[i],
                      values_[static_cast<std::size_t>(draw.whole(0, static_cast<int>(i)))]);
        next_ = 0;
    }

    std::vector<Value> values_;
    std::size_t next_;
};

/// A number from the next range.
[[nodiscard]] inline double drawFrom(Deck<Between>& deck, Draw& draw) {
    const Between range = deck.next(draw);
    return draw.between(range.low, range.high);
}

}  // namespace ticker::tasks

#endif

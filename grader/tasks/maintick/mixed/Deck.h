#ifndef TICKER_TASKS_MAINTICK_MIXED_DECK_H
#define TICKER_TASKS_MAINTICK_MIXED_DECK_H

#include <grader/tasks/support/Draw.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace ticker::tasks::maintick {

/// Deals values in random order, all of them once before any comes again: whatever the seed, each
/// is as frequent as the others.
template <class T>
class Deck {
public:
    /// @param values  A value that is to come more often stands there several times.
    Deck(Draw& draw, std::vector<T> values)
        : draw_(&draw), values_(std::move(values)), next_(values_.size()) {}

    [[nodiscard]] T deal() {
        if (next_ == values_.size()) {
            for (std::size_t i = values_.size(); i > 1; --i) {
                const auto other =
                    static_cast<std::size_t>(draw_->whole(0, static_cast<int>(i) - 1));
                // No std::swap, which a vector of bool does not have.
                const T held = values_[i - 1];
                values_[i - 1] = values_[other];
                values_[other] = held;
            }
            next_ = 0;
        }
        return values_[next_++];
    }

private:
    Draw* draw_;
    std::vector<T> values_;
    std::size_t next_;
};

}  // namespace ticker::tasks::maintick

#endif

#ifndef TICKER_EXERCISE_SCREENING_H
#define TICKER_EXERCISE_SCREENING_H

#include <grader/probe/Examinee.h>

#include <functional>
#include <vector>

namespace ticker {

/// A few cheap questions that most wrong submissions of a task fail. They decide nothing: a
/// submission that may pass is judged in full.
struct Screening {
    std::vector<probe::Question> questions;
    /// False: with these answers hardly any submission passes. One that rounds heights, say, is
    /// right in other answers alone.
    std::function<bool(const probe::Run&)> mayPass;
};

}  // namespace ticker

#endif

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
    /// False if a submission with such answers hardly ever passes in full. The exceptions pass by
    /// other questions: a submission that rounds heights, for example.
    std::function<bool(const probe::Run&)> mayPass;
};

}  // namespace ticker

#endif

#ifndef TICKER_PROBE_EXAMINEE_H
#define TICKER_PROBE_EXAMINEE_H

#include <grader/probe/Question.h>

#include <string>
#include <vector>

namespace ticker::probe {

/// How the answering process ended.
struct ProcessEnd {
    enum class Kind {
        finished,       ///< answered all questions
        crashed,        ///< by a signal: `detail` names it
        exitedEarly,    ///< ended before the last question, by exit() or the like
        timedOut,       ///< CPU or wall clock
        memory,         ///< ran out of memory
        outputLimit,    ///< printed too much
        forbiddenCall,  ///< made a system call that a renderer does not need
        ourFault        ///< could not be started or watched: an error of the grader
    };
    Kind kind = Kind::finished;
    std::string detail;
};

/// All answers of one run, in the order of the questions, and how the process ended.
struct Run {
    std::vector<Answer> answers;
    ProcessEnd end;
};

/// A submission that can be questioned. Each call runs a fresh process without memory of earlier
/// calls.
class Examinee {
public:
    Examinee() = default;
    virtual ~Examinee() = default;
    Examinee(const Examinee&) = delete;
    Examinee& operator=(const Examinee&) = delete;

    /// Puts the questions to a fresh process. Never throws because of what the submission does.
    [[nodiscard]] virtual Run ask(const std::vector<Question>& questions) = 0;
};

}  // namespace ticker::probe

#endif

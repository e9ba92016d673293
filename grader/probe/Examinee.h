#ifndef TICKER_PROBE_EXAMINEE_H
#define TICKER_PROBE_EXAMINEE_H

#include <grader/probe/Question.h>

#include <string>
#include <vector>

namespace ticker::probe {

/// How the process that answered ended.
struct ProcessEnd {
    enum class Kind {
        finished,       ///< answered everything that it could
        crashed,        ///< by a signal: `detail` names it
        exitedEarly,    ///< left before the last question, by exit() or the like
        timedOut,       ///< CPU or wall clock
        memory,         ///< ran out of its memory
        outputLimit,    ///< printed too much
        forbiddenCall,  ///< asked the system for something that a renderer does not need
        ourFault        ///< could not be started or watched
    };
    Kind kind = Kind::finished;
    std::string detail;
};

/// All answers of one sitting, in the order of the questions, and how it ended.
struct Sitting {
    std::vector<Answer> answers;
    ProcessEnd end;
};

/// A submission that can be asked. Each call is a fresh process that knows nothing of earlier ones.
class Examinee {
public:
    Examinee() = default;
    virtual ~Examinee() = default;
    Examinee(const Examinee&) = delete;
    Examinee& operator=(const Examinee&) = delete;

    /// Puts the questions to a fresh process. Never throws for what the submission does.
    [[nodiscard]] virtual Sitting ask(const std::vector<Question>& questions) = 0;
};

}  // namespace ticker::probe

#endif

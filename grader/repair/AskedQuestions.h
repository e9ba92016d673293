#ifndef TICKER_REPAIR_ASKEDQUESTIONS_H
#define TICKER_REPAIR_ASKEDQUESTIONS_H

#include <grader/probe/Examinee.h>

#include <vector>

namespace ticker::repair {

/// Notes what a judge asks first, and answers nothing.
class FirstQuestions final : public probe::Examinee {
public:
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        if (asked.empty()) asked = questions;
        return {{}, {probe::ProcessEnd::Kind::ourFault, "not asked"}};
    }
    std::vector<probe::Question> asked;
};

/// Notes what a judge asks last, and the answers.
class LastQuestions final : public probe::Examinee {
public:
    explicit LastQuestions(probe::Examinee& asked) : asked_(asked) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        ++count;
        last = questions;
        run = asked_.ask(questions);
        return run;
    }
    int count = 0;
    std::vector<probe::Question> last;
    probe::Run run;

private:
    probe::Examinee& asked_;
};

}  // namespace ticker::repair

#endif

#ifndef MAINTICK_H
#define MAINTICK_H

#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Vector3.h>
#include <raytracer/scene/SceneDescription.h>
#include <support/Complaint.h>
#include <support/KeptScene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace raytracer::tests {

/// What a public test asks, and what to look at where the answer is wrong.
struct Question {
    const char* asked;
    const char* likely;
};

/// One task's public tests.
class MainTick : public ::testing::Test {
protected:
    /// @param task   Its tag: "M1".
    /// @param needs  Tasks without which it cannot be asked.
    explicit MainTick(const char* task, const char* section, std::vector<const char*> needs = {})
        : task_(task), section_(section), needs_(std::move(needs)) {}

    /// Ends a test. Call it after the student's code has run: a stub is known only once it was
    /// called.
    void settle(bool isRight, const Question& question, const std::string& expected,
                const std::string& got) const {
        if (isUnfinished(task_)) GTEST_SKIP() << task_ << " is not attempted";
        for (const char* other : needs_)
            if (isUnfinished(other))
                GTEST_SKIP() << "cannot be asked before " << other << " is done";
        if (!isRight)
            ADD_FAILURE() << Complaint{question.asked, expected, got, question.likely, section_};
    }

private:
    const char* task_;
    const char* section_;
    std::vector<const char*> needs_;
};

[[nodiscard]] inline std::string triple(double a, double b, double c) {
    return "(" + inWords(a) + ", " + inWords(b) + ", " + inWords(c) + ")";
}

}  // namespace raytracer::tests

#endif

// The cheap questions for edits of a submission.
#include <grader/tasks/bump/ScreenBump.h>
#include <grader/tests/tasks/bump/SomeReadings.h>
#include <grader/tests/tasks/bump/StandIn.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ticker::tasks {
namespace {

constexpr std::uint64_t kScreenSeed = 11;

bool mayPass(const Screening& screening, selftest::NormalFunction function) {
    selftest::FunctionExaminee examinee(std::move(function));
    return screening.mayPass(examinee.ask(screening.questions));
}

bool isSeenByRamps(const tests::CompiledMistake& mistake) {
    return !mayPass(screenBump(kScreenSeed), mistake.normalAt);
}

TEST(ScreenBump, LetsAcceptedReadingsPassEachPart) {
    const std::vector<Screening> elsewhere = screenBumpElsewhere(kScreenSeed);
    const auto expectAll = [&](const selftest::NormalFunction& function, const std::string& name) {
        for (std::size_t i = 0; i < elsewhere.size(); ++i)
            EXPECT_TRUE(mayPass(elsewhere[i], function)) << name << ", part " << i;
    };
    std::size_t refused = 0;
    const std::vector<selftest::Reading> readings = tests::someReadings();
    for (const selftest::Reading& reading : readings) {
        const auto function = [reading](const selftest::Point& point) {
            return modelNormal(reading, selftest::Mistake::none, point);
        };
        // Gentle ramps alone do not show rounded heights or slopes in single precision to be right.
        if (mayPass(screenBump(kScreenSeed), function))
            expectAll(function, describe(reading));
        else
            ++refused;
    }
    EXPECT_LT(4 * refused, readings.size());
    for (const tests::CompiledMistake& entry : tests::compiledCatalogue())
        if (entry.state == "passed") expectAll(entry.normalAt, entry.id);
}

TEST(ScreenBump, SeesMoreMistakesWithEachPart) {
    std::vector<const tests::CompiledMistake*> unseen;
    for (const tests::CompiledMistake& entry : tests::compiledCatalogue())
        if (entry.state == "failed" && !isSeenByRamps(entry)) unseen.push_back(&entry);
    const std::size_t byRamps = unseen.size();
    for (const Screening& part : screenBumpElsewhere(kScreenSeed)) {
        const std::size_t before = unseen.size();
        std::erase_if(unseen, [&](const tests::CompiledMistake* entry) {
            return !mayPass(part, entry->normalAt);
        });
        EXPECT_LT(unseen.size(), before);
    }
    EXPECT_LT(4 * unseen.size(), byRamps) << "those that are left need all questions";
}

}  // namespace
}  // namespace ticker::tasks

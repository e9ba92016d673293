#include "FakeKit.h"

#include <student_template/framework/app/view/SolutionRunner.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace raytracer::view {
namespace {

TEST(SolutionRunner, DropsAPictureThatIsOlderThanTheLastOne) {
    FakeKit kit;
    std::vector<std::string> asked;
    SolutionRunner runner{kit.home().program,
                          {[](int, const std::string&) {},
                           [&](const std::string& command) { asked.push_back(command); }}};
    runner.render(2, {"newer"});
    runner.render(1, {"older"});
    EXPECT_EQ(runner.ask("pixel", {}).payload, "pixel\t1000001");
    EXPECT_EQ(asked, (std::vector<std::string>{"picture\t2\tnewer"}));
}

TEST(SolutionRunner, CallsACrashByItsNameOnEverySystem) {
    EXPECT_EQ(endInWords(3), "Your code ended the program with the status 3.");
    EXPECT_NE(endInWords(139).find("Your code crashed (signal 11)."), std::string::npos);
    EXPECT_NE(endInWords(-1073741819).find("Your code crashed."), std::string::npos);
}

}  // namespace
}  // namespace raytracer::view

#ifndef TICKER_TESTS_SANDBOX_JAILFIXTURE_H
#define TICKER_TESTS_SANDBOX_JAILFIXTURE_H

#include <grader/sandbox/Sandbox.h>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace ticker::sandbox {

/// A program beside the running one.
[[nodiscard]] std::filesystem::path programBeside(const std::string& name);

/// A new name that no other process has.
[[nodiscard]] std::string newMarker();

/// Processes whose command line contains `marker`, and unreaped children of this process.
[[nodiscard]] std::vector<std::string> processesLeft(const std::string& marker);

/// A file that every user may read and that no jail must show.
inline constexpr const char* kSecret = "MARMALADE-REFERENCE-0451";
[[nodiscard]] const std::filesystem::path& secretFile();

/// Tests at one level. Skipped with the reason where the machine does not give it; a failure if
/// the environment's TICKER_REQUIRE_LEVELS names it.
class AtLevel : public testing::TestWithParam<Level> {
protected:
    void SetUp() override;
    void TearDown() override;

    /// A command that does one trick, with limits that suit a test.
    [[nodiscard]] Command trick(const std::vector<std::string>& words) const;
    [[nodiscard]] Outcome run(const Command& command) const;
    [[nodiscard]] Outcome runTrick(const std::vector<std::string>& words) const {
        return run(trick(words));
    }
    /// Runs a file of this text as if it were a program.
    [[nodiscard]] Outcome runText(const std::string& text) const;
    [[nodiscard]] const std::string& marker() const { return marker_; }
    /// The process of a trick that runs; a failure of the test if none does.
    [[nodiscard]] pid_t trickProcess() const;

private:
    std::string marker_ = newMarker();
};

inline std::string levelName(const testing::TestParamInfo<Level>& info) {
    return toString(info.param);
}

/// "exit 3", "signal 31", "wall limit", "output limit" or "failed: ...".
[[nodiscard]] std::string describe(const Outcome& outcome);

/// How `describe` names the end at a system call that is forbidden.
inline const std::string kForbidden = "signal " + std::to_string(SIGSYS);

}  // namespace ticker::sandbox

#endif

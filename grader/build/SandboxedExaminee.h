#ifndef TICKER_BUILD_SANDBOXEDEXAMINEE_H
#define TICKER_BUILD_SANDBOXEDEXAMINEE_H

#include <grader/build/Program.h>
#include <grader/build/TimeBudget.h>
#include <grader/probe/Examinee.h>
#include <grader/sandbox/Sandbox.h>

namespace ticker::build {

/// Asks a built submission: each call runs its program once in the sandbox. The sandbox sees only
/// the questions and the memory for the answers.
class SandboxedExaminee final : public probe::Examinee {
public:
    /// The arguments must outlive this object.
    /// @param limits  Limits of each run.
    /// @param budget  Limits of the whole submission; null: only the limits of each run.
    SandboxedExaminee(const Program& program, const sandbox::Sandbox& sandbox,
                      const sandbox::Limits& limits, TimeBudget* budget = nullptr)
        : program_(program), sandbox_(sandbox), limits_(limits), budget_(budget) {}

    /// @throws raytracer::Error if a question contradicts itself (an error of the caller).
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override;

    /// CPU and wall time of all runs so far, milliseconds.
    [[nodiscard]] double cpuMs() const { return cpuMs_; }
    [[nodiscard]] double wallMs() const { return wallMs_; }
    /// True if a run was ended at a system call that no renderer makes, even if its answers were
    /// complete by then.
    [[nodiscard]] bool madeForbiddenCall() const { return madeForbiddenCall_; }

private:
    [[nodiscard]] sandbox::Outcome run(const sandbox::Command& command);

    const Program& program_;
    const sandbox::Sandbox& sandbox_;
    const sandbox::Limits& limits_;
    TimeBudget* budget_;
    bool madeForbiddenCall_ = false;
    double cpuMs_ = 0.0;
    double wallMs_ = 0.0;
};

}  // namespace ticker::build

#endif

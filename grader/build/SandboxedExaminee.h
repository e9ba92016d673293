#ifndef TICKER_BUILD_SANDBOXEDEXAMINEE_H
#define TICKER_BUILD_SANDBOXEDEXAMINEE_H

#include <grader/build/Program.h>
#include <grader/probe/Examinee.h>
#include <grader/sandbox/Sandbox.h>

namespace ticker::build {

/// Asks a built submission: each sitting is one run of its program in the sandbox, which sees the
/// questions and a memory for its answers, and nothing else.
class SandboxedExaminee final : public probe::Examinee {
public:
    /// All three must outlive this object.
    SandboxedExaminee(const Program& program, const sandbox::Sandbox& sandbox,
                      const sandbox::Limits& limits)
        : program_(program), sandbox_(sandbox), limits_(limits) {}

    /// @throws raytracer::Error where a question contradicts itself: a mistake of the asker.
    [[nodiscard]] probe::Sitting ask(const std::vector<probe::Question>& questions) override;

    /// CPU and wall time of all sittings so far, milliseconds.
    [[nodiscard]] double cpuMs() const { return cpuMs_; }
    [[nodiscard]] double wallMs() const { return wallMs_; }

private:
    const Program& program_;
    const sandbox::Sandbox& sandbox_;
    const sandbox::Limits& limits_;
    double cpuMs_ = 0.0;
    double wallMs_ = 0.0;
};

}  // namespace ticker::build

#endif

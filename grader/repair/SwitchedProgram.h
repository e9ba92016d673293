#ifndef TICKER_REPAIR_SWITCHEDPROGRAM_H
#define TICKER_REPAIR_SWITCHEDPROGRAM_H

#include <grader/build/Build.h>
#include <grader/probe/Examinee.h>
#include <grader/repair/Candidates.h>
#include <grader/repair/Clock.h>
#include <grader/sandbox/Sandbox.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ticker::repair {

/// Numbers of the edits that are made together.
using EditSet = std::vector<std::uint16_t>;

/// A submission with all its edits in one program, which is told at run time which of them to make.
class SwitchedProgram {
public:
    /// All of them must outlive this object.
    SwitchedProgram(build::Program program, const sandbox::Sandbox& sandbox,
                    const sandbox::Limits& limits, bool keepsState, Clock& clock)
        : program_(std::move(program)),
          sandbox_(sandbox),
          limits_(limits),
          keepsState_(keepsState),
          clock_(clock) {}

    /// Whether the submission answers without edits: then loops that an edit makes endless are
    /// recognised sooner.
    void answersUnedited(bool does) { isMeasured_ = does; }

    /// Takes what a submission answers with a set of edits. @param set  Its place among the sets.
    using UseRun = std::function<void(std::size_t set, probe::Run run)>;

    /// Puts the questions to the submission once for each set. What ends a process costs only the
    /// set that was being asked.
    /// @param use  Called in the order of the sets, for as many as there is time for. Answers are
    ///             read one set after the other: all together may take much memory.
    void askEach(const std::vector<probe::Question>& questions, std::span<const EditSet> sets,
                 const UseRun& use) const;

    /// The same with all answers at once.
    [[nodiscard]] std::vector<probe::Run> ask(const std::vector<probe::Question>& questions,
                                              std::span<const EditSet> sets) const;

private:
    /// @param first  The place of the first of these sets.
    /// @return  How many were asked.
    std::size_t askTogether(const std::vector<probe::Question>& questions,
                            std::span<const EditSet> sets, std::size_t first,
                            const UseRun& use) const;

    build::Program program_;
    const sandbox::Sandbox& sandbox_;
    const sandbox::Limits& limits_;
    bool keepsState_;
    bool isMeasured_ = false;
    Clock& clock_;
};

/// A submission with a set of edits, as judges ask it.
class EditedExaminee final : public probe::Examinee {
public:
    EditedExaminee(const SwitchedProgram& program, EditSet set)
        : program_(program), set_(std::move(set)) {}

    /// Answers to the first questions that are known already.
    void expect(probe::Run first) { first_ = std::move(first); }

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override;

private:
    const SwitchedProgram& program_;
    EditSet set_;
    std::optional<probe::Run> first_;
};

}  // namespace ticker::repair

#endif

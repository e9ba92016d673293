#ifndef TICKER_REPAIR_WORKBENCH_H
#define TICKER_REPAIR_WORKBENCH_H

#include <grader/pipeline/Grade.h>
#include <grader/repair/Candidates.h>
#include <grader/repair/Clock.h>
#include <grader/repair/SwitchedProgram.h>

#include <optional>
#include <string>

namespace ticker::repair {

/// Edits of a file, and the program that carries them.
struct Bench {
    Candidates candidates;
    SwitchedProgram program;
};

/// A submitted file and its edits, made when they are asked for: many submissions need the simple
/// ones alone.
class Workbench {
public:
    /// All of them must outlive this object.
    /// @param leftAlone  Functions that are not edited, with commas between them.
    Workbench(std::string file, std::string source, std::string leftAlone,
              const pipeline::Grader& grader, Clock& clock)
        : file_(std::move(file)),
          source_(std::move(source)),
          leftAlone_(std::move(leftAlone)),
          grader_(grader),
          clock_(clock) {}

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] const std::string& source() const { return source_; }
    /// @return  Null where the file cannot be parsed, or its edits cannot be compiled in the time
    ///          that is left.
    [[nodiscard]] Bench* bench(Reach reach);

private:
    struct Place {
        bool wasTried = false;
        std::optional<Bench> bench;
    };
    [[nodiscard]] std::optional<Bench> made(Reach reach) const;

    std::string file_;
    std::string source_;
    std::string leftAlone_;
    const pipeline::Grader& grader_;
    Clock& clock_;
    Place simple_;
    Place wide_;
};

}  // namespace ticker::repair

#endif

#ifndef TICKER_TESTS_PIPELINE_TESTGRADER_H
#define TICKER_TESTS_PIPELINE_TESTGRADER_H

#include <grader/pipeline/Grade.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace ticker::tests {

/// A grader like that of `ticker grade`, with a shorter limit for loops.
inline const pipeline::Grader& testGrader() {
    static const pipeline::Grader grader = [] {
        const std::filesystem::path root{TICKER_SOURCE_DIR};
        pipeline::Grader made{build::Kit::besideProgram(),
                              sandbox::Sandbox::best(),
                              sandbox::defaultPolicy(),
                              rubric::readRubric(root / "grader/rubric/rubric.json"),
                              "test",
                              {}};
        made.policy.run.cpuSeconds = 2.0;
        return made;
    }();
    return grader;
}

/// The same with the handout's scenes: renders pictures, and judges screenshots.
inline const pipeline::Grader& testGraderWithScenes() {
    static const pipeline::Grader grader = [] {
        const std::filesystem::path root{TICKER_SOURCE_DIR};
        pipeline::Grader made = testGrader();
        made.policy.run.cpuSeconds = 8.0;  // some right samples take three for a picture
        made.scenes = pipeline::readSpecScenes(root / "scenes", root / "assets");
        return made;
    }();
    return grader;
}

inline const TaskReport& taskOf(const SubmissionResult& result, const std::string& id) {
    const auto task = std::ranges::find(result.tasks, id, &TaskReport::id);
    if (task == result.tasks.end()) throw std::runtime_error("no task " + id);
    return *task;
}

inline std::vector<std::string> findingIds(const TaskReport& task) {
    std::vector<std::string> ids;
    for (const Finding& finding : task.findings)
        ids.push_back(finding.id);
    return ids;
}

}  // namespace ticker::tests

#endif

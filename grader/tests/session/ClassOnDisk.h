#ifndef TICKER_TESTS_SESSION_CLASSONDISK_H
#define TICKER_TESTS_SESSION_CLASSONDISK_H

#include <grader/result/ResultJson.h>
#include <grader/store/ClassFolder.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <filesystem>
#include <string>

namespace ticker::tests {

/// A submission's result with one finding and markup wherever a student could put some.
inline SubmissionResult markedResult(const std::string& name, Verdict verdict) {
    SubmissionResult result;
    result.submission = name;
    result.verdict = verdict;
    result.toolVersion = "test";
    result.option = "T1";
    TaskReport task;
    task.id = "T1";
    task.title = "Bump mapping";
    task.state = TaskState::failed;
    task.reason = "<script>reason</script>";
    Finding finding;
    finding.id = "bump.inverted-u";
    finding.message = "<script>message</script>";
    finding.hint = "<script>hint</script>";
    finding.evidence = {{"said", std::string{"<script>evidence</script>"}}};
    task.findings.push_back(finding);
    result.tasks.push_back(task);
    result.notices = {"<script>notice</script>"};
    return result;
}

/// An OUT with a store, as ticker grade leaves it.
class ClassOnDisk {
public:
    explicit ClassOnDisk(const std::vector<std::string>& names) {
        for (const std::string& name : names) {
            folder_.write(name + "/result.json",
                          resultJson(markedResult(name, Verdict::notAwarded)));
            folder_.write(name + "/report.html", "<!doctype html>the report");
            folder_.write(name + "/images/bump-mapping.png", "png bytes");
            folder_.write(name + "/code/BumpySphere.cpp", "int x; // <script>code</script>\n");
        }
        store::Store store{out()};
        static_cast<void>(store::collect(out(), store));
    }

    [[nodiscard]] const std::filesystem::path& out() const { return folder_.path(); }

private:
    TemporaryFolder folder_;
};

}  // namespace ticker::tests

#endif

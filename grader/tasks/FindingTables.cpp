#include <grader/tasks/FindingTables.h>

#include <grader/exercise/Exercise.h>
#include <grader/result/GeneralFindings.h>
#include <grader/tasks/Tasks.h>
#include <grader/tasks/screenshot/ScreenshotFindings.h>

#include <algorithm>
#include <vector>

namespace ticker::tasks {

std::span<const FindingTable> findingTables() {
    static const std::vector<FindingTable> kTables = [] {
        std::vector<FindingTable> tables;
        for (const Exercise& exercise : knownExercises())
            for (const Task& task : tasksOf(exercise.name))
                tables.push_back({task.id, task.findings});
        tables.push_back({"Screenshot", kScreenshotFindings});
        tables.push_back({"Any task", kGeneralFindings});
        return tables;
    }();
    return kTables;
}

std::span<const FindingText* const> allFindings() {
    static const std::vector<const FindingText*> kAll = [] {
        std::vector<const FindingText*> all;
        for (const FindingTable& table : findingTables())
            for (const FindingText* text : table.findings)
                if (std::ranges::find(all, text) == all.end()) all.push_back(text);
        return all;
    }();
    return kAll;
}

const FindingText* findText(std::string_view id) {
    const auto all = allFindings();
    const auto found = std::ranges::find(all, id, &FindingText::id);
    return found == all.end() ? nullptr : *found;
}

}  // namespace ticker::tasks

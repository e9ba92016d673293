#include <grader/result/GeneralFindings.h>
#include <grader/tasks/AllFindings.h>
#include <grader/tasks/bump/BumpFindings.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/maintick/LightFindings.h>
#include <grader/tasks/maintick/MainTickFindings.h>
#include <grader/tasks/maintick/MirrorFindings.h>
#include <grader/tasks/screenshot/ScreenshotFindings.h>
#include <grader/tasks/shadows/ShadowFindings.h>

#include <algorithm>
#include <array>
#include <vector>

namespace ticker::tasks {
namespace {

constexpr std::array kTables{FindingTable{"T1", kBumpFindings},
                             FindingTable{"T2.1", kShadowFindings},
                             FindingTable{"T2.2", kLensFindings},
                             FindingTable{"M1", kSphereFindings},
                             FindingTable{"M2", kPhongFindings},
                             FindingTable{"M3.1", kPlaneFindings},
                             FindingTable{"M3.2", kShadeFindings},
                             FindingTable{"M4", kMirrorFindings},
                             FindingTable{"Screenshot", kScreenshotFindings},
                             FindingTable{"Any task", kGeneralFindings}};

}  // namespace

std::span<const FindingTable> findingTables() {
    return kTables;
}

std::span<const FindingText* const> allFindings() {
    static const std::vector<const FindingText*> kAll = [] {
        std::vector<const FindingText*> all;
        for (const FindingTable& table : kTables)
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

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
#include <vector>

namespace ticker::tasks {

std::span<const FindingText* const> allFindings() {
    static const std::vector<const FindingText*> kAll = [] {
        std::vector<const FindingText*> all;
        const auto add = [&](const auto& some) {
            for (const FindingText* text : some)
                if (std::ranges::find(all, text) == all.end()) all.push_back(text);
        };
        add(kBumpFindings);
        add(kShadowFindings);
        add(kLensFindings);
        add(kSphereFindings);
        add(kPhongFindings);
        add(kPlaneFindings);
        add(kShadeFindings);
        add(kMirrorFindings);
        add(kScreenshotFindings);
        add(kGeneralFindings);
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

#include <grader/intake/Submission.h>

namespace ticker::intake {

std::string nameOf(Part part) {
    switch (part) {
        case Part::bumpySphere:
            return "BumpySphere.cpp";
        case Part::renderer:
            return "Renderer.cpp";
        default:
            return "screenshot.png";
    }
}

const Finding* Submission::refusalOf(Part which) const {
    for (const IntakeFinding& entry : findings)
        if (entry.finding.severity == Severity::fail && (!entry.part || entry.part == which))
            return &entry.finding;
    return nullptr;
}

}  // namespace ticker::intake

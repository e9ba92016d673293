#include <grader/tasks/drawings/DrawBumps.h>

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/questions/LetterMap.h>
#include <grader/tasks/bump/questions/Numbers.h>
#include <grader/tasks/bump/questions/Tilt.h>
#include <grader/tasks/drawings/LetterEdges.h>
#include <grader/tasks/support/SceneDrawing.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

using namespace bump;
using namespace drawings;

const Ball kBall{{0.0, 0.0, 3.5}, 0.7};

template <typename Value>
const Value* valueOf(const Evidence& evidence, std::string_view key) {
    const auto found =
        std::ranges::find(evidence, key, [](const auto& entry) { return entry.first; });
    return found == evidence.end() ? nullptr : std::get_if<Value>(&found->second);
}

/// How the map lies on the sphere, as the judge found it; empty if it found no tilts that fit.
std::optional<Parametrisation> parametrisationIn(const Evidence& evidence) {
    constexpr double kNearAxis = 0.98;  // beyond, the camera faces a pole, where u says little
    const auto* axis = valueOf<std::vector<double>>(evidence, "topOfMap");
    const auto* u = valueOf<double>(evidence, "uFacingTheCamera");
    const auto* mirrored = valueOf<bool>(evidence, "mirrored");
    const bool isFitted = valueOf<std::vector<double>>(evidence, "responseMatrix") != nullptr;
    if (!axis || axis->size() != 3 || !u || !mirrored || !isFitted) return std::nullopt;
    const Vector3 top{(*axis)[0], (*axis)[1], (*axis)[2]};
    if (!(std::abs(top.z) < kNearAxis)) return std::nullopt;
    return Parametrisation{top.normalised(), *u, *mirrored};
}

Vector3 directionOf(const Parametrisation& parametrisation, const MapPlace& place) {
    return parametrisation.direction(place.x / kLetterMapWidth, place.y / kLetterMapHeight);
}

/// The cell that faces the camera most, and its neighbour in the row that does so more: an H and
/// an L.
std::vector<std::pair<int, int>> cellsInView(const Parametrisation& parametrisation) {
    const auto depth = [&](const std::pair<int, int>& cell) {
        return directionOf(parametrisation, centreOf(cell.first, cell.second)).z;
    };
    std::vector<std::pair<int, int>> cells;
    for (int row = 0; row < kCellRows; ++row)
        for (int column = 0; column < kCellColumns; ++column)
            cells.emplace_back(column, row);
    const std::pair<int, int> nearest = *std::ranges::min_element(cells, {}, depth);
    const auto beside = [&](int step) {
        return std::pair{(nearest.first + step + kCellColumns) % kCellColumns, nearest.second};
    };
    return {nearest, std::min(beside(1), beside(-1),
                              [&](const auto& a, const auto& b) { return depth(a) < depth(b); })};
}

/// A place on an edge where a normal is asked for.
struct Spot {
    Vector3 direction;  // from the sphere's centre
    bool isUpright = false;
    Vector3 downhill;  // unit: a right normal leans there
    Vector3 tilt;      // of the normal that was given
    Vector3 given;
};

std::vector<Spot> spotsOn(const std::vector<LetterEdge>& edges,
                          const Parametrisation& parametrisation) {
    constexpr double kLong = 35.0;  // texels: a longer edge gets two spots
    std::vector<Spot> spots;
    for (const LetterEdge& edge : edges)
        for (const double share :
             edge.length() > kLong ? std::vector{0.25, 0.75} : std::vector{0.5}) {
            const Vector3 n = directionOf(parametrisation, edge.at(share));
            const Vector3 along =
                edge.isUpright ? parametrisation.alongU(n) : parametrisation.alongV(n);
            spots.push_back({n, edge.isUpright, along * -edge.rise, {}, {}});
        }
    return spots;
}

std::vector<std::vector<RayDrawing::Point>> outlinesOf(const std::vector<LetterEdge>& edges,
                                                       const Parametrisation& parametrisation) {
    constexpr double kStep = 12.0;    // texels: 7 degrees of longitude
    constexpr double kAbove = 1.003;  // radii: the sphere's own lines do not hide them
    std::vector<std::vector<RayDrawing::Point>> lines;
    for (const LetterEdge& edge : edges) {
        std::vector<RayDrawing::Point>& line = lines.emplace_back();
        const int steps = std::max(1, static_cast<int>(std::ceil(edge.length() / kStep)));
        for (int i = 0; i <= steps; ++i)
            line.push_back(
                drawn(kBall.at(directionOf(parametrisation, edge.at(1.0 * i / steps)) * kAbove)));
    }
    return lines;
}

/// Asks for the normals; spots without a finite one are dropped. False if the program does not
/// finish, or if no spot is left.
bool fill(std::vector<Spot>& spots, probe::Examinee& examinee) {
    std::vector<Vector3> directions;
    for (const Spot& spot : spots)
        directions.push_back(spot.direction);
    Questionnaire questionnaire;
    const LevelPair pair = questionnaire.addPair(kBall, letterMap(), directions);
    const Answers answers(questionnaire, examinee.ask(questionnaire.questions()));
    if (answers.end().kind != probe::ProcessEnd::Kind::finished) return false;
    const std::vector<Vector3> tilts = answers.tiltsBeyond(pair.flat, pair.map);
    for (std::size_t i = 0; i < spots.size(); ++i) {
        spots[i].tilt = tilts[i];
        spots[i].given = answers.answer(pair.map).normals[i];
    }
    std::erase_if(spots,
                  [](const Spot& spot) { return !isFinite(spot.tilt) || !isFinite(spot.given); });
    return !spots.empty();
}

/// Median tilt at the edges of one direction. The drawing expects this strength, since any is
/// right.
double strengthOf(const std::vector<Spot>& spots, bool isUpright) {
    std::vector<double> lengths;
    for (const Spot& spot : spots)
        if (spot.isUpright == isUpright) lengths.push_back(spot.tilt.magnitude());
    return lengths.empty() ? 0.0 : median(std::move(lengths));
}

std::string wordsOf(const std::vector<Spot>& spots, bool isUpright) {
    constexpr double kClear = 0.7;  // cosine
    int all = 0;
    int right = 0;
    int opposite = 0;
    for (const Spot& spot : spots) {
        if (spot.isUpright != isUpright) continue;
        const double cosine = spot.tilt.normalised().dot(spot.downhill);
        ++all;
        right += cosine > kClear ? 1 : 0;
        opposite += cosine < -kClear ? 1 : 0;
    }
    return fmt::format(
        "At the {} edges (along {}), {} of {} normals lean away from the brighter side, as they "
        "should; {} lean towards it, {} along the edge or hardly at all.",
        isUpright ? "upright" : "level", isUpright ? "u" : "v", right, all, opposite,
        all - right - opposite);
}

RayDrawing drawingOf(const std::vector<Spot>& spots) {
    constexpr double kSlight = 0.05;  // of the other direction's strength: as good as none
    const double upright = strengthOf(spots, true);
    const double level = strengthOf(spots, false);
    const double least = kSlight * std::max(upright, level);
    RayDrawing drawing;
    drawing.about = "The normals along two letters of one row, as this code gives them";
    drawing.words = {
        "An H, which is brighter than its ground and should be raised, and an L, which is "
        "darker and should be lowered, as this code lays them on the sphere.",
        wordsOf(spots, true), wordsOf(spots, false)};
    drawing.spheres = {{"sphere", drawn(kBall.centre), kBall.radius}};
    for (const Spot& spot : spots) {
        const double own = spot.isUpright ? upright : level;
        const double strength = own > least ? own : std::max(upright, level);
        drawing.normals.push_back({drawn(kBall.at(spot.direction)), drawn(spot.direction),
                                   drawn((spot.direction + spot.downhill * strength).normalised()),
                                   drawn(spot.given.normalised())});
    }
    return drawing;
}

}  // namespace

void drawBumps(probe::Examinee& examinee, TaskJudgement& judgement) {
    if (judgement.state != TaskState::failed || judgement.findings.empty()) return;
    Finding& finding = judgement.findings.front();
    const auto parametrisation = parametrisationIn(finding.evidence);
    if (!parametrisation) return;
    std::vector<LetterEdge> edges;
    for (const auto& [column, row] : cellsInView(*parametrisation))
        std::ranges::copy(edgesOf(column, row), std::back_inserter(edges));
    std::vector<Spot> spots = spotsOn(edges, *parametrisation);
    if (!fill(spots, examinee)) return;
    ScatterPlot plot;
    plot.title = "Normals along one row of letters";
    plot.drawing = drawingOf(spots);
    plot.drawing->outlines = outlinesOf(edges, *parametrisation);
    finding.plots.push_back(std::move(plot));
}

}  // namespace ticker::tasks

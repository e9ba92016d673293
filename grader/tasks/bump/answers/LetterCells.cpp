#include <grader/tasks/bump/answers/LetterCells.h>

#include <grader/tasks/bump/questions/Numbers.h>
#include <grader/tasks/bump/questions/Slopes.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks::bump {
namespace {

using probe::HeightMapDescription;

Cell placeCell(const HeightMapDescription& map, const Parametrisation& parametrisation,
               const Vector3& direction) {
    Cell cell;
    const double u = parametrisation.u(direction);
    const double v = parametrisation.v(direction);
    cell.column = u * kLetterMapWidth;
    cell.row = v * kLetterMapHeight;
    const int column = std::min(static_cast<int>(cell.column), kLetterMapWidth - 1);
    const int row = std::min(static_cast<int>(cell.row), kLetterMapHeight - 1);
    cell.height = letterHeight(column, row);
    cell.kind = letterAt(column, row);
    cell.trueU = slopeAlongU(map, u, v) / (kByte * kLetterLift);
    cell.trueV = slopeAlongV(map, u, v) / (kByte * kLetterLift);
    return cell;
}

/// Scales recovered slopes to the size of the true ones; signs stay.
void scale(std::vector<Cell>& cells, double Cell::*seen, double Cell::*expected) {
    double seenSquares = 0.0;
    double trueSquares = 0.0;
    for (Cell& cell : cells) {
        if (!std::isfinite(cell.*seen)) cell.*seen = 0.0;
        seenSquares += (cell.*seen) * (cell.*seen);
        trueSquares += (cell.*expected) * (cell.*expected);
    }
    const double factor = seenSquares > 0.0 ? std::sqrt(trueSquares / seenSquares) : 0.0;
    for (Cell& cell : cells)
        cell.*seen *= factor;
}

}  // namespace

CellGrid recover(const LetterPlan& plan, const Answers& answers,
                 const Parametrisation& parametrisation, const Response& response) {
    const HeightMapDescription& map = answers.asked().question(plan.question).map;
    const std::vector<Vector3> tilts = answers.tiltsBeyond(plan.flat, plan.question);
    CellGrid grid;
    grid.reserve(tilts.size());
    for (std::size_t i = 0; i < tilts.size(); ++i) {
        const Vector3& n = plan.directions[i];
        Cell cell = placeCell(map, parametrisation, n);
        const double v = parametrisation.v(n);
        cell.seenU = -tilts[i].dot(parametrisation.alongU(n)) / strengthAt(response.u, v);
        cell.seenV = -tilts[i].dot(parametrisation.alongV(n)) / strengthAt(response.v, v);
        grid.push_back(cell);
    }
    scale(grid, &Cell::seenU, &Cell::trueU);
    scale(grid, &Cell::seenV, &Cell::trueV);
    return grid;
}

}  // namespace ticker::tasks::bump

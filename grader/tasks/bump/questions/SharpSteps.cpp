#include <grader/tasks/bump/questions/SharpSteps.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ticker::tasks::bump {
namespace {

using probe::HeightMapDescription;

constexpr int kBlock = 3;  // texels
constexpr int kBlocksAcross = 40;
constexpr int kBlocksDown = 20;

/// Zeros and ones.
std::vector<std::uint8_t> drawBlocks(Draws& draws) {
    std::vector<std::uint8_t> blocks;
    for (int i = 0; i < kBlocksAcross * kBlocksDown; ++i)
        blocks.push_back(static_cast<std::uint8_t>(draws.integer(0, 1)));
    return blocks;
}

HeightMapDescription mapOf(const std::vector<std::uint8_t>& blocks, int height) {
    HeightMapDescription map{kBlocksAcross * kBlock, kBlocksDown * kBlock, {}, {}, {}};
    for (int row = 0; row < map.height; ++row)
        for (int column = 0; column < map.width; ++column) {
            const int block = row / kBlock * kBlocksAcross + column / kBlock;
            map.bytes.push_back(
                static_cast<std::uint8_t>(blocks[static_cast<std::size_t>(block)] * height));
        }
    return map;
}

}  // namespace

SharpStepPlan planSharpSteps(Questionnaire& questionnaire, Draws& draws, const Ball& ball,
                             const StepHeights& heights) {
    constexpr int kPoints = 500;
    constexpr int kGrey = 100;
    const std::vector<std::uint8_t> blocks = drawBlocks(draws);
    const std::vector<Vector3> directions = draws.directions(kPoints);
    const LevelPair grey = questionnaire.addPair(ball, mapOf(blocks, kGrey), directions);
    const int height = draws.integer(heights.least, heights.most);
    return {grey, questionnaire.addPair(ball, mapOf(blocks, height), directions),
            heights.least == kWhiteSteps.least};
}

SharpSteps readSharpSteps(const SharpStepPlan& plan, const Answers& answers) {
    constexpr double kSomeTilt = 1e-5;  // single precision leaves 1e-7
    const std::vector<Vector3> grey = answers.tiltsBeyond(plan.grey.flat, plan.grey.map);
    const std::vector<Vector3> higher = answers.tiltsBeyond(plan.higher.flat, plan.higher.map);
    double turned = 0.0;
    double tilted = 0.0;
    for (std::size_t i = 0; i < grey.size(); ++i) {
        if (!(std::min(grey[i].magnitude(), higher[i].magnitude()) > kSomeTilt)) continue;
        tilted += 1.0;
        if (grey[i].dot(higher[i]) < 0.0) turned += 1.0;
    }
    return {turned / std::max(1.0, tilted), plan.isWhite};
}

}  // namespace ticker::tasks::bump

#include <grader/base/SplitMix.h>
#include <grader/lab/selftest/BumpReadings.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace ticker::selftest {
namespace {

/// Draws one choice after another; equal seeds draw equal choices.
class Choices {
public:
    explicit Choices(std::uint64_t seed) : state_(seed) {}

    template <typename T, std::size_t N>
    T oneOf(const std::array<T, N>& choices) {
        return choices[splitMix(state_) % N];
    }
    bool onceIn(std::uint64_t times) { return splitMix(state_) % times == 0; }

private:
    std::uint64_t state_;
};

// Choices outside the cross product are drawn, so that any two of them may occur together.
void drawOthers(Choices& choices, Reading& reading) {
    constexpr std::array kOrigins{0.5, 0.25, 0.0, 0.75, 0.5, 0.137};
    constexpr std::array kEdges{Reading::Edge::wrap, Reading::Edge::clamp, Reading::Edge::mirror};
    constexpr std::array kStrengths{0.2, 1.0, 5.0, 20.0};
    constexpr std::array kTops{Reading::Top::y, Reading::Top::y, Reading::Top::y,
                               Reading::Top::y, Reading::Top::z, Reading::Top::x};
    reading.uOrigin = choices.oneOf(kOrigins);
    reading.edge = choices.oneOf(kEdges);
    reading.strength = choices.oneOf(kStrengths);
    reading.lessOne = choices.onceIn(5);
    reading.singlePrecision = choices.onceIn(2);
    reading.top = choices.oneOf(kTops);
    if (choices.onceIn(4)) reading.tangents = Reading::Tangents::numeric;
    if (choices.onceIn(3)) reading.angle = Reading::PolarAngle::arcTangent;
    if (choices.onceIn(6)) reading.heights = Reading::Heights::rounded;
    // A surface cannot be displaced by more than its radius.
    if (reading.gain == Reading::Gain::displaced)
        reading.strength = std::min(reading.strength, 1.0);
}

constexpr std::array kGains{Reading::Gain::unit,        Reading::Gain::sine,
                            Reading::Gain::inverseSine, Reading::Gain::mapUnits,
                            Reading::Gain::blinn,       Reading::Gain::equation,
                            Reading::Gain::displaced,   Reading::Gain::displacedUnit};
constexpr std::array kSamplings{Reading::Sampling::floor, Reading::Sampling::round,
                                Reading::Sampling::bilinear, Reading::Sampling::bicubic};
constexpr std::array kDifferences{Reading::Difference::forward, Reading::Difference::backward,
                                  Reading::Difference::central, Reading::Difference::wide,
                                  Reading::Difference::sobel};

}  // namespace

std::vector<Reading> acceptedReadings(std::uint64_t seed) {
    Choices choices(seed);
    constexpr int kRounds = 2;  // each with other choices of everything else
    std::vector<Reading> readings;
    for (const Reading::Gain gain : kGains)
        for (const Reading::Sampling sampling : kSamplings)
            for (const Reading::Difference difference : kDifferences)
                for (const bool mirrored : {false, true})
                    for (int round = 0; round < kRounds; ++round) {
                        Reading reading;
                        reading.gain = gain;
                        reading.sampling = sampling;
                        reading.difference = difference;
                        reading.mirrored = mirrored;
                        drawOthers(choices, reading);
                        readings.push_back(reading);
                    }
    return readings;
}

std::vector<Reading> readingsForMistakes() {
    std::vector<Reading> readings;
    const std::vector<Reading> all = acceptedReadings(1);
    constexpr std::size_t kStep = 19;
    // Code that rounds heights is judged by a second run, with slopes of whole bytes, which names
    // fewer mistakes: so at most one reading in eight rounds.
    constexpr std::size_t kRounds = 8;
    for (std::size_t i = 0; i < all.size(); i += kStep) {
        readings.push_back(all[i]);
        if (readings.size() % kRounds != 0) readings.back().heights = Reading::Heights::given;
    }
    return readings;
}

std::vector<Mistake> allMistakes() {
    std::vector<Mistake> mistakes;
    for (int i = 1; i <= static_cast<int>(kLastMistake); ++i)
        mistakes.push_back(static_cast<Mistake>(i));
    return mistakes;
}

Reading fittingFor(Mistake mistake, Reading reading) {
    // With W - 1 the last column is reached at the seam alone.
    if (mistake == Mistake::noWrap || mistake == Mistake::noLastRow) reading.lessOne = false;
    // Around another axis either orientation of a map is accepted.
    if (mistake == Mistake::upsideDown) reading.top = Reading::Top::y;
    // A sixth of a difference is below 1: as an int it is 0, and the sphere is flat.
    if (mistake == Mistake::wholeNumbers) reading.difference = Reading::Difference::forward;
    // A neighbour three times as far away would lie across the seam for a tenth of the map.
    if (mistake == Mistake::farNeighbour) reading.difference = Reading::Difference::forward;
    // With turned tangents, P_u x P_v is perpendicular to the normal at the equator, and Blinn's
    // form divides by its part along the normal.
    if (mistake == Mistake::otherOrigin && reading.gain == Reading::Gain::blinn)
        reading.gain = Reading::Gain::equation;
    // A NaN polar angle makes an invalid row; with clamped rows only the tangents are wrong.
    if (mistake == Mistake::acosBeyondOne) reading.edge = Reading::Edge::clamp;
    // These mistakes concern the height itself.
    if (mistake == Mistake::darkHalf || mistake == Mistake::signedBytes ||
        mistake == Mistake::byteDifference)
        reading.heights = Reading::Heights::given;
    // Numeric tangents have zero length at the poles, where this angle often is.
    if (mistake == Mistake::clampedAcos) reading.tangents = Reading::Tangents::formula;
    return reading;
}

bool canHaveMistake(const Reading& reading, Mistake mistake) {
    constexpr std::array kOfAnySurface{Mistake::invertedU, Mistake::invertedV, Mistake::inverted,
                                       Mistake::swapped, Mistake::swappedHalf};
    return !isDisplaced(reading) ||
           std::find(kOfAnySurface.begin(), kOfAnySurface.end(), mistake) != kOfAnySurface.end();
}

}  // namespace ticker::selftest

#include <grader/lab/selftest/BumpReadings.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace ticker::selftest {
namespace {

// Choices outside the cross product alternate, so that all of them occur.
void takeTurns(std::vector<Reading>& readings) {
    constexpr std::array kOrigins{0.5, 0.25, 0.0, 0.75, 0.5, 0.137};
    constexpr std::array kEdges{Reading::Edge::wrap, Reading::Edge::clamp, Reading::Edge::mirror};
    constexpr std::array kStrengths{0.2, 1.0, 5.0, 20.0};
    for (std::size_t i = 0; i < readings.size(); ++i) {
        Reading& reading = readings[i];
        reading.uOrigin = kOrigins[i % kOrigins.size()];
        reading.edge = kEdges[(i / 2) % kEdges.size()];
        reading.strength = kStrengths[(i / 3) % kStrengths.size()];
        reading.lessOne = i % 5 == 1;
        reading.singlePrecision = i % 7 >= 4;
        reading.top = i % 11 == 3   ? Reading::Top::z
                      : i % 11 == 7 ? Reading::Top::x
                                    : Reading::Top::y;
        reading.tangents = i % 4 == 2 ? Reading::Tangents::numeric : Reading::Tangents::formula;
        reading.angle = i % 3 == 2 ? Reading::PolarAngle::arcTangent : Reading::PolarAngle::cosine;
        reading.heights = i % 13 == 5 ? Reading::Heights::rounded : Reading::Heights::given;
        // A surface cannot be displaced by more than its radius.
        if (reading.gain == Reading::Gain::displaced)
            reading.strength = std::min(reading.strength, 1.0);
    }
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

std::vector<Reading> acceptedReadings() {
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
                        readings.push_back(reading);
                    }
    takeTurns(readings);
    return readings;
}

std::vector<Reading> readingsForMistakes() {
    std::vector<Reading> readings;
    const std::vector<Reading> all = acceptedReadings();
    constexpr std::size_t kStep = 19;
    for (std::size_t i = 0; i < all.size(); i += kStep)
        readings.push_back(all[i]);
    return readings;
}

std::vector<Mistake> allMistakes() {
    std::vector<Mistake> mistakes;
    for (int i = 1; i <= static_cast<int>(kLastMistake); ++i)
        mistakes.push_back(static_cast<Mistake>(i));
    return mistakes;
}

Reading fittingFor(Mistake mistake, Reading reading) {
    // Around another axis either orientation of a map is accepted.
    if (mistake == Mistake::upsideDown) reading.top = Reading::Top::y;
    // A sixth of a difference is never a whole number: that sphere is flat.
    if (mistake == Mistake::wholeNumbers) reading.difference = Reading::Difference::forward;
    // Three times as far, it would reach across the seam from a tenth of the map.
    if (mistake == Mistake::farNeighbour) reading.difference = Reading::Difference::forward;
    // Turned tangents enclose no area at the equator, and Blinn's form divides by it.
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

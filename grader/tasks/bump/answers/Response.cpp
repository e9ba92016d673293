#include <grader/tasks/bump/answers/Response.h>

#include <grader/tasks/bump/answers/Replies.h>
#include <grader/tasks/bump/questions/Numbers.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>

namespace ticker::tasks::bump {
namespace {

// Points nearer than this to a pole or the seam are left out: code may treat them specially, and
// differences over a hundredth of the map reach this far.
constexpr double kPoleMargin = 8.0 / 180.0;
constexpr double kSeamMargin = 0.012;
// A tilt below this share of the usual one counts as no tilt. Tilts that shrink with sin theta stay
// above it: at 8 degrees from the pole it is 0.14.
constexpr double kDeadShare = 0.01;
// Isolated points may stray for unknown reasons, but not so many that a picture shows them.
constexpr double kAlmostAll = 0.985;

Replies ordinaryReplies(const std::vector<RampTilts>& tilts,
                        const Parametrisation& parametrisation) {
    Replies replies;
    for (const RampTilts& tilt : tilts) {
        const double u = parametrisation.u(tilt.direction);
        const double v = parametrisation.v(tilt.direction);
        if (std::min(v, 1.0 - v) < kPoleMargin || turnDistance(u, 0.0) < kSeamMargin) continue;
        const Vector3 alongU = parametrisation.alongU(tilt.direction);
        const Vector3 alongV = parametrisation.alongV(tilt.direction);
        if (isFinite(tilt.onURamp))
            replies.onU.push_back({tilt.direction, u, v, alongU, alongV, tilt.onURamp});
        if (isFinite(tilt.onVRamp))
            replies.onV.push_back({tilt.direction, u, v, alongV, alongU, tilt.onVRamp});
    }
    return replies;
}

SenseShares countSenses(const std::vector<Reply>& replies, double deadLength) {
    SenseShares shares;
    for (const Reply& reply : replies) {
        const double angle = reply.angle();
        if (!(reply.tilt.magnitude() > deadLength))
            shares.dead += 1.0;
        else if (near(angle, 0.0))
            shares.right += 1.0;
        else if (near(angle, kPi))
            shares.inverted += 1.0;
        else if (near(angle, 0.5 * kPi) || near(angle, -0.5 * kPi))
            shares.across += 1.0;
    }
    const double count = std::max<double>(1.0, static_cast<double>(replies.size()));
    return {shares.right / count, shares.inverted / count, shares.across / count,
            shares.dead / count};
}

Sense senseOf(const SenseShares& shares) {
    if (shares.right >= kAlmostAll) return Sense::right;
    if (shares.inverted >= kAlmostAll) return Sense::inverted;
    if (shares.across >= kAlmostAll) return Sense::across;
    if (shares.dead >= kAlmostAll) return Sense::dead;
    return Sense::mixed;
}

/// Mean unit vectors of the directions, for each band and sector.
using Cells = std::array<std::array<std::complex<double>, kSectors>, kBands>;

Cells meanDirections(const std::vector<Reply>& replies, double deadLength) {
    Cells sums{};
    std::array<std::array<double, kSectors>, kBands> counts{};
    for (const Reply& reply : replies) {
        counts[reply.band()][reply.sector()] += 1.0;
        if (reply.tilt.magnitude() > deadLength)
            sums[reply.band()][reply.sector()] += std::polar(1.0, reply.angle());
    }
    for (std::size_t band = 0; band < kBands; ++band)
        for (std::size_t sector = 0; sector < kSectors; ++sector)
            sums[band][sector] /= std::max(1.0, counts[band][sector]);
    return sums;
}

/// Disagreement between the sectors of a band: 0 if all agree, or if no sector has a clear
/// direction (the direction changes with latitude); 1 if their directions cancel out.
double disagreement(const std::array<std::complex<double>, kSectors>& sectors) {
    double lengths = 0.0;
    std::complex<double> sum;
    for (const std::complex<double>& sector : sectors) {
        lengths += std::abs(sector);
        sum += sector;
    }
    return (lengths - std::abs(sum)) / static_cast<double>(kSectors);
}

void describeBands(const std::vector<Reply>& replies, double deadLength, AxisResponse& axis) {
    // Directions that turn with longitude give 0.5 and more, a direction that flips within a band
    // 0.25 (the mean of about 15 signs), right code less than 0.02.
    constexpr double kDisagree = 0.35;
    const Cells cells = meanDirections(replies, deadLength);
    for (std::size_t band = 0; band < kBands; ++band) {
        if (disagreement(cells[band]) > kDisagree) ++axis.bandsThatTurn;
        std::complex<double> sum;
        for (const std::complex<double>& cell : cells[band])
            sum += cell;
        axis.bandDirection[band] = std::arg(sum) * kDegrees;
        std::vector<Reply> members;
        std::copy_if(replies.begin(), replies.end(), std::back_inserter(members),
                     [band](const Reply& reply) { return reply.band() == band; });
        axis.bandStrength[band] = medianLength(members, &Reply::tilt);
    }
}

/// Largest ratio of two sectors' mean strengths. Every strength is first divided by the median of
/// its neighbours in polar angle, so that latitude does not count. Points without a tilt are left
/// out: they are counted as such, and neighbours among them would have the median 0.
double strengthRatio(std::vector<Reply> replies, double deadLength) {
    constexpr std::size_t kHalfWindow = 12;
    constexpr std::size_t kStrengthSectors = 16;
    std::erase_if(replies,
                  [=](const Reply& reply) { return !(reply.tilt.magnitude() > deadLength); });
    if (replies.size() < 8 * kHalfWindow) return 1.0;
    std::sort(replies.begin(), replies.end(),
              [](const Reply& a, const Reply& b) { return a.v < b.v; });
    std::array<std::vector<double>, kStrengthSectors> sectors;
    for (std::size_t i = kHalfWindow; i + kHalfWindow < replies.size(); ++i) {
        std::vector<double> window;
        for (std::size_t j = i - kHalfWindow; j <= i + kHalfWindow; ++j)
            window.push_back(replies[j].tilt.magnitude());
        const auto sector = std::min(kStrengthSectors - 1,
                                     static_cast<std::size_t>(replies[i].u * kStrengthSectors));
        sectors[sector].push_back(replies[i].tilt.magnitude() / median(window));
    }
    double least = 1e300;
    double most = 0.0;
    for (const std::vector<double>& sector : sectors) {
        if (sector.size() < 10) continue;
        double sum = 0.0;
        for (const double value : sector)
            sum += std::min(value, 4.0);
        least = std::min(least, sum / static_cast<double>(sector.size()));
        most = std::max(most, sum / static_cast<double>(sector.size()));
    }
    return most > 0.0 ? most / std::max(least, 1e-9) : 1.0;
}

void noteDead(const Vector3& at, AxisResponse& axis) {
    const bool first = axis.deadAt == Vector3{};
    const auto least = [](const Vector3& a, const Vector3& b) {
        return Vector3{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
    };
    axis.deadFrom = first ? at : least(axis.deadFrom, at);
    axis.deadTo = first ? at : -least(-axis.deadTo, -at);
    axis.deadAt = at;
}

void findWorst(const std::vector<Reply>& replies, double deadLength, AxisResponse& axis) {
    for (const Reply& reply : replies) {
        if (!(reply.tilt.magnitude() > deadLength)) {
            noteDead(reply.direction, axis);
            continue;
        }
        const double angle = reply.angle() * kDegrees;
        if (std::abs(angle) < std::abs(axis.worstDirection)) continue;
        axis.worstDirection = angle;
        axis.worst = reply.direction;
    }
}

std::array<double, 2> matrixRow(const std::vector<Reply>& replies) {
    double towards = 0.0;
    double sideways = 0.0;
    double length = 0.0;
    for (const Reply& reply : replies) {
        towards += reply.towards();
        sideways += reply.sideways();
        length += reply.tilt.magnitude();
    }
    if (!(length > 0.0)) return {0.0, 0.0};
    return {towards / length, sideways / length};
}

// True if the tilts deviate to one side in the mean over the sphere, even if each stays within its
// tolerance: a slope along one axis adds to the other's. Tangents computed at the texel do not
// count, because they deviate to opposite sides in the north and in the south. Right submissions
// from outside had at most 0.0004.
bool leans(const std::vector<Reply>& replies) {
    constexpr double kMost = 0.04;
    const auto [towards, sideways] = matrixRow(replies);
    return std::abs(sideways) > kMost && std::abs(sideways) < std::abs(towards);
}

AxisResponse measureAxis(const std::vector<Reply>& replies, double usualLength) {
    AxisResponse axis;
    const double own = medianLength(replies, &Reply::tilt);
    // An axis whose tilts are below a ten-thousandth of the other's counts as not tilted.
    const double deadLength = std::max(kDeadShare * own, 1e-4 * usualLength);
    axis.shares = countSenses(replies, deadLength);
    axis.sense = senseOf(axis.shares);
    if (axis.sense == Sense::dead) return axis;
    if (leans(replies)) axis.sense = Sense::mixed;
    describeBands(replies, deadLength, axis);
    axis.strengthRatio = strengthRatio(replies, deadLength);
    findWorst(replies, deadLength, axis);
    return axis;
}

}  // namespace

bool Response::dependsOnLongitude() const {
    constexpr int kFewestBands = 3;
    // Right code gives 1.1 (the exact normal of the displaced surface is weaker where the surface
    // is higher), and 10 percent of noise if differences cover one texel in some places and two in
    // others.
    constexpr double kUnequal = 1.8;
    return u.bandsThatTurn >= kFewestBands || v.bandsThatTurn >= kFewestBands ||
           u.strengthRatio > kUnequal || v.strengthRatio > kUnequal || tangentTurn != 0.0;
}

Response measureResponse(const std::vector<RampTilts>& tilts,
                         const Parametrisation& parametrisation) {
    const Replies replies = ordinaryReplies(tilts, parametrisation);
    const double usual =
        std::max(medianLength(replies.onU, &Reply::tilt), medianLength(replies.onV, &Reply::tilt));
    Response response;
    response.u = measureAxis(replies.onU, usual);
    response.v = measureAxis(replies.onV, usual);
    const auto u = matrixRow(replies.onU);
    const auto v = matrixRow(replies.onV);
    response.matrix = {{{u[0], u[1]}, {v[1], v[0]}}};
    if (response.u.sense == Sense::mixed || response.v.sense == Sense::mixed)
        explainTangents(replies, parametrisation, response);
    return response;
}

double strengthAt(const AxisResponse& axis, double v) {
    const double at = std::clamp(v * kBands - 0.5, 0.0, static_cast<double>(kBands - 1));
    const auto low = std::min(kBands - 2, static_cast<std::size_t>(at));
    const double share = at - static_cast<double>(low);
    return axis.bandStrength[low] * (1.0 - share) + axis.bandStrength[low + 1] * share;
}

}  // namespace ticker::tasks::bump

#include <grader/tasks/bump/questions/Slopes.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

namespace ticker::tasks::bump {
namespace {

using probe::HeightMapDescription;

constexpr int kToothStep = 4;
constexpr int kTooth = 64;  // texels: 63 steps of 4 bytes

std::vector<double> sawtooth(int count) {
    std::vector<double> heights;
    for (int i = 0; i < count; ++i)
        heights.push_back(kByte * kToothStep * (i % kTooth));
    return heights;
}

/// Cosine and sine of a phase that grows evenly over `count` texels.
struct Phases {
    std::vector<double> cosines;
    std::vector<double> sines;

    Phases(int count, double times, double start) {
        for (int i = 0; i < count; ++i) {
            const double phase = kTurn * times * (i + 0.5) / count + start;
            cosines.push_back(std::cos(phase));
            sines.push_back(std::sin(phase));
        }
    }
};

/// Adds cos(column phase + row phase) to every texel.
void addWave(std::vector<double>& values, const Phases& columns, const Phases& rows) {
    std::size_t at = 0;
    for (std::size_t row = 0; row < rows.cosines.size(); ++row)
        for (std::size_t column = 0; column < columns.cosines.size(); ++column)
            values[at++] += rows.cosines[row] * columns.cosines[column] -
                            rows.sines[row] * columns.sines[column];
}

/// Random bytes from 32 to 224. The waves are periodic round the sphere.
/// @param times  1: the shortest are 45 texels long; n: a n-th of that.
HeightMapDescription randomField(Draws& draws, int times) {
    constexpr int kFieldWidth = 420;
    constexpr int kFieldHeight = 230;
    constexpr int kWaves = 6;
    std::vector<double> values(static_cast<std::size_t>(kFieldWidth) * kFieldHeight, 0.0);
    for (int wave = 0; wave < kWaves; ++wave) {
        // The first two waves ensure some slope along each axis.
        const double round = wave == 0 ? 7.0 : draws.integer(-8, 8);
        const double down = wave == 1 ? 4.0 : draws.uniform(-4.5, 4.5);
        addWave(values, Phases(kFieldWidth, times * round, draws.uniform(0.0, kTurn)),
                Phases(kFieldHeight, times * down, 0.0));
    }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double low = *least;
    const double scale = 192.0 / (*most - low);
    HeightMapDescription map{kFieldWidth, kFieldHeight, {}, {}, {}};
    map.bytes.reserve(values.size());
    for (const double value : values)
        map.bytes.push_back(static_cast<std::uint8_t>(32.5 + (value - low) * scale));
    return map;
}

double byteAt(const HeightMapDescription& map, int column, int row) {
    const int c = (column + map.width) % map.width;
    const int r = std::clamp(row, 0, map.height - 1);
    return map.bytes[static_cast<std::size_t>(r * map.width + c)];
}

int texel(double coordinate, int count) {
    return std::clamp(static_cast<int>(coordinate * count), 0, count - 1);
}

/// Agreement of signs between observed and expected values: 1 always, -1 never. Large pairs weigh
/// more. The scale of the observed values does not matter: the code may choose its strength.
class SignAgreement {
public:
    void add(double expected, double seen) {
        if (!std::isfinite(seen)) return;
        sum_ += expected * seen;
        size_ += std::abs(expected * seen);
    }
    [[nodiscard]] double value() const { return size_ > 0.0 ? sum_ / size_ : 0.0; }

private:
    double sum_ = 0.0;
    double size_ = 0.0;
};

/// Share of the tilted ordinary points for which `leans(tilt, direction)` holds.
template <typename Leans>
double share(const std::vector<Vector3>& directions, const std::vector<Vector3>& tilts,
             const Parametrisation& parametrisation, Leans leans) {
    constexpr double kNothing = 1e-9;
    double right = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        if (!isOrdinary(parametrisation, directions[i])) continue;
        if (!(tilts[i].magnitude() > kNothing)) continue;
        count += 1.0;
        if (leans(tilts[i], directions[i])) right += 1.0;
    }
    return right / std::max(1.0, count);
}

/// @return  The agreement along u and along v.
std::pair<double, double> readField(const LevelPair& field, const std::vector<Vector3>& directions,
                                    const Answers& answers, const Parametrisation& parametrisation,
                                    const Response& response) {
    const HeightMapDescription& map = answers.asked().question(field.map).map;
    const std::vector<Vector3> tilts = answers.tiltsBeyond(field.flat, field.map);
    SignAgreement alongU;
    SignAgreement alongV;
    for (std::size_t i = 0; i < tilts.size(); ++i) {
        const Vector3& n = directions[i];
        if (!isOrdinary(parametrisation, n)) continue;
        const double u = parametrisation.u(n);
        const double v = parametrisation.v(n);
        alongU.add(slopeAlongU(map, u, v) * strengthAt(response.u, v),
                   -response.u.sign() * tilts[i].dot(parametrisation.alongU(n)));
        alongV.add(slopeAlongV(map, u, v) * strengthAt(response.v, v),
                   -response.v.sign() * tilts[i].dot(parametrisation.alongV(n)));
    }
    return {alongU.value(), alongV.value()};
}

}  // namespace

SlopePlan planSlopes(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    constexpr int kPoints = 250;
    constexpr int kFieldPoints = 800;
    constexpr int kSmallPoints = 400;
    constexpr int kAlong = 1024;
    // Code may take a texel of this side for its step along the teeth, too, which then smears a
    // fifth of each tooth.
    constexpr int kAcross = 160;
    SlopePlan plan;
    plan.directions = draws.directions(kPoints);
    plan.fieldDirections = draws.directions(kFieldPoints);
    plan.sawtoothU = questionnaire.addPair(
        ball, {kAlong, kAcross, {}, sawtooth(kAlong), raytracer::questions::level(kAcross)},
        plan.directions);
    plan.sawtoothV = questionnaire.addPair(
        ball, {kAcross, kAlong, {}, raytracer::questions::level(kAcross), sawtooth(kAlong)},
        plan.directions);
    plan.field = questionnaire.addPair(ball, randomField(draws, 1), plan.fieldDirections);
    const double x = draws.uniform(-0.9, 0.9);
    const Ball small{{x, draws.uniform(-0.9, 0.9), 2.0}, 0.05};
    plan.smallDirections = draws.directions(kSmallPoints);
    // A step of 0.01 in the world is half as long as the shortest waves. A step of a hundredth of
    // the map is a sixth as long, and 0.96 of its slopes agree.
    plan.smallField = questionnaire.addPair(small, randomField(draws, 2), plan.smallDirections);
    return plan;
}

SlopeAgreement readSlopes(const SlopePlan& plan, const Answers& answers,
                          const Parametrisation& parametrisation, const Response& response) {
    const auto leansU = [&](const Vector3& tilt, const Vector3& n) {
        return -response.u.sign() * tilt.dot(parametrisation.alongU(n)) > 0.5 * tilt.magnitude();
    };
    const auto leansV = [&](const Vector3& tilt, const Vector3& n) {
        return -response.v.sign() * tilt.dot(parametrisation.alongV(n)) > 0.5 * tilt.magnitude();
    };
    const auto measure = [&](const LevelPair& pair, const auto& leans) {
        return share(plan.directions, answers.tiltsBeyond(pair.flat, pair.map), parametrisation,
                     leans);
    };
    SlopeAgreement agreement;
    agreement.sawtoothU = measure(plan.sawtoothU, leansU);
    agreement.sawtoothV = measure(plan.sawtoothV, leansV);
    std::tie(agreement.fieldU, agreement.fieldV) =
        readField(plan.field, plan.fieldDirections, answers, parametrisation, response);
    std::tie(agreement.smallU, agreement.smallV) =
        readField(plan.smallField, plan.smallDirections, answers, parametrisation, response);
    return agreement;
}

double slopeAlongU(const HeightMapDescription& map, double u, double v) {
    const int column = texel(u, map.width);
    const int row = texel(v, map.height);
    return 0.5 * kByte * (byteAt(map, column + 1, row) - byteAt(map, column - 1, row));
}

double slopeAlongV(const HeightMapDescription& map, double u, double v) {
    const int column = texel(u, map.width);
    const int row = texel(v, map.height);
    return 0.5 * kByte * (byteAt(map, column, row + 1) - byteAt(map, column, row - 1));
}

}  // namespace ticker::tasks::bump

#include <grader/oracle/Replicate.h>

#include <grader/oracle/Kernel.h>
#include <grader/oracle/Lattice.h>
#include <grader/oracle/Tiles.h>

namespace ticker::oracle {
namespace {

std::uint32_t keyOf(std::uint64_t seed, std::uint64_t number, int pixel) {
    const auto low = static_cast<std::uint32_t>(seed);
    const auto high = static_cast<std::uint32_t>(seed >> 32U);
    const std::uint32_t run = mixed(mixed(mixed(low) + high) + static_cast<std::uint32_t>(number));
    return mixed(run + static_cast<std::uint32_t>(pixel));
}

/// Paths of one tile, pixel after pixel.
class TileMoments {
public:
    TileMoments(const Setup& setup, Workspace& work, Replicate& result)
        : setup_(setup), work_(work), result_(result) {}

    void add(int pixel, std::uint32_t key, std::uint32_t sample) {
        if (work_.paths == kPaths) flush();
        const std::size_t at = work_.paths++;
        work_.column[at] = pixel % setup_.width;
        work_.row[at] = pixel / setup_.width;
        work_.sample[at] = sample;
        work_.randomisation[at] = key;
        pixelOf_[at] = static_cast<std::size_t>(pixel);
    }
    void flush() {
        if (work_.paths == 0) return;
        const bool straight = setup_.mistake.allOrNothing || setup_.mistake.litIfAny;
        const bool paired = setup_.tricks.pairedShadows && !straight;
        LaneSeeds none{};
        tracePaths(setup_, paired ? Drawing::paired : Drawing::independent, work_, none);
        for (std::size_t i = 0; i < work_.paths; ++i)
            addPath(i, paired, result_[pixelOf_[i]]);
        work_.paths = 0;
    }

private:
    void addPath(std::size_t i, bool paired, PathMoments& sum) const {
        constexpr std::size_t kFirst[6] = {0, 1, 2, 0, 0, 1};
        constexpr std::size_t kSecond[6] = {0, 1, 2, 1, 2, 2};
        const auto& colour = work_.colour;
        const auto& other = paired ? work_.pairedColour : work_.colour;
        for (std::size_t c = 0; c < 3; ++c)
            sum.mean[c] += 0.5 * (double{colour[c][i]} + double{other[c][i]});
        for (std::size_t e = 0; e < 6; ++e) {
            const std::size_t a = kFirst[e];
            const std::size_t b = kSecond[e];
            sum.second[e] += 0.5 * (double{colour[a][i]} * double{other[b][i]} +
                                    double{colour[b][i]} * double{other[a][i]});
            if (paired) sum.noise[e] += double{work_.noise[e][i]};
        }
    }

    const Setup& setup_;
    Workspace& work_;
    Replicate& result_;
    std::array<std::size_t, kPaths> pixelOf_{};
};

}  // namespace

PathMoments& PathMoments::operator+=(const PathMoments& other) {
    for (std::size_t c = 0; c < 3; ++c)
        mean[c] += other.mean[c];
    for (std::size_t e = 0; e < 6; ++e) {
        second[e] += other.second[e];
        noise[e] += other.noise[e];
    }
    return *this;
}

PathMoments& PathMoments::operator*=(double factor) {
    for (double& value : mean)
        value *= factor;
    for (std::size_t e = 0; e < 6; ++e) {
        second[e] *= factor;
        noise[e] *= factor;
    }
    return *this;
}

Replicate replicate(const Setup& setup, std::uint64_t seed, std::uint64_t number,
                    const std::vector<std::uint32_t>& counts) {
    Replicate result(counts.size());
    forEachTile(static_cast<int>(counts.size()), setup.settings.threads, setup.settings.monitor,
                [&](const Tile& tile, Workspace& work) {
                    work.paths = 0;
                    TileMoments moments{setup, work, result};
                    for (int pixel = tile.first; pixel < tile.end; ++pixel) {
                        const std::uint32_t key = keyOf(seed, number, pixel);
                        for (std::uint32_t i = 0; i < counts[static_cast<std::size_t>(pixel)]; ++i)
                            moments.add(pixel, key, i);
                    }
                    moments.flush();
                    for (int pixel = tile.first; pixel < tile.end; ++pixel)
                        result[static_cast<std::size_t>(pixel)] *=
                            1.0 / counts[static_cast<std::size_t>(pixel)];
                });
    return result;
}

}  // namespace ticker::oracle

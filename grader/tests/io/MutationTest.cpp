// Valid files, damaged at random: whatever comes of it must be a value or an InputError. Run under
// the sanitizers this also shows that nothing is read or written out of bounds.
#include "PngBuilder.h"
#include "TemporaryFolder.h"

#include <raytracer/base/Error.h>
#include <raytracer/io/ImageWriter.h>
#include <raytracer/io/SceneReader.h>

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace raytracer {
namespace {

using ticker::testing::bytesOf;
using ticker::testing::TemporaryFolder;

class Mutator {
public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    /// One to four bytes replaced, removed, doubled, or a stretch cut away.
    std::string damaged(std::string bytes) {
        for (std::size_t changes = 1 + below(4); changes > 0 && !bytes.empty(); --changes)
            damage(bytes);
        return bytes;
    }

private:
    std::size_t below(std::size_t limit) { return random_() % limit; }

    void damage(std::string& bytes) {
        const std::size_t place = below(bytes.size());
        switch (below(5)) {
            case 0:
                bytes[place] = static_cast<char>(below(256));
                break;
            case 1:
                bytes[place] = static_cast<char>(bytes[place] ^ (1 << below(7)));
                break;
            case 2:
                bytes.erase(place, 1 + below(8));
                break;
            case 3:
                bytes.insert(place, bytes.substr(below(bytes.size()), 1 + below(40)));
                break;
            default:
                if (below(8) == 0) bytes.resize(place);
        }
    }

    std::mt19937 random_;
};

struct Tally {
    int accepted = 0;
    int refused = 0;
};

template <typename Reader>
Tally tryDamaged(const std::string& good, unsigned seed, int times, Reader read) {
    Mutator mutator(seed);
    Tally tally;
    for (int i = 0; i < times; ++i) {
        try {
            read(mutator.damaged(good));
            ++tally.accepted;
        } catch (const InputError& error) {
            EXPECT_FALSE(std::string(error.what()).empty());
            ++tally.refused;
        }
    }
    return tally;
}

TEST(DamagedScenes, AreReadOrRefused) {
    const TemporaryFolder folder;
    const std::string source = TICKER_SOURCE_DIR;
    for (const std::string name : {"distributed.xml", "penumbra.xml", "lens-grid.xml"}) {
        const Tally tally =
            tryDamaged(bytesOf(source + "/scenes/" + name), 1, 1500, [&](const std::string& bytes) {
                (void)readScene(folder.write("scene.xml", bytes), {});
            });
        EXPECT_GT(tally.accepted, 0) << name;
        EXPECT_GT(tally.refused, 0) << name;
    }
}

TEST(DamagedPictures, AreReadOrRefused) {
    const TemporaryFolder folder;
    ByteImage picture{40, 30, {}};
    for (unsigned i = 0; i < 40U * 30U * 3U; ++i)
        picture.rgb.push_back(static_cast<std::uint8_t>(i * i / 97U));
    writePng(picture, folder.path() / "good.png");

    const Tally tally =
        tryDamaged(bytesOf(folder.path() / "good.png"), 2, 20'000,
                   [](const std::string& bytes) { (void)decodeImage(bytes, "damaged.png"); });
    EXPECT_GT(tally.accepted, 0);
    EXPECT_GT(tally.refused, 0);
}

TEST(DamagedPictures, OfEveryKindAreReadOrRefused) {
    using ticker::testing::PngColour;
    unsigned seed = 100;
    for (const PngColour colour :
         {PngColour::grey, PngColour::rgb, PngColour::greyAlpha, PngColour::rgbAlpha, PngColour{3}})
        for (const unsigned depth : {1U, 4U, 8U, 16U}) {
            const ticker::testing::PngHeader header{9, 7, static_cast<std::uint8_t>(depth), colour};
            const std::string good =
                makePng(header, equalRows(header, std::string(9 * depth / 2, 'a')));
            const Tally tally = tryDamaged(good, ++seed, 1000, [](const std::string& bytes) {
                (void)decodeImage(bytes, "damaged.png");
            });
            EXPECT_EQ(tally.accepted + tally.refused, 1000);
        }
}

}  // namespace
}  // namespace raytracer

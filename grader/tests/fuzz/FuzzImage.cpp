// Pictures: the framework's reader of bump maps, and the decoder of students' screenshots. If both
// accept a picture, they must give the same pixels.
#include "../io/PngBuilder.h"
#include "../support/Files.h"
#include "Fuzz.h"

#include <grader/picture/DecodePicture.h>
#include <grader/picture/decoder/DecodePng.h>

#include <raytracer/base/Error.h>
#include <raytracer/io/ImageReader.h>
#include <raytracer/io/ImageWriter.h>

#include <optional>
#include <span>

namespace ticker::fuzz {
namespace {

// So that one input is fast; the readers' own limits have other tests.
constexpr std::uint64_t kMostPixels = 1U << 18U;

std::uint32_t bigEndian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char byte : bytes.substr(0, 4))
        value = value << 8U | static_cast<unsigned char>(byte);
    return value;
}

// Mutations rarely keep check sums right; corrected sums let them reach more of the code.
std::string withRightSums(std::string bytes) {
    constexpr std::size_t kAround = 12;  // length, type, check sum
    for (std::size_t at = 8; at + kAround <= bytes.size();) {
        const std::size_t size = bigEndian(std::string_view{bytes}.substr(at));
        if (size > bytes.size() - at - kAround) break;
        const std::string chunk =
            testing::pngChunk(bytes.substr(at + 4, 4), bytes.substr(at + 8, size));
        bytes.replace(at, chunk.size(), chunk);
        at += chunk.size();
    }
    return bytes;
}

std::optional<raytracer::ByteImage> byFramework(std::string_view input) {
    try {
        return raytracer::decodeImage(input, "input");
    } catch (const raytracer::InputError&) {
        return std::nullopt;
    }
}

std::optional<std::vector<std::uint8_t>> byDecoder(std::string_view input,
                                                   picture::PictureSize size) {
    std::vector<std::uint8_t> pixels(std::size_t{size.width} * size.height * 3);
    const std::span file{reinterpret_cast<const std::uint8_t*>(input.data()), input.size()};
    if (picture::decodePng(file, pixels) != picture::DecodeState::decoded) return std::nullopt;
    return pixels;
}

bool giveOnce(std::string_view input) {
    const std::optional<picture::PictureSize> size = picture::claimedSize(input);
    if (size && std::uint64_t{size->width} * size->height > kMostPixels) return false;
    const std::optional<raytracer::ByteImage> image = byFramework(input);
    if (image)
        require(image->rgb.size() == static_cast<std::size_t>(image->width) *
                                         static_cast<std::size_t>(image->height) * 3,
                "a picture has as many pixels as it says");
    if (!size) return image.has_value();
    const auto pixels = byDecoder(input, *size);
    require(!pixels || !image || *pixels == image->rgb, "both readers see the same picture");
    return pixels || image;
}

}  // namespace

bool give(std::string_view input) {
    const bool taken = giveOnce(input);
    return giveOnce(withRightSums(std::string{input})) || taken;
}

std::vector<std::string> seeds() {
    using testing::PngColour;
    raytracer::ByteImage picture{40, 30, {}};
    for (unsigned i = 0; i < 40U * 30U * 3U; ++i)
        picture.rgb.push_back(static_cast<std::uint8_t>(i * i / 97U));
    std::vector<std::string> files{raytracer::encodePng(picture)};
    for (const PngColour colour :
         {PngColour::grey, PngColour::rgb, PngColour::greyAlpha, PngColour::rgbAlpha, PngColour{3}})
        for (const unsigned depth : {1U, 2U, 4U, 8U, 16U})
            for (const bool interlaced : {false, true}) {
                const testing::PngHeader header{9, 7, static_cast<std::uint8_t>(depth), colour,
                                                interlaced};
                files.push_back(makePng(header, equalRows(header, std::string(72, 'a'))));
            }
    return files;
}

}  // namespace ticker::fuzz

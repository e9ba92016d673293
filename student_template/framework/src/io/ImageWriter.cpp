#include "FileBytes.h"

#include <raytracer/base/Error.h>
#include <raytracer/image/ToneCurve.h>
#include <raytracer/io/ImageWriter.h>

#include <stb_image_write.h>

#include <bit>
#include <cstdint>
#include <string>

namespace raytracer {
namespace {

constexpr int kRgbChannels = 3;

void append(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
}

void appendFloat(std::string& bytes, double value) {
    auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    for (int i = 0; i < 4; ++i) {
        bytes += static_cast<char>(bits & 0xFFU);
        bits >>= 8U;
    }
}

}  // namespace

ByteImage toBytes(const Image& image) {
    ByteImage bytes{image.width(), image.height(), {}};
    bytes.rgb.reserve(image.pixels().size() * kRgbChannels);
    for (const ColourRGB& colour : image.pixels())
        for (const std::uint8_t channel : toneMapped(colour))
            bytes.rgb.push_back(channel);
    return bytes;
}

std::string encodePng(const ByteImage& image) {
    std::string bytes;
    const int written =
        stbi_write_png_to_func(append, &bytes, image.width, image.height, kRgbChannels,
                               image.rgb.data(), image.width * kRgbChannels);
    if (written == 0) throw Error("a picture cannot be packed as PNG");
    return bytes;
}

void writePng(const ByteImage& image, const std::filesystem::path& file) {
    checkWritable(file);
    replaceFile(file, encodePng(image));
}

void writePng(const Image& image, const std::filesystem::path& file) {
    writePng(toBytes(image), file);
}

void writePfm(const Image& image, const std::filesystem::path& file) {
    std::string bytes =
        "PF\n" + std::to_string(image.width()) + " " + std::to_string(image.height()) + "\n-1.0\n";
    for (int y = image.height() - 1; y >= 0; --y) {
        for (int x = 0; x < image.width(); ++x) {
            const ColourRGB& colour = image.at(x, y);
            for (const double channel : {colour.r, colour.g, colour.b})
                appendFloat(bytes, channel);
        }
    }
    replaceFile(file, bytes);
}

}  // namespace raytracer

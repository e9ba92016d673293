#include "FileBytes.h"

#include <raytracer/base/Error.h>
#include <raytracer/io/ImageReader.h>

#include <stb_image.h>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace raytracer {
namespace {

constexpr std::size_t kLargestFile = 64ULL * 1024 * 1024;
constexpr int kLargestSide = 16'384;
constexpr std::int64_t kMostPixels = 64'000'000;
constexpr int kChannels = 3;

struct FreeStb {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

std::string kindOf(std::string_view bytes) {
    if (bytes.empty()) return "the file is empty";
    if (bytes.starts_with("\xFF\xD8\xFF")) return "this is a JPEG picture";
    if (bytes.starts_with("GIF8")) return "this is a GIF picture";
    if (bytes.starts_with("BM")) return "this is a BMP picture";
    if (bytes.starts_with("P6") || bytes.starts_with("P5")) return "this is a PPM picture";
    if (bytes.substr(0, 12).ends_with("WEBP")) return "this is a WebP picture";
    return "this is no picture";
}

void checkSignature(std::string_view bytes, const std::string& name) {
    if (!bytes.starts_with("\x89PNG\r\n\x1A\n"))
        throw InputError(name, 0, kindOf(bytes) + "; expected a PNG file");
}

void checkSize(int width, int height, const std::string& name) {
    const bool fits = width >= 1 && height >= 1 && width <= kLargestSide &&
                      height <= kLargestSide && std::int64_t{width} * height <= kMostPixels;
    if (!fits)
        throw InputError(name, 0,
                         "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                             " pixels; expected at most 16384 on a side and 64 million in all");
}

[[noreturn]] void failBroken(const std::string& name) {
    const char* reason = stbi_failure_reason();
    throw InputError(name, 0,
                     std::string("the PNG file is damaged or of an unknown kind (") +
                         (reason != nullptr ? reason : "no reason given") + "); save it again");
}

}  // namespace

ByteImage decodeImage(std::string_view bytes, const std::string& name) {
    checkSignature(bytes, name);
    if (bytes.size() > kLargestFile) throw InputError(name, 0, "the file is larger than 64 MiB");
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());

    ByteImage image;
    int channelsInFile = 0;
    if (stbi_info_from_memory(data, size, &image.width, &image.height, &channelsInFile) == 0)
        failBroken(name);
    checkSize(image.width, image.height, name);

    const std::unique_ptr<stbi_uc, FreeStb> pixels{
        stbi_load_from_memory(data, size, &image.width, &image.height, &channelsInFile, kChannels)};
    if (pixels == nullptr) failBroken(name);
    const std::size_t count =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * kChannels;
    image.rgb.assign(pixels.get(), pixels.get() + count);
    return image;
}

ByteImage readImage(const std::filesystem::path& file) {
    return decodeImage(readFileBytes(file, kLargestFile), file.string());
}

HeightMap readHeightMap(const std::filesystem::path& file) {
    const ByteImage image = readImage(file);
    if (image.width < HeightMap::kSmallestSide || image.height < HeightMap::kSmallestSide)
        throw InputError(file.string(), 0,
                         "a bump map of " + std::to_string(image.width) + " x " +
                             std::to_string(image.height) + " pixels; expected at least " +
                             std::to_string(HeightMap::kSmallestSide) + " on each side");
    std::vector<double> heights;
    heights.reserve(image.rgb.size() / kChannels);
    for (std::size_t i = 0; i < image.rgb.size(); i += kChannels) {
        const int sum = image.rgb[i] + image.rgb[i + 1] + image.rgb[i + 2];
        heights.push_back(kBumpFactor * sum / (255.0 * kChannels));
    }
    return {image.width, image.height, std::move(heights)};
}

}  // namespace raytracer

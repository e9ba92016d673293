#include <grader/pipeline/Screenshot.h>

#include <grader/pipeline/Unpack.h>

#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <span>
#include <utility>

namespace ticker::pipeline {
namespace {

constexpr std::string_view kSignature{"\x89PNG\r\n\x1A\n", 8};
constexpr int kLargestSide = 16384;  // as the picture reader: raytracer/io/ImageReader.h

std::uint32_t bigEndian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = (value << 8U) | static_cast<unsigned char>(bytes[i]);
    return value;
}

// CRC-32 as PNG uses it (ISO 3309), half a byte at a time.
std::uint32_t checkSum(std::string_view bytes) {
    constexpr std::array<std::uint32_t, 16> kTable{0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC,
                                                   0x76DC4190, 0x6B6B51F4, 0x4DB26158, 0x5005713C,
                                                   0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C,
                                                   0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C};
    std::uint32_t sum = 0xFFFFFFFF;
    for (const char c : bytes) {
        sum ^= static_cast<unsigned char>(c);
        sum = (sum >> 4U) ^ kTable[sum & 15U];
        sum = (sum >> 4U) ^ kTable[sum & 15U];
    }
    return ~sum;
}

struct Chunk {
    std::string_view type;
    std::string_view data;
};

// Takes one whole chunk with a right check sum off the front.
std::optional<Chunk> takeChunk(std::string_view& rest) {
    constexpr std::size_t kAround = 12;  // length, type, check sum
    if (rest.size() < kAround) return std::nullopt;
    const std::size_t size = bigEndian(rest);
    if (size > rest.size() - kAround) return std::nullopt;
    const std::string_view summed = rest.substr(4, size + 4);
    if (bigEndian(rest.substr(size + 8)) != checkSum(summed)) return std::nullopt;
    rest.remove_prefix(size + kAround);
    return Chunk{summed.substr(0, 4), summed.substr(4)};
}

// Samples of a pixel, by colour type; none: no such type (PNG specification, 11.2.1).
std::uint64_t samplesOf(int colourType) {
    constexpr std::array<std::uint64_t, 7> kSamples{1, 0, 3, 1, 2, 0, 4};
    return colourType < 7 ? kSamples.at(static_cast<std::size_t>(colourType)) : 0;
}

struct Pass {
    std::uint64_t x, y, stepX, stepY;
};
constexpr std::array<Pass, 1> kAtOnce{{{0, 0, 1, 1}}};
// Adam7: PNG specification, 8.2.
constexpr std::array<Pass, 7> kInterlaced{{{0, 0, 8, 8},
                                           {4, 0, 8, 8},
                                           {0, 4, 4, 8},
                                           {2, 0, 4, 4},
                                           {0, 2, 2, 4},
                                           {1, 0, 2, 2},
                                           {0, 1, 1, 2}}};

// What the pixels take, unpacked, as IHDR tells; 0: it tells nonsense.
std::uint64_t pixelBytesOf(std::string_view header) {
    const std::uint64_t width = bigEndian(header);
    const std::uint64_t height = bigEndian(header.substr(4));
    const auto bits = static_cast<unsigned char>(header[8]);
    const std::uint64_t bitsOfPixel = bits * samplesOf(static_cast<unsigned char>(header[9]));
    const std::span<const Pass> passes =
        header[12] == 0 ? std::span<const Pass>{kAtOnce} : std::span<const Pass>{kInterlaced};
    std::uint64_t bytes = 0;
    for (const Pass& pass : passes) {
        if (bitsOfPixel == 0 || width <= pass.x || height <= pass.y) continue;
        const std::uint64_t columns = (width - pass.x + pass.stepX - 1) / pass.stepX;
        const std::uint64_t rows = (height - pass.y + pass.stepY - 1) / pass.stepY;
        bytes += rows * (1 + (columns * bitsOfPixel + 7) / 8);
    }
    return bytes;
}

Finding finding(const char* id, std::string message, std::string hint) {
    Finding result;
    result.id = id;
    result.severity = Severity::fail;
    result.message = std::move(message);
    result.hint = std::move(hint);
    result.section = "3, Submission";
    return result;
}

Finding unreadable() {
    return finding("screenshot.unreadable", "screenshot.png is no PNG picture, or it is damaged.",
                   "Hand in the file that tick1star -o screenshot.png writes.");
}

std::optional<Finding> problemOf(const std::optional<std::string>& bytes) {
    if (!bytes)
        return finding("screenshot.missing", "There is no screenshot.png.",
                       "Render your option's scene with tick1star and hand the picture in.");
    const std::optional<PngHeader> header = readPngHeader(*bytes);
    if (!header) return unreadable();
    if (header->width == kScreenshotWidth && header->height == kScreenshotHeight)
        return unpacksTo(header->pixelBytes, header->packed) ? std::nullopt
                                                             : std::optional{unreadable()};
    Finding wrong =
        finding("screenshot.wrong-size",
                fmt::format("The picture has {} x {} pixels; the handout's has 640 x "
                            "480.",
                            header->width, header->height),
                "Render the scene at tick1star's own size, and hand in that file, not a "
                "picture of the screen.");
    wrong.evidence = {{"width", static_cast<double>(header->width)},
                      {"height", static_cast<double>(header->height)}};
    return wrong;
}

}  // namespace

std::optional<PngHeader> readPngHeader(std::string_view bytes) {
    if (!bytes.starts_with(kSignature)) return std::nullopt;
    bytes.remove_prefix(kSignature.size());
    const std::optional<Chunk> first = takeChunk(bytes);
    constexpr std::size_t kHeaderSize = 13;
    if (!first || first->type != "IHDR" || first->data.size() != kHeaderSize) return std::nullopt;
    const std::uint32_t width = bigEndian(first->data);
    const std::uint32_t height = bigEndian(first->data.substr(4));
    if (width == 0 || height == 0 || width > kLargestSide || height > kLargestSide)
        return std::nullopt;
    PngHeader header{
        static_cast<int>(width), static_cast<int>(height), pixelBytesOf(first->data), {}};
    while (const std::optional<Chunk> chunk = takeChunk(bytes)) {
        if (chunk->type == "IDAT") header.packed += chunk->data;
        if (chunk->type == "IEND" && !header.packed.empty()) return header;
    }
    return std::nullopt;
}

TaskReport judgeScreenshotFile(const std::optional<std::string>& bytes) {
    TaskReport report;
    report.id = "screenshot";
    report.title = "Screenshot";
    report.state = TaskState::passed;
    if (std::optional<Finding> problem = problemOf(bytes)) {
        report.state = TaskState::failed;
        report.findings.push_back(std::move(*problem));
    }
    return report;
}

}  // namespace ticker::pipeline

#include <grader/oracle/references/FloatTiff.h>

#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <tiffio.h>

#include <cstdint>
#include <memory>
#include <string>

namespace ticker::oracle {
namespace {

namespace fs = std::filesystem;
using raytracer::InputError;

// Upper bound for our own files; anything larger is rejected.
constexpr std::uint32_t kLargestSide = 1U << 14U;

using Tiff = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

Tiff open(const fs::path& file, const char* mode) {
    // libtiff's own messages on stderr are switched off: our errors say what is wrong.
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
    return {TIFFOpen(file.c_str(), mode), TIFFClose};
}

void describe(TIFF* tiff, const FloatPicture& picture) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(picture.width));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(picture.height));
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(picture.height));
}

bool writeRows(TIFF* tiff, const FloatPicture& picture) {
    std::vector<float> row;
    for (int y = 0; y < picture.height; ++y) {
        row.clear();
        for (int x = 0; x < picture.width; ++x) {
            const raytracer::ColourRGB& c =
                picture.pixels[static_cast<std::size_t>(y * picture.width + x)];
            for (const double value : {c.r, c.g, c.b})
                row.push_back(static_cast<float>(value));
        }
        if (TIFFWriteScanline(tiff, row.data(), static_cast<std::uint32_t>(y)) < 0) return false;
    }
    return TIFFFlush(tiff) == 1;
}

/// True for three 32-bit floats for each pixel, interleaved.
bool isOurKind(TIFF* tiff) {
    const auto is = [&](std::uint32_t tag, std::uint16_t wanted) {
        std::uint16_t value = 0;
        return TIFFGetFieldDefaulted(tiff, tag, &value) == 1 && value == wanted;
    };
    return is(TIFFTAG_SAMPLESPERPIXEL, 3) && is(TIFFTAG_BITSPERSAMPLE, 32) &&
           is(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP) &&
           is(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) && TIFFIsTiled(tiff) == 0;
}

}  // namespace

void writeTiff(const FloatPicture& picture, const fs::path& file) {
    const PartFile part{file};
    {
        const Tiff tiff = open(part.path(), "w");
        if (!tiff) throw InputError(file.string(), 0, "cannot be written");
        describe(tiff.get(), picture);
        if (!writeRows(tiff.get(), picture))
            throw InputError(file.string(), 0, "the picture cannot be packed as TIFF");
    }
    if (const std::error_code error = part.rename())
        throw InputError(file.string(), 0, "cannot be replaced: " + error.message());
}

FloatPicture readTiff(const fs::path& file) {
    const Tiff tiff = open(file, "r");
    if (!tiff) throw InputError(file.string(), 0, "no TIFF picture that can be read");
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
    if (!isOurKind(tiff.get()) || width > kLargestSide || height > kLargestSide)
        throw InputError(file.string(), 0, "expected three 32-bit floats for each pixel");
    FloatPicture picture{static_cast<int>(width), static_cast<int>(height), {}};
    std::vector<float> row(std::size_t{3} * width);
    for (std::uint32_t y = 0; y < height; ++y) {
        if (TIFFReadScanline(tiff.get(), row.data(), y) < 0)
            throw InputError(file.string(), 0, "the TIFF picture is damaged");
        for (std::size_t x = 0; x < width; ++x)
            picture.pixels.emplace_back(double{row[3 * x]}, double{row[3 * x + 1]},
                                        double{row[3 * x + 2]});
    }
    return picture;
}

}  // namespace ticker::oracle

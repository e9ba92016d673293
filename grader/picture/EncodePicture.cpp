#include <grader/picture/EncodePicture.h>

#include <raytracer/base/Error.h>

#include <png.h>
#include <zlib.h>

#include <cstddef>

namespace ticker::picture {
namespace {

constexpr std::size_t kPngChannels = 3;
constexpr int kBits = 8;

void appendBytes(png_structp png, png_bytep bytes, std::size_t size) {
    static_cast<std::string*>(png_get_io_ptr(png))
        ->append(reinterpret_cast<const char*>(bytes), size);  // NOLINT: libpng's type of a byte
}

void nothingToFlush(png_structp /*png*/) {}

void ignore(png_structp /*png*/, png_const_charp /*message*/) {}

// Owns libpng's two structures.
class Encoder {
public:
    explicit Encoder(std::string& file)
        : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, ignore)),
          info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
        if (info_ != nullptr) png_set_write_fn(png_, &file, appendBytes, nothingToFlush);
    }
    ~Encoder() { png_destroy_write_struct(&png_, &info_); }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    // libpng reports errors by longjmp, so no local variable here has a destructor or changes after
    // setjmp.
    [[nodiscard]] bool write(const raytracer::ByteImage& image) {
        if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) return false;
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(image.width),
                     static_cast<png_uint_32>(image.height), kBits, PNG_COLOR_TYPE_RGB,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        // Noise has no repetitions, so searching for longer matches would waste time.
        png_set_compression_strategy(png_, Z_RLE);
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
        png_write_info(png_, info_);
        const std::size_t rowBytes = kPngChannels * static_cast<std::size_t>(image.width);
        for (std::size_t at = 0; at < image.rgb.size(); at += rowBytes)
            png_write_row(png_, &image.rgb[at]);
        png_write_end(png_, nullptr);
        return true;
    }

private:
    png_structp png_;
    png_infop info_;
};

}  // namespace

std::string encodePicture(const raytracer::ByteImage& image) {
    const bool isWhole = image.width >= 1 && image.height >= 1 &&
                         image.rgb.size() == kPngChannels * static_cast<std::size_t>(image.width) *
                                                 static_cast<std::size_t>(image.height);
    std::string file;
    if (!isWhole || !Encoder{file}.write(image))
        throw raytracer::Error("a picture cannot be packed as PNG");
    return file;
}

}  // namespace ticker::picture

#include <grader/picture/decoder/DecodePng.h>

#include <png.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>
#include <string_view>
#include <vector>

namespace ticker::picture {
namespace {

constexpr std::size_t kChannels = 3;

// The bytes that libpng reads, and the state of the decoding.
struct Reading {
    std::span<const std::uint8_t> rest;
    DecodeState failure = DecodeState::damaged;
};

void readBytes(png_structp png, png_bytep target, std::size_t size) {
    auto& reading = *static_cast<Reading*>(png_get_io_ptr(png));
    if (size > reading.rest.size()) {
        reading.failure = DecodeState::truncated;
        png_error(png, "the file ends");
    }
    std::copy_n(reading.rest.begin(), size, target);
    reading.rest = reading.rest.subspan(size);
}

// Called for every chunk that libpng does not read itself. acTL announces an animation.
int onOtherChunk(png_structp png, png_unknown_chunkp chunk) {
    if (std::memcmp(chunk->name, "acTL", 4) != 0) return 1;
    static_cast<Reading*>(png_get_user_chunk_ptr(png))->failure = DecodeState::animated;
    return -1;
}

void ignore(png_structp /*png*/, png_const_charp /*message*/) {}

[[noreturn]] void giveUp(png_structp png, png_const_charp message) {
    auto& reading = *static_cast<Reading*>(png_get_error_ptr(png));
    if (std::string_view{message}.find("memory") != std::string_view::npos)
        reading.failure = DecodeState::noMemory;
    png_longjmp(png, 1);
}

// Owns libpng's two structures.
class Decoder {
public:
    explicit Decoder(Reading& reading)
        : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, giveUp, ignore)),
          info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
        if (info_ == nullptr) return;
        png_set_read_fn(png_, &reading, readBytes);
        png_set_read_user_chunk_fn(png_, &reading, onOtherChunk);
        // Colour profiles, texts and times are not needed, so they are not decompressed.
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        // Too many pixels for the stated size are an error, and so are too few.
        png_set_benign_errors(png_, 0);
    }
    ~Decoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    [[nodiscard]] bool isReady() const { return info_ != nullptr; }

    // libpng reports errors by longjmp, so no local variable here has a destructor or changes after
    // setjmp.
    [[nodiscard]] bool read(std::span<std::uint8_t> pixels, std::vector<png_bytep>& rows) {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_read_info(png_, info_);
        png_set_expand(png_);
        png_set_strip_16(png_);
        png_set_gray_to_rgb(png_);
        png_set_strip_alpha(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        const std::size_t rowBytes = png_get_rowbytes(png_, info_);
        const std::size_t height = png_get_image_height(png_, info_);
        if (rowBytes != png_get_image_width(png_, info_) * kChannels ||
            rowBytes * height != pixels.size() || height != rows.size())
            return false;
        for (std::size_t y = 0; y < height; ++y)
            rows[y] = pixels.data() + y * rowBytes;
        png_read_image(png_, rows.data());
        png_read_end(png_, nullptr);
        return true;
    }

private:
    png_structp png_;
    png_infop info_;
};

// The height of a PNG file: bytes 20 to 23, big-endian.
std::size_t claimedHeight(std::span<const std::uint8_t> file) {
    constexpr std::size_t kAt = 20;
    if (file.size() < kAt + 4) return 0;
    std::size_t height = 0;
    for (const std::uint8_t byte : file.subspan(kAt, 4))
        height = height << 8U | byte;
    return height;
}

}  // namespace

DecodeState decodePng(std::span<const std::uint8_t> file, std::span<std::uint8_t> pixels) {
    const std::size_t height = claimedHeight(file);
    if (height == 0 || height > pixels.size()) return DecodeState::damaged;
    std::vector<png_bytep> rows(height);
    Reading reading{file};
    Decoder decoder{reading};
    if (!decoder.isReady()) return DecodeState::noMemory;
    return decoder.read(pixels, rows) ? DecodeState::decoded : reading.failure;
}

}  // namespace ticker::picture

// The only file that compiles the stb libraries.
//
// Pictures are untrusted input, so only PNG is read (most security bugs of stb were in its other
// decoders), and no single allocation may exceed what the largest accepted picture needs: without
// this limit, a small file could unpack to gigabytes.
#include <cstddef>
#include <cstdlib>

namespace {

// 64 million pixels of four 16-bit channels, one filter byte for each row of an interlaced picture.
constexpr std::size_t kLargestBlock = 64'000'000ULL * 8 + 16'384ULL * 2;

void* boundedMalloc(std::size_t size) {
    return size <= kLargestBlock ? std::malloc(size) : nullptr;
}

void* boundedRealloc(void* block, std::size_t size) {
    return size <= kLargestBlock ? std::realloc(block, size) : nullptr;
}

}  // namespace

// The casts are in stb, which is C, but the compiler reports them here.
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wold-style-cast"
#endif

#define STBI_MALLOC(size) boundedMalloc(size)
#define STBI_REALLOC(block, size) boundedRealloc(block, size)
#define STBI_FREE(block) std::free(block)
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#define STBI_MAX_DIMENSIONS 16384
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

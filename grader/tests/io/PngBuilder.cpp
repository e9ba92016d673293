#include "PngBuilder.h"

#include <algorithm>
#include <cstddef>

namespace ticker::testing {
namespace {

std::string bigEndian(std::uint32_t value) {
    std::string bytes;
    for (unsigned shift = 24; shift < 32; shift -= 8)
        bytes += static_cast<char>(value >> shift & 0xFFU);
    return bytes;
}

// Specification of PNG, annex D.
std::uint32_t crcOf(const std::string& bytes) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xEDB88320U : crc >> 1U;
    }
    return ~crc;
}

// RFC 1950.
std::uint32_t adlerOf(const std::string& bytes) {
    constexpr std::uint32_t kModulus = 65521;
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const char c : bytes) {
        a = (a + static_cast<unsigned char>(c)) % kModulus;
        b = (b + a) % kModulus;
    }
    return b << 16U | a;
}

// RFC 1951, stored blocks: nothing is packed.
std::string stored(const std::string& bytes) {
    constexpr std::size_t kLargestBlock = 65535;
    std::string packed = "\x78\x01";
    for (std::size_t begin = 0; begin < bytes.size(); begin += kLargestBlock) {
        const std::string block = bytes.substr(begin, kLargestBlock);
        const auto size = static_cast<std::uint32_t>(block.size());
        const bool last = begin + kLargestBlock >= bytes.size();
        packed += static_cast<char>(last ? 1 : 0);
        for (const std::uint32_t number : {size, ~size}) {
            packed += static_cast<char>(number & 0xFFU);
            packed += static_cast<char>(number >> 8U & 0xFFU);
        }
        packed += block;
    }
    return packed + bigEndian(adlerOf(bytes));
}

}  // namespace

std::string pngChunk(const std::string& type, const std::string& data) {
    return bigEndian(static_cast<std::uint32_t>(data.size())) + type + data +
           bigEndian(crcOf(type + data));
}

std::string makePng(const PngHeader& header, const std::string& rows) {
    return makePngAround(header, stored(rows));
}

std::string makePngAround(const PngHeader& header, const std::string& packed) {
    std::string description = bigEndian(header.width) + bigEndian(header.height);
    description += static_cast<char>(header.depth);
    description += static_cast<char>(header.colour);
    description += std::string(2, '\0');
    description += static_cast<char>(header.interlaced ? 1 : 0);
    return "\x89PNG\r\n\x1A\n" + pngChunk("IHDR", description) + pngChunk("IDAT", packed) +
           pngChunk("IEND", "");
}

std::string equalRows(const PngHeader& header, const std::string& row) {
    std::string rows;
    for (std::uint32_t y = 0; y < header.height; ++y)
        rows += std::string(1, '\0') + row;
    return rows;
}

}  // namespace ticker::testing

#include <grader/pipeline/Unpack.h>

#include <zlib.h>

#include <array>
#include <memory>
#include <string>

namespace ticker::pipeline {
namespace {

struct EndInflate {
    void operator()(z_stream* stream) const { inflateEnd(stream); }
};

}  // namespace

bool unpacksTo(std::uint64_t bytes, std::string_view stream) {
    z_stream state{};
    if (inflateInit(&state) != Z_OK) return false;
    const std::unique_ptr<z_stream, EndInflate> end{&state};
    std::string rest{stream};  // zlib asks for bytes that are not const
    state.next_in = reinterpret_cast<Bytef*>(rest.data());
    state.avail_in = static_cast<uInt>(rest.size());
    std::array<Bytef, 16384> unpacked{};
    std::uint64_t total = 0;
    int status = Z_OK;
    while (status == Z_OK && total <= bytes) {
        state.next_out = unpacked.data();
        state.avail_out = static_cast<uInt>(unpacked.size());
        status = inflate(&state, Z_NO_FLUSH);
        total += unpacked.size() - state.avail_out;
    }
    return status == Z_STREAM_END && total == bytes;
}

}  // namespace ticker::pipeline

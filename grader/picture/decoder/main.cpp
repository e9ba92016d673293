// ticker-decode: decodes the PNG file behind one descriptor into the memory behind another. It runs
// in the sandbox, since the file is untrusted.
#include <grader/picture/decoder/DecodePng.h>

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <new>

namespace {

using ticker::picture::DecodeState;
using ticker::picture::Reply;

std::span<std::uint8_t> mapped(int descriptor, int protection) {
    const off_t end = lseek(descriptor, 0, SEEK_END);
    if (end <= 0) return {};
    const auto size = static_cast<std::size_t>(end);
    void* const memory = mmap(nullptr, size, protection, MAP_SHARED, descriptor, 0);
    if (memory == MAP_FAILED) return {};
    return {static_cast<std::uint8_t*>(memory), size};
}

DecodeState decode(std::span<const std::uint8_t> file, std::span<std::uint8_t> pixels) {
    try {
        return ticker::picture::decodePng(file, pixels);
    } catch (const std::bad_alloc&) {
        return DecodeState::noMemory;
    }
}

}  // namespace

int main() {
    const std::span<const std::uint8_t> file = mapped(ticker::picture::kFileDescriptor, PROT_READ);
    const std::span<std::uint8_t> reply =
        mapped(ticker::picture::kReplyDescriptor, PROT_READ | PROT_WRITE);
    if (file.empty() || reply.size() < sizeof(Reply)) return 2;
    const DecodeState state = decode(file, reply.subspan(sizeof(Reply)));
    new (reply.data()) Reply{state};
    return 0;
}

#include <grader/picture/DecodePicture.h>
#include <grader/picture/decoder/Reply.h>

#include <grader/sandbox/HelperProgram.h>
#include <grader/sandbox/SharedMemory.h>

#include <raytracer/base/Error.h>

#include <csignal>
#include <filesystem>
#include <span>

namespace ticker::picture {
namespace fs = std::filesystem;
namespace {

using Kind = DecodeFailure::Kind;
using sandbox::Outcome;

constexpr std::string_view kSignature{"\x89PNG\r\n\x1A\n", 8};
constexpr std::size_t kHeaderEnd = 24;  // signature, length, "IHDR", width, height
constexpr std::size_t kChannels = 3;

const fs::path& stagedDecoder() {
    static const fs::path program =
        sandbox::copyProgram("ticker-decode", sandbox::Sandbox::makeStagingFolder());
    return program;
}

std::uint32_t bigEndian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = (value << 8U) | static_cast<unsigned char>(bytes[i]);
    return value;
}

std::string kindOf(std::string_view bytes) {
    if (bytes.empty()) return "the file is empty";
    if (bytes.starts_with("\xFF\xD8\xFF")) return "this is a JPEG picture";
    if (bytes.starts_with("GIF8")) return "this is a GIF picture";
    if (bytes.starts_with("BM")) return "this is a BMP picture";
    if (bytes.starts_with("%PDF")) return "this is a PDF document";
    if (bytes.substr(0, 12).ends_with("WEBP")) return "this is a WebP picture";
    if (bytes.substr(0, 8).ends_with("ftyp")) return "this is a HEIC or AVIF picture";
    return "this is no picture";
}

std::string inWords(PictureSize size) {
    return std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels";
}

bool isDecodable(PictureSize size) {
    return size.width >= 1 && size.height >= 1 && size.width <= kLargestSide &&
           size.height <= kLargestSide && std::uint64_t{size.width} * size.height <= kMostPixels;
}

DecodeFailure failureOf(DecodeState state) {
    switch (state) {
        case DecodeState::animated:
            return {Kind::animated, "an animated PNG, of several pictures"};
        case DecodeState::truncated:
            return {Kind::truncated, "the PNG file ends too early"};
        case DecodeState::noMemory:
            return {Kind::limit, "decoding it takes too much memory"};
        default:
            return {Kind::damaged, "the PNG file is damaged"};
    }
}

Outcome runDecoder(std::string_view bytes, const sandbox::SharedMemory& reply,
                   const sandbox::Sandbox& sandbox, const sandbox::Limits& limits) {
    const FileDescriptor file =
        sandbox::sealedCopy(std::as_bytes(std::span{bytes.data(), bytes.size()}));
    sandbox::Command command;
    command.arguments = {"/decode"};
    command.readOnly = {{stagedDecoder(), "/decode"}};
    command.descriptors = {{file.get(), kFileDescriptor}, {reply.descriptor(), kReplyDescriptor}};
    command.policy = sandbox::Policy::run;
    command.limits = limits;
    return sandbox.run(command);
}

}  // namespace

DecodeFailure failureOf(const Outcome& outcome) {
    if (outcome.end == Outcome::End::failed) throw raytracer::Error(outcome.output);
    const bool outOfTime = outcome.end == Outcome::End::wallLimit ||
                           (outcome.end == Outcome::End::signalled && outcome.code == SIGXCPU);
    if (outOfTime) return {Kind::limit, "decoding it takes too long"};
    if (outcome.end == Outcome::End::exited && outcome.code != 0)
        throw raytracer::Error("ticker-decode left with status " + std::to_string(outcome.code));
    return {Kind::crashed, "its decoder crashed"};
}

std::optional<PictureSize> claimedSize(std::string_view bytes) {
    if (bytes.size() < kHeaderEnd || !bytes.starts_with(kSignature) ||
        bytes.substr(12, 4) != "IHDR")
        return std::nullopt;
    return PictureSize{bigEndian(bytes.substr(16)), bigEndian(bytes.substr(20))};
}

Decoded decodePicture(std::string_view bytes, const sandbox::Sandbox& sandbox,
                      const sandbox::Limits& limits) {
    if (!bytes.starts_with(kSignature)) return DecodeFailure{Kind::notPng, kindOf(bytes)};
    if (bytes.size() > kLargestFile)
        return DecodeFailure{Kind::tooLarge, "the file is larger than 64 MiB"};
    const std::optional<PictureSize> size = claimedSize(bytes);
    if (!size)
        return failureOf(bytes.size() < kHeaderEnd ? DecodeState::truncated : DecodeState::damaged);
    if (!isDecodable(*size)) return DecodeFailure{Kind::tooLarge, "a picture of " + inWords(*size)};

    const std::size_t pixels = std::size_t{size->width} * size->height * kChannels;
    const sandbox::SharedMemory memory{sizeof(Reply) + pixels};
    const Outcome outcome = runDecoder(bytes, memory, sandbox, limits);
    if (!outcome.succeeded()) return failureOf(outcome);
    Reply reply;
    memory.read(0, std::as_writable_bytes(std::span{&reply, 1}));
    if (reply.state != DecodeState::decoded) return failureOf(reply.state);
    raytracer::ByteImage image{static_cast<int>(size->width), static_cast<int>(size->height), {}};
    image.rgb.resize(pixels);
    memory.read(sizeof reply, std::as_writable_bytes(std::span{image.rgb}));
    return image;
}

}  // namespace ticker::picture

#include "../io/PngBuilder.h"

#include <grader/base/WholeFile.h>
#include <grader/picture/DecodePicture.h>
#include <grader/sandbox/LevelDiagnosis.h>
#include <grader/sandbox/SandboxPolicy.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <csignal>
#include <string>

namespace ticker::picture {
namespace {

using raytracer::ByteImage;
using testing::equalRows;
using testing::makePng;
using testing::makePngAround;
using testing::pngChunk;
using testing::PngColour;
using testing::PngHeader;
using Kind = DecodeFailure::Kind;

constexpr PngHeader kTwoByTwo{2, 2, 8, PngColour::rgb};
constexpr std::size_t kAfterHeader = 33;

std::string smallPicture() {
    return makePng(kTwoByTwo, std::string("\0abcdef\0ghijkl", 14));
}

Decoded decode(const std::string& bytes) {
    return decodePicture(bytes, sandbox::Sandbox::best(), sandbox::defaultPolicy().decode);
}

std::string pixelsOf(const std::string& bytes) {
    const Decoded decoded = decode(bytes);
    if (const auto* failure = std::get_if<DecodeFailure>(&decoded)) return failure->message;
    const auto& image = std::get<ByteImage>(decoded);
    return {image.rgb.begin(), image.rgb.end()};
}

DecodeFailure failureIn(const std::string& bytes) {
    const Decoded decoded = decode(bytes);
    if (const auto* failure = std::get_if<DecodeFailure>(&decoded)) return *failure;
    ADD_FAILURE() << "was decoded";
    return {};
}

// makePng writes any size into the header; the rows are those of 2 x 2 pixels.
std::string claiming(std::uint32_t width, std::uint32_t height) {
    return makePng({width, height, 8, PngColour::rgb}, std::string("\0abcdef\0ghijkl", 14));
}

TEST(DecodePicture, GivesThePixelsAtEveryLevel) {
    for (const sandbox::Diagnosis& diagnosis : sandbox::diagnose()) {
        if (!diagnosis.available) continue;
        const Decoded decoded = decodePicture(smallPicture(), sandbox::Sandbox::at(diagnosis.level),
                                              sandbox::defaultPolicy().decode);
        const auto* image = std::get_if<ByteImage>(&decoded);
        ASSERT_NE(image, nullptr) << sandbox::toString(diagnosis.level);
        EXPECT_EQ(image->width, 2);
        EXPECT_EQ(image->height, 2);
        EXPECT_EQ(std::string(image->rgb.begin(), image->rgb.end()), "abcdefghijkl");
    }
}

TEST(DecodePicture, ReadsEveryKindOfPixel) {
    const auto row = [](PngColour colour, std::uint8_t depth, const std::string& bytes) {
        const PngHeader header{1, 1, depth, colour};
        return makePng(header, equalRows(header, bytes));
    };
    EXPECT_EQ(pixelsOf(row(PngColour::grey, 8, "x")), "xxx");
    EXPECT_EQ(pixelsOf(row(PngColour::grey, 1, "\x80")), "\xFF\xFF\xFF");
    EXPECT_EQ(pixelsOf(row(PngColour::greyAlpha, 8, "x\x01")), "xxx");
    EXPECT_EQ(pixelsOf(row(PngColour::rgbAlpha, 8, "xyz\x01")), "xyz");
    EXPECT_EQ(pixelsOf(row(PngColour::rgb, 16, "x1y2z3")), "xyz");
}

TEST(DecodePicture, ReadsWhatTheFrameworksReaderReads) {
    for (const char* name :
         {"/assets/bumpmap.png", "/grader/corpus/samples/awarded/bump-z-up/screenshot.png"}) {
        const std::string file = std::string{TICKER_SOURCE_DIR} + name;
        const Decoded decoded = decode(readWhole(file));
        const auto* image = std::get_if<ByteImage>(&decoded);
        ASSERT_NE(image, nullptr) << file << ": " << std::get<DecodeFailure>(decoded).message;
        EXPECT_EQ(image->rgb, raytracer::readImage(file).rgb) << file;
    }
}

TEST(DecodePicture, TakesNoNoticeOfTextsAndProfiles) {
    std::string bytes = smallPicture();
    bytes.insert(kAfterHeader, pngChunk("iCCP", "no profile") + pngChunk("tEXt", "key") +
                                   pngChunk("gAMA", std::string("\0\0\0\1", 4)) +
                                   pngChunk("oDDe", std::string(1000, 'x')));
    EXPECT_EQ(pixelsOf(bytes), "abcdefghijkl");
}

TEST(DecodePicture, NamesOtherKindsOfFile) {
    for (const auto& [bytes, words] : std::vector<std::pair<std::string, std::string>>{
             {"", "the file is empty"},
             {"\x89", "this is no picture"},
             {"\xFF\xD8\xFF\xE0 JFIF", "this is a JPEG picture"},
             {"RIFF1234WEBPVP8 ", "this is a WebP picture"},
             {std::string("\0\0\0\x18", 4) + "ftypheic", "this is a HEIC or AVIF picture"}}) {
        const DecodeFailure failure = failureIn(bytes);
        EXPECT_EQ(failure.kind, Kind::notPng);
        EXPECT_EQ(failure.message, words);
    }
}

TEST(DecodePicture, RefusesWhatClaimsToBeTooLarge) {
    for (const auto& [width, height] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
             {65535, 65535}, {0x7FFFFFFF, 0x7FFFFFFF}, {16385, 1}, {4097, 4096}, {0, 2}, {2, 0}})
        EXPECT_EQ(failureIn(claiming(width, height)).kind, Kind::tooLarge)
            << width << " x " << height;
}

TEST(DecodePicture, SaysWhereverTheFileIsCutThatItIsCut) {
    const std::string whole = smallPicture();
    for (const std::size_t size : {8U, 20U, 30U, 45U, 60U})
        EXPECT_EQ(failureIn(whole.substr(0, size)).kind, Kind::truncated) << size;
    EXPECT_EQ(failureIn(whole.substr(0, whole.size() - 1)).kind, Kind::truncated);
}

TEST(DecodePicture, RefusesDamage) {
    std::string wrongSum = smallPicture();
    wrongSum[50] = static_cast<char>(wrongSum[50] ^ 1);
    const std::string noHeader =
        "\x89PNG\r\n\x1A\n" + pngChunk("tEXt", "here the header should be") + pngChunk("IEND", "");
    EXPECT_EQ(failureIn(wrongSum).kind, Kind::damaged);
    EXPECT_EQ(failureIn(noHeader).kind, Kind::damaged);
    EXPECT_EQ(failureIn(makePngAround(kTwoByTwo, "not zlib's")).kind, Kind::damaged);
}

TEST(DecodePicture, RefusesTooFewAndTooManyPixels) {
    EXPECT_EQ(failureIn(claiming(2, 3)).kind, Kind::damaged);
    EXPECT_EQ(failureIn(claiming(2, 1)).kind, Kind::damaged);
    EXPECT_EQ(failureIn(claiming(4096, 4096)).kind, Kind::damaged);
}

TEST(DecodePicture, RefusesAnimations) {
    std::string bytes = smallPicture();
    bytes.insert(kAfterHeader, pngChunk("acTL", std::string("\0\0\0\2\0\0\0\0", 8)));
    EXPECT_EQ(failureIn(bytes).kind, Kind::animated);
}

TEST(DecodePicture, StopsWhenTimeIsUp) {
    sandbox::Limits hasty = sandbox::defaultPolicy().decode;
    hasty.wallSeconds = 1e-9;
    const Decoded late = decodePicture(smallPicture(), sandbox::Sandbox::best(), hasty);
    EXPECT_EQ(std::get<DecodeFailure>(late).kind, Kind::limit);
}

TEST(DecodePicture, TellsLimitsCrashesAndOurOwnFaultsApart) {
    const auto endedBy = [](sandbox::Outcome::End end, int code) {
        sandbox::Outcome outcome;
        outcome.end = end;
        outcome.code = code;
        return outcome;
    };
    using End = sandbox::Outcome::End;
    EXPECT_EQ(failureOf(endedBy(End::wallLimit, 0)).kind, Kind::limit);
    EXPECT_EQ(failureOf(endedBy(End::signalled, SIGXCPU)).kind, Kind::limit);
    EXPECT_EQ(failureOf(endedBy(End::signalled, SIGSEGV)).kind, Kind::crashed);
    EXPECT_EQ(failureOf(endedBy(End::signalled, SIGSYS)).kind, Kind::crashed);
    EXPECT_THROW(static_cast<void>(failureOf(endedBy(End::exited, 2))), raytracer::Error);
    EXPECT_THROW(static_cast<void>(failureOf(endedBy(End::failed, 0))), raytracer::Error);
}

TEST(ClaimedSize, IsReadFromTheHeaderAlone) {
    EXPECT_EQ(claimedSize(claiming(65535, 7)), (PictureSize{65535, 7}));
    EXPECT_EQ(claimedSize(smallPicture().substr(0, 24)), (PictureSize{2, 2}));
    EXPECT_EQ(claimedSize(smallPicture().substr(0, 23)), std::nullopt);
    EXPECT_EQ(claimedSize("a text"), std::nullopt);
}

}  // namespace
}  // namespace ticker::picture

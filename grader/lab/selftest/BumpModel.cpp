#include <grader/lab/selftest/BumpModel.h>

#include <grader/lab/selftest/BumpModel.inc.h>

#include <fmt/format.h>

#include <array>
#include <cstddef>

namespace ticker::selftest {
namespace {

struct SlipNames {
    Slip slip;
    const char* id;
    const char* finding;
};

constexpr const char* kWrong = "bump.wrong";
constexpr const char* kTurning = "bump.longitude-dependent";

constexpr std::array kNames{
    SlipNames{Slip::none, "none", ""},
    SlipNames{Slip::invertedU, "inverted-u", "bump.inverted-u"},
    SlipNames{Slip::invertedV, "inverted-v", "bump.inverted-v"},
    SlipNames{Slip::inverted, "inverted", "bump.inverted"},
    SlipNames{Slip::upsideDown, "upside-down", "bump.upside-down"},
    SlipNames{Slip::swapped, "swapped-tangents", "bump.swapped-axes"},
    SlipNames{Slip::swappedHalf, "swapped-tangents-one-sign", "bump.swapped-axes"},
    SlipNames{Slip::transposed, "row-before-column", "bump.swapped-axes"},
    SlipNames{Slip::otherAxis, "tangents-of-another-axis", kTurning},
    SlipNames{Slip::otherOrigin, "tangents-of-another-origin", kTurning},
    SlipNames{Slip::otherSense, "tangents-of-mirrored-longitude", kTurning},
    SlipNames{Slip::notUnit, "not-normalised", "bump.not-unit"},
    SlipNames{Slip::acosBeyondOne, "acos-without-radius-row-clamped", "bump.not-finite"},
    SlipNames{Slip::clampedAcos, "clamped-acos-without-radius", kWrong},
    SlipNames{Slip::unitGradient, "unit-gradient", "bump.not-finite"},
    SlipNames{Slip::flat, "same-texel-twice", "bump.flat"},
    SlipNames{Slip::noWrap, "column-beyond-the-last", "run.crashed"},
    SlipNames{Slip::noLastRow, "row-beyond-the-last", "run.crashed"},
    SlipNames{Slip::noCentre, "centre-not-subtracted", kWrong},
    SlipNames{Slip::uOnly, "u-only", kWrong},
    SlipNames{Slip::vOnly, "v-only", kWrong},
    SlipNames{Slip::sameSlopeTwice, "same-slope-twice", kWrong},
    SlipNames{Slip::absolute, "absolute-difference", kWrong},
    SlipNames{Slip::wholeNumbers, "int-difference", kWrong},
    SlipNames{Slip::evenRows, "rows-by-height", kWrong},
    SlipNames{Slip::halfTurn, "twice-round", kWrong},
    SlipNames{Slip::noQuadrant, "atan-without-quadrant", kWrong},
    SlipNames{Slip::inward, "points-inwards", kWrong},
    SlipNames{Slip::hemisphere, "v-inverted-below-equator", kWrong},
    SlipNames{Slip::firstRow, "slope-of-the-first-row", kWrong},
    SlipNames{Slip::firstColumn, "slope-of-the-first-column", kWrong},
    SlipNames{Slip::uHemisphere, "u-inverted-below-equator", kWrong},
    SlipNames{Slip::lowRows, "u-inverted-below-row-300", kWrong},
    SlipNames{Slip::farColumns, "v-inverted-right-of-column-300", kWrong},
    SlipNames{Slip::rowsEnd, "rows-end-at-511", kWrong},
    SlipNames{Slip::longerSide, "longer-side-for-both", kWrong},
    SlipNames{Slip::halfRows, "half-the-rows", kWrong},
    SlipNames{Slip::farNeighbour, "neighbour-fifty-texels-away", kWrong},
    SlipNames{Slip::darkHalf, "dark-half-inverted", kWrong},
    SlipNames{Slip::falling, "falling-slopes-ignored", kWrong},
    SlipNames{Slip::signedBytes, "signed-bytes", kWrong},
    SlipNames{Slip::byteDifference, "difference-in-a-byte", kWrong},
    SlipNames{Slip::behind, "smooth-behind", kWrong},
    SlipNames{Slip::cameraFacing, "turned-to-the-camera", kWrong},
};

const SlipNames& namesOf(Slip slip) {
    return kNames.at(static_cast<std::size_t>(slip));
}

template <std::size_t N, typename Enum>
const char* name(const std::array<const char*, N>& names, Enum value) {
    return names.at(static_cast<std::size_t>(value));
}

}  // namespace

Vector3 modelNormal(const Reading& reading, Slip slip, const Point& point) {
    return compiledNormal(reading, slip, point);
}

std::string describe(const Reading& reading) {
    return fmt::format(
        "{}-up, u {:.2f}{}, {}{}, {}, {}, {}, strength {}{}{}{}{}",
        name<3>({"y", "z", "x"}, reading.top), reading.uOrigin, reading.mirrored ? " mirrored" : "",
        name<4>({"floor", "round", "bilinear", "bicubic"}, reading.sampling),
        reading.lessOne ? " W-1" : "", name<3>({"wrap", "clamp", "mirror"}, reading.edge),
        name<5>({"forward", "backward", "central", "wide", "sobel"}, reading.difference),
        name<8>({"unit", "sine", "1/sine", "map units", "Blinn", "equation", "displaced",
                 "displaced unit sphere"},
                reading.gain),
        reading.strength, name<2>({"", ", numeric tangents"}, reading.tangents),
        name<2>({"", ", atan2"}, reading.angle),
        name<3>({"", ", rounded heights", ", gamma"}, reading.heights),
        reading.singlePrecision ? ", float" : "");
}

std::string idOf(Slip slip) {
    return namesOf(slip).id;
}

std::string expectedFinding(Slip slip) {
    return namesOf(slip).finding;
}

}  // namespace ticker::selftest

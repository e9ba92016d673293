#include <grader/lab/selftest/BumpModel.h>

#include <grader/lab/selftest/BumpModel.inc.h>

#include <fmt/format.h>

#include <array>
#include <cstddef>

namespace ticker::selftest {
namespace {

struct MistakeNames {
    Mistake mistake;
    const char* id;
    const char* finding;
};

constexpr const char* kWrong = "bump.wrong";
constexpr const char* kTurning = "bump.longitude-dependent";

constexpr std::array kNames{
    MistakeNames{Mistake::none, "none", ""},
    MistakeNames{Mistake::invertedU, "inverted-u", "bump.inverted-u"},
    MistakeNames{Mistake::invertedV, "inverted-v", "bump.inverted-v"},
    MistakeNames{Mistake::inverted, "inverted", "bump.inverted"},
    MistakeNames{Mistake::upsideDown, "upside-down", "bump.upside-down"},
    MistakeNames{Mistake::swapped, "swapped-tangents", "bump.swapped-axes"},
    MistakeNames{Mistake::swappedHalf, "swapped-tangents-one-sign", "bump.swapped-axes"},
    MistakeNames{Mistake::transposed, "row-before-column", "bump.swapped-axes"},
    MistakeNames{Mistake::otherAxis, "tangents-of-another-axis", kTurning},
    MistakeNames{Mistake::otherOrigin, "tangents-of-another-origin", kTurning},
    MistakeNames{Mistake::otherSense, "tangents-of-mirrored-longitude", kTurning},
    MistakeNames{Mistake::notUnit, "not-normalised", "bump.not-unit"},
    MistakeNames{Mistake::acosBeyondOne, "acos-without-radius-row-clamped", "bump.not-finite"},
    MistakeNames{Mistake::clampedAcos, "clamped-acos-without-radius", kWrong},
    MistakeNames{Mistake::unitGradient, "unit-gradient", "bump.not-finite"},
    MistakeNames{Mistake::flat, "same-texel-twice", "bump.flat"},
    MistakeNames{Mistake::noWrap, "column-beyond-the-last", "run.crashed"},
    MistakeNames{Mistake::noLastRow, "row-beyond-the-last", "run.crashed"},
    MistakeNames{Mistake::noCentre, "centre-not-subtracted", kWrong},
    MistakeNames{Mistake::uOnly, "u-only", kWrong},
    MistakeNames{Mistake::vOnly, "v-only", kWrong},
    MistakeNames{Mistake::sameSlopeTwice, "same-slope-twice", kWrong},
    MistakeNames{Mistake::absolute, "absolute-difference", kWrong},
    MistakeNames{Mistake::wholeNumbers, "int-difference", kWrong},
    MistakeNames{Mistake::evenRows, "rows-by-height", kWrong},
    MistakeNames{Mistake::halfTurn, "twice-round", kWrong},
    MistakeNames{Mistake::noQuadrant, "atan-without-quadrant", kWrong},
    MistakeNames{Mistake::inward, "points-inwards", kWrong},
    MistakeNames{Mistake::hemisphere, "v-inverted-below-equator", kWrong},
    MistakeNames{Mistake::firstRow, "slope-of-the-first-row", kWrong},
    MistakeNames{Mistake::firstColumn, "slope-of-the-first-column", kWrong},
    MistakeNames{Mistake::uHemisphere, "u-inverted-below-equator", kWrong},
    MistakeNames{Mistake::lowRows, "u-inverted-below-row-300", kWrong},
    MistakeNames{Mistake::farColumns, "v-inverted-right-of-column-300", kWrong},
    MistakeNames{Mistake::rowsEnd, "rows-end-at-511", kWrong},
    MistakeNames{Mistake::longerSide, "longer-side-for-both", kWrong},
    MistakeNames{Mistake::halfRows, "half-the-rows", kWrong},
    MistakeNames{Mistake::farNeighbour, "neighbour-fifty-texels-away", kWrong},
    MistakeNames{Mistake::darkHalf, "dark-half-inverted", kWrong},
    MistakeNames{Mistake::falling, "falling-slopes-ignored", kWrong},
    MistakeNames{Mistake::signedBytes, "signed-bytes", kWrong},
    MistakeNames{Mistake::byteDifference, "difference-in-a-byte", kWrong},
    MistakeNames{Mistake::behind, "smooth-behind", kWrong},
    MistakeNames{Mistake::cameraFacing, "turned-to-the-camera", kWrong},
    MistakeNames{Mistake::powered, "heights-to-the-power-2.2", kWrong},
    MistakeNames{Mistake::squared, "heights-squared", kWrong},
    MistakeNames{Mistake::rooted, "heights-rooted", kWrong},
};

const MistakeNames& namesOf(Mistake mistake) {
    return kNames.at(static_cast<std::size_t>(mistake));
}

template <std::size_t N, typename Enum>
const char* name(const std::array<const char*, N>& names, Enum value) {
    return names.at(static_cast<std::size_t>(value));
}

}  // namespace

Vector3 modelNormal(const Reading& reading, Mistake mistake, const Point& point) {
    return compiledNormal(reading, mistake, point);
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
        name<2>({"", ", rounded heights"}, reading.heights),
        reading.singlePrecision ? ", float" : "");
}

std::string idOf(Mistake mistake) {
    return namesOf(mistake).id;
}

std::string expectedFinding(Mistake mistake) {
    return namesOf(mistake).finding;
}

}  // namespace ticker::selftest

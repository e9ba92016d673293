#ifndef TICKER_SELFTEST_BUMPMODEL_H
#define TICKER_SELFTEST_BUMPMODEL_H

#include <grader/lab/selftest/FunctionExaminee.h>

#include <string>

namespace ticker::selftest {

/// One right way to write getNormalAt (docs/decisions/0003).
struct Reading {
    enum class Top { y, z, x };  ///< the axis at whose end row 0 lies
    enum class Sampling { floor, round, bilinear, bicubic };
    enum class Edge { wrap, clamp, mirror };  ///< neighbours beyond the last column and row
    enum class Difference { forward, backward, central, wide, sobel };
    enum class Gain {
        unit,          ///< unit tangents, difference of texels
        sine,          ///< P_u as differentiated: shorter towards the poles
        inverseSine,   ///< the true gradient
        mapUnits,      ///< differences over u and v: times width and height
        blinn,         ///< Blinn's form with cross products and the length of P_u x P_v
        equation,      ///< Equation (2) or (3), whichever fits, unit tangents
        displaced,     ///< the displaced surface, by chords: radius + strength x height
        displacedUnit  ///< likewise that of a unit sphere: 1 + strength x height / 40
    };
    enum class Tangents { formula, numeric };      ///< how P_u and P_v are computed
    enum class PolarAngle { cosine, arcTangent };  ///< by acos, or by atan2
    enum class Heights {
        given,
        rounded  ///< to whole bytes; no picture shows the difference
    };

    Top top = Top::y;
    double uOrigin = 0.5;  ///< u of the meridian that faces the camera
    bool mirrored = false;
    Sampling sampling = Sampling::floor;
    bool lessOne = false;  ///< u (W - 1) and v (H - 1) in place of u W and v H
    Edge edge = Edge::wrap;
    Difference difference = Difference::forward;
    Gain gain = Gain::unit;
    double strength = 1.0;
    Tangents tangents = Tangents::formula;
    PolarAngle angle = PolarAngle::cosine;
    Heights heights = Heights::given;
    bool singlePrecision = false;
};

/// True for readings that build the displaced surface and take its normal.
[[nodiscard]] inline bool isDisplaced(const Reading& reading) {
    return reading.gain == Reading::Gain::displaced || reading.gain == Reading::Gain::displacedUnit;
}

/// A student's mistake. Each is in the catalogue under the same id, with its finding.
enum class Mistake {
    none,
    invertedU,
    invertedV,
    inverted,
    upsideDown,
    swapped,        ///< B_u with P_v and B_v with P_u
    swappedHalf,    ///< likewise, one of them with the other sign
    transposed,     ///< at(row, column)
    otherAxis,      ///< tangents of a parametrisation round another axis
    otherOrigin,    ///< tangents of a longitude a quarter turn away
    otherSense,     ///< tangents of the mirrored longitude
    notUnit,        ///< not normalised
    acosBeyondOne,  ///< acos of the height without dividing by the radius
    clampedAcos,    ///< likewise, cut off at 1
    unitGradient,   ///< (B_u, B_v) normalised: NaN where the map is flat
    flat,           ///< a texel minus itself
    noWrap,         ///< column + 1 beyond the last column
    noLastRow,      ///< row + 1 beyond the last row
    noCentre,       ///< position instead of position minus centre
    uOnly,
    vOnly,
    sameSlopeTwice,  ///< B_v made from the texel to the right
    absolute,        ///< |difference|
    wholeNumbers,    ///< int differences
    evenRows,        ///< v from the height instead of the polar angle
    halfTurn,        ///< u goes round twice
    noQuadrant,      ///< atan instead of atan2
    inward,          ///< the normal points inwards
    hemisphere,      ///< sign of P_v wrong below the equator
    firstRow,        ///< B_u always from the map's top row
    firstColumn,     ///< B_v always from the map's first column
    uHemisphere,     ///< sign of P_u wrong below the equator
    lowRows,         ///< B_u negated in rows beyond 300
    farColumns,      ///< B_v negated in columns beyond 300
    rowsEnd,         ///< rows clamped to 511
    longerSide,      ///< the longer side for both width and height
    halfRows,        ///< v is the polar angle over 2 pi
    farNeighbour,    ///< the texel fifty away
    darkHalf,        ///< heights as the distance from mid-grey
    falling,         ///< falling slopes ignored
    signedBytes,     ///< heights as signed bytes
    byteDifference,  ///< differences as unsigned bytes
    behind,          ///< the far side left smooth
    cameraFacing,    ///< the normal turned towards the eye
    powered,         ///< heights raised to the power 2.2
    squared,         ///< heights squared
    rooted           ///< roots of the heights
};

inline constexpr Mistake kLastMistake = Mistake::rooted;

/// The normal of this reading at a point, with one mistake.
[[nodiscard]] Vector3 modelNormal(const Reading& reading, Mistake mistake, const Point& point);

/// A short description for tables and test output.
[[nodiscard]] std::string describe(const Reading& reading);
/// The catalogue's id.
[[nodiscard]] std::string idOf(Mistake mistake);
/// The finding that the grader must report first; empty for no finding.
[[nodiscard]] std::string expectedFinding(Mistake mistake);

}  // namespace ticker::selftest

#endif

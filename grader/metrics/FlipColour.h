#ifndef TICKER_METRICS_FLIPCOLOUR_H
#define TICKER_METRICS_FLIPCOLOUR_H

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ticker::metrics {

using Triple = std::array<float, 3>;
using Matrix = std::array<std::array<double, 3>, 3>;

/// Linear values of the 256 sRGB bytes (IEC 61966-2-1).
[[nodiscard]] const std::array<float, 256>& linearOfByte();

/// Linear sRGB to XYZ, with the primaries as the authors of FLIP round them.
inline constexpr Matrix kXyzOfLinear{
    {{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
     {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
     {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}}};

[[nodiscard]] constexpr Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k)
                c[i][j] += a[i][k] * b[k][j];
    return c;
}

[[nodiscard]] constexpr Matrix inverse(const Matrix& m) {
    Matrix cofactors{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            cofactors[i][j] = m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3] -
                              m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3];
    const double determinant =
        m[0][0] * cofactors[0][0] + m[0][1] * cofactors[0][1] + m[0][2] * cofactors[0][2];
    Matrix result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            result[i][j] = cofactors[j][i] / determinant;
    return result;
}

/// Linear sRGB to XYZ over the white's XYZ: white is (1, 1, 1).
[[nodiscard]] constexpr Matrix makeRelativeXyzOfLinear() {
    Matrix m = kXyzOfLinear;
    for (auto& row : m) {
        const double white = row[0] + row[1] + row[2];
        for (double& value : row)
            value /= white;
    }
    return m;
}
inline constexpr Matrix kRelativeXyzOfLinear = makeRelativeXyzOfLinear();

/// Linear sRGB to (116 Y, 500 (X - Y), 200 (Y - Z)) of relative XYZ: the opponent space YCxCz, in
/// which contrast sensitivity is known, without the offset -16 of its luminance.
inline constexpr Matrix kOpponentOfLinear = product(
    {{{0.0, 116.0, 0.0}, {500.0, -500.0, 0.0}, {0.0, 200.0, -200.0}}}, kRelativeXyzOfLinear);
inline constexpr Matrix kLinearOfOpponent = inverse(kOpponentOfLinear);

/// A matrix as single precision numbers, times a colour.
class Transform {
public:
    constexpr explicit Transform(const Matrix& m) {
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                m_[i][j] = static_cast<float>(m[i][j]);
    }
    [[nodiscard]] constexpr Triple operator()(float x, float y, float z) const {
        return {m_[0][0] * x + m_[0][1] * y + m_[0][2] * z,
                m_[1][0] * x + m_[1][1] * y + m_[1][2] * z,
                m_[2][0] * x + m_[2][1] * y + m_[2][2] * z};
    }

private:
    std::array<std::array<float, 3>, 3> m_{};
};

/// Cube root of a number from 0 to 1, relative error 2e-7. Written so that compilers vectorise it.
[[nodiscard]] inline float cubeRoot(float x) {
    // Dividing the bits of a float by three divides its exponent by three; the added number
    // restores the exponent's bias. Two steps of Halley's method reduce the 3 % error to rounding.
    float root = std::bit_cast<float>(std::bit_cast<std::int32_t>(x) / 3 + 0x2A51'19F2);
    for (int step = 0; step < 2; ++step) {
        const float cube = root * root * root;
        root *= (cube + x + x) / (cube + cube + x);
    }
    return root;
}

/// The curve of CIE L*a*b*.
[[nodiscard]] inline float labCurve(float t) {
    constexpr float kDelta = 6.0F / 29.0F;
    const float root = cubeRoot(t);
    const float line = t / (3.0F * kDelta * kDelta) + 4.0F / 29.0F;
    return t > kDelta * kDelta * kDelta ? root : line;
}

/// L*a*b* of a linear colour, each component from 0 to 1.
[[nodiscard]] inline Triple labOfLinear(const Triple& linear) {
    constexpr Transform kXyz{kRelativeXyzOfLinear};
    const Triple xyz = kXyz(linear[0], linear[1], linear[2]);
    const float x = labCurve(xyz[0]);
    const float y = labCurve(xyz[1]);
    const float z = labCurve(xyz[2]);
    return {116.0F * y - 16.0F, 500.0F * (x - y), 200.0F * (y - z)};
}

/// L*a*b* with Hunt's adjustment: dark colours look less saturated.
[[nodiscard]] inline Triple huntOfLinear(const Triple& linear) {
    const Triple lab = labOfLinear(linear);
    return {lab[0], 0.01F * lab[0] * lab[1], 0.01F * lab[0] * lab[2]};
}

/// |dL| + sqrt(da^2 + db^2).
[[nodiscard]] inline float hyab(const Triple& p, const Triple& q) {
    const float da = p[1] - q[1];
    const float db = p[2] - q[2];
    return std::abs(p[0] - q[0]) + std::sqrt(da * da + db * db);
}

}  // namespace ticker::metrics

#endif

#include <grader/metrics/Alignment.h>

#include <raytracer/base/Error.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace ticker::metrics {
namespace {

// OpenCV takes non-const data, but does not modify it.
cv::Mat matOf(const ByteView& picture) {
    requireSameSize(picture, picture);
    return {picture.height, picture.width, CV_8UC3, const_cast<std::uint8_t*>(picture.rgb.data())};
}

Picture pictureOf(const cv::Mat& mat) {
    Picture picture{mat.cols, mat.rows, {}};
    const cv::Mat whole = mat.isContinuous() ? mat : mat.clone();
    picture.rgb.assign(whole.datastart, whole.dataend);
    return picture;
}

cv::Mat shrunk(const cv::Mat& mat, int width, int height) {
    cv::Mat result;
    const bool smaller = width < mat.cols || height < mat.rows;
    cv::resize(mat, result, {width, height}, 0, 0, smaller ? cv::INTER_AREA : cv::INTER_LINEAR);
    return result;
}

cv::Mat greyOf(const ByteView& picture) {
    cv::Mat grey;
    cv::cvtColor(matOf(picture), grey, cv::COLOR_RGB2GRAY);
    return grey;
}

bool isFlat(const cv::Mat& grey) {
    double least = 0.0;
    double most = 0.0;
    cv::minMaxLoc(grey, &least, &most);
    return least == most;
}

}  // namespace

Picture resized(const ByteView& picture, int width, int height) {
    return pictureOf(shrunk(matOf(picture), width, height));
}

Picture mirrored(const ByteView& picture, Mirror mirror) {
    cv::Mat result;
    const int code = mirror == Mirror::leftRight ? 1 : mirror == Mirror::upDown ? 0 : -1;
    cv::flip(matOf(picture), result, code);
    return pictureOf(result);
}

Picture cropped(const ByteView& picture, const Box& box) {
    const cv::Mat mat = matOf(picture);
    const bool inside = box.x >= 0 && box.y >= 0 && box.width >= 1 && box.height >= 1 &&
                        box.x <= mat.cols - box.width && box.y <= mat.rows - box.height;
    if (!inside) throw raytracer::InputError("", 0, "the part reaches beyond the picture");
    return pictureOf(mat(cv::Rect{box.x, box.y, box.width, box.height}).clone());
}

double correlation(const ByteView& reference, const ByteView& test) {
    requireSameSize(reference, test);
    const cv::Mat first = greyOf(reference);
    const cv::Mat second = greyOf(test);
    if (isFlat(first) || isFlat(second)) return 0.0;
    cv::Mat result;
    cv::matchTemplate(first, second, result, cv::TM_CCOEFF_NORMED);
    return static_cast<double>(result.at<float>(0, 0));
}

Fit bestFit(const ByteView& whole, const ByteView& part, std::span<const int> widths) {
    const cv::Mat greyWhole = greyOf(whole);
    const cv::Mat greyPart = greyOf(part);
    Fit best;
    for (const int width : widths) {
        const int height = static_cast<int>(std::lround(1.0 * width * part.height / part.width));
        if (width < 1 || height < 1 || width > whole.width || height > whole.height) continue;
        const cv::Mat candidate = shrunk(greyPart, width, height);
        if (isFlat(candidate)) continue;
        cv::Mat result;
        cv::matchTemplate(greyWhole, candidate, result, cv::TM_CCOEFF_NORMED);
        double most = 0.0;
        cv::Point place;
        cv::minMaxLoc(result, nullptr, &most, nullptr, &place);
        // Over a flat patch OpenCV's quotient is 0 / 0, which may give NaN or infinity.
        if (std::isfinite(most) && most <= 1.0 + 1e-6 && most > best.correlation)
            best = {{place.x, place.y, width, height}, most};
    }
    return best;
}

}  // namespace ticker::metrics

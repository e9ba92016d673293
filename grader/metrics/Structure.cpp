#include <grader/metrics/Structure.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace ticker::metrics {
namespace {

cv::Mat floatsOf(const ByteView& picture) {
    // OpenCV takes non-const data, but only reads it.
    const cv::Mat bytes{picture.height, picture.width, CV_8UC3,
                        const_cast<std::uint8_t*>(picture.rgb.data())};
    cv::Mat floats;
    bytes.convertTo(floats, CV_32F);
    return floats;
}

double meanOfChannels(const cv::Scalar& channels) {
    return (channels[0] + channels[1] + channels[2]) / 3.0;
}

Map mapOf(const cv::Mat& channels) {
    Map map{channels.cols, channels.rows, {}};
    map.values.reserve(channels.total());
    for (int y = 0; y < channels.rows; ++y)
        for (int x = 0; x < channels.cols; ++x) {
            const auto& pixel = channels.at<cv::Vec3f>(y, x);
            map.values.push_back((pixel[0] + pixel[1] + pixel[2]) / 3.0F);
        }
    return map;
}

/// The mean around each pixel, weighted by the paper's Gaussian window.
cv::Mat windowed(const cv::Mat& values) {
    cv::Mat result;
    cv::GaussianBlur(values, result, {11, 11}, 1.5);
    return result;
}

/// Mean and variance of each pixel's window.
struct WindowMoments {
    explicit WindowMoments(const cv::Mat& values)
        : mean(windowed(values)),
          squaredMean(mean.mul(mean)),
          variance(windowed(values.mul(values)) - squaredMean) {}

    cv::Mat mean;
    cv::Mat squaredMean;
    cv::Mat variance;
};

/// Length of the gradient by Prewitt's operator, of the picture at half its size.
cv::Mat gradientOf(const cv::Mat& values) {
    cv::Mat averaged;
    cv::blur(values, averaged, {2, 2}, {0, 0}, cv::BORDER_CONSTANT);
    cv::Mat halved;
    cv::resize(averaged, halved, {}, 0.5, 0.5, cv::INTER_NEAREST);
    static const cv::Matx33d kAcross{1.0, 0.0, -1.0, 1.0, 0.0, -1.0, 1.0, 0.0, -1.0};
    const auto slope = [&](const cv::Matx33d& kernel) {
        cv::Mat result;
        cv::filter2D(halved, result, -1, kernel * (1.0 / 3.0), {-1, -1}, 0.0, cv::BORDER_CONSTANT);
        return result;
    };
    const cv::Mat across = slope(kAcross);
    const cv::Mat down = slope(kAcross.t());
    cv::Mat length;
    cv::sqrt(across.mul(across) + down.mul(down), length);
    return length;
}

}  // namespace

Measured ssim(const ByteView& reference, const ByteView& test) {
    requireSameSize(reference, test);
    // (0.01 L)^2 and (0.03 L)^2 with L = 255, as in the paper.
    const cv::Scalar ofMeans = cv::Scalar::all(6.5025);
    const cv::Scalar ofVariances = cv::Scalar::all(58.5225);
    const cv::Mat a = floatsOf(reference);
    const cv::Mat b = floatsOf(test);
    const WindowMoments ofA{a};
    const WindowMoments ofB{b};
    const cv::Mat means = ofA.mean.mul(ofB.mean);
    const cv::Mat covariance = windowed(a.mul(b)) - means;
    const cv::Mat alike = (2.0 * means + ofMeans).mul(2.0 * covariance + ofVariances);
    const cv::Mat whole = (ofA.squaredMean + ofB.squaredMean + ofMeans)
                              .mul(ofA.variance + ofB.variance + ofVariances);
    const cv::Mat quality = alike / whole;
    return {meanOfChannels(cv::mean(quality)), mapOf(quality)};
}

Measured gmsd(const ByteView& reference, const ByteView& test) {
    requireSameSize(reference, test);
    const cv::Scalar steady = cv::Scalar::all(170.0);  // the paper's, for values up to 255
    const cv::Mat a = gradientOf(floatsOf(reference));
    const cv::Mat b = gradientOf(floatsOf(test));
    const cv::Mat whole = a.mul(a) + b.mul(b) + steady;
    const cv::Mat quality = (2.0 * a.mul(b) + steady) / whole;
    cv::Scalar deviation;
    cv::meanStdDev(quality, cv::noArray(), deviation);
    return {meanOfChannels(deviation), mapOf(quality)};
}

}  // namespace ticker::metrics

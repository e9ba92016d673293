#include <grader/tasks/lens/answers/LensLog.h>
#include <grader/tasks/lens/answers/LensThreads.h>
#include <grader/tasks/lens/answers/RayColours.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace ticker::tasks {
namespace {

int nearestByFocus(const LensRay& ray, const LensLog& log) {
    const raytracer::RenderSettings& settings = log.asked->settings;
    const double along = (settings.dofFocalPlane - ray.origin.z) / ray.direction.z;
    const Vector3 meets = ray.origin + ray.direction * along;
    const int count = settings.width * settings.height;
    int nearest = -1;
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < count; ++i) {
        const Vector3 focal = focalPointOf(log.pixels[static_cast<std::size_t>(i)], settings);
        const double distance = (focal - meets).magnitude();
        if (distance < best) {
            best = distance;
            nearest = i;
        }
    }
    return nearest;
}

using PixelOf = std::function<int(const PlacedRay&)>;

void add(LensLog& log, const PlacedRay& placed, int pixel) {
    if (pixel < 0) return;
    const int count = log.asked->settings.width * log.asked->settings.height;
    log.pixels[static_cast<std::size_t>(placed.repetition * count + pixel)].rays.push_back(
        placed.ray);
}

// Sorts the rays by pixel, and drops those that the pixels had before. False if some pixel gets
// none.
bool distribute(LensLog& log, const std::vector<PlacedRay>& rays, const PixelOf& pixelOf) {
    for (LensPixel& pixel : log.pixels)
        pixel.rays.clear();
    for (const PlacedRay& placed : rays)
        add(log, placed, pixelOf(placed));
    return std::none_of(log.pixels.begin(), log.pixels.end(),
                        [](const LensPixel& pixel) { return pixel.rays.empty(); });
}

// Adds the rays of threads that trace a part of a pixel for the thread that sets it.
void addHelpers(LensLog& log, const std::vector<PlacedRay>& rays, const PixelOf& pixelOf) {
    for (const PlacedRay& placed : rays)
        if (placed.byHelper && pixelOf(placed) < 0)
            add(log, placed,
                placed.byCamera >= 0 ? placed.byCamera : nearestByFocus(placed.ray, log));
}

bool hasAllRays(const LensLog& log) {
    const auto asked = static_cast<std::size_t>(log.asked->settings.dofRayCount);
    return std::all_of(log.pixels.begin(), log.pixels.end(),
                       [&](const LensPixel& pixel) { return pixel.rays.size() >= asked; });
}

// Places the rays by the first of three ways that gives every pixel all its rays. One way is not
// enough, since loops may run in any order: if each pass over the picture adds one ray to every
// pixel, and only the last pass sets the pixels, nearly all rays come before the first pixel is
// set. If no way gives every pixel all its rays, the first is taken that gives every pixel one.
void place(LensLog& log, const std::vector<PlacedRay>& rays) {
    if (rays.empty()) return;
    const auto byFocus = [&](const PlacedRay& placed) { return nearestByFocus(placed.ray, log); };
    const std::array<PixelOf, 3> ways{&PlacedRay::bySet, &PlacedRay::byCamera, byFocus};
    const auto asked = static_cast<std::size_t>(log.asked->settings.dofRayCount);
    const auto placeBy = [&](const PixelOf& pixelOf) {
        if (!distribute(log, rays, pixelOf)) return false;
        addHelpers(log, rays, pixelOf);
        return true;
    };
    if (rays.size() >= asked * log.pixels.size())
        for (const PixelOf& pixelOf : ways)
            if (placeBy(pixelOf) && hasAllRays(log)) return;
    for (const PixelOf& pixelOf : ways)
        if (placeBy(pixelOf)) return;
}

// Whether each pixel's colour is the mean of its rays.
bool isExplained(const LensLog& log) {
    return std::ranges::all_of(log.pixels, [](const LensPixel& pixel) {
        const std::vector<ColourRGB> values = valuesOf(pixel);
        return !values.empty() && isNear(pixel.colour, meanOf(values.data(), values.size()));
    });
}

bool isPinhole(const LensRay& ray, const LensPixel& pixel) {
    constexpr double kSame = 1e-6;
    return ray.origin.magnitude() < kSame && (ray.direction - pixel.pinhole).magnitude() < kSame;
}

// Code with its own recursion may still trace an extra ray. This takes all its rays as samples, and
// recomputes the colours of those that were not traced. The result counts only if the mean explains
// each pixel's colour.
void placeTogether(LensLog& log, const std::vector<PlacedRay>& traced,
                   const std::vector<PlacedRay>& cast) {
    std::vector<PlacedRay> together = traced;
    for (PlacedRay placed : cast) {
        placed.ray.value = placed.ray.ambient;
        together.push_back(placed);
    }
    LensLog joined = log;
    joined.recomputed = !cast.empty();
    place(joined, together);
    if (hasAllRays(joined) && isExplained(joined)) log = joined;
}

// Whether the pinhole ray is the only visible ray of each pixel, while some pixel has another
// colour: then it is an extra ray beside rays that are not visible.
bool showsOnlyPinholeRays(const LensLog& log) {
    constexpr double kSame = 1e-3;
    const auto hasOthers = [](const LensPixel& pixel) {
        return pixel.rays.size() != 1 || !isPinhole(pixel.rays[0], pixel);
    };
    const auto isOfOthers = [](const LensPixel& pixel) {
        const ColourRGB seen = pixel.colour - pixel.rays[0].value.value_or(pixel.rays[0].ambient);
        return std::abs(seen.r) + std::abs(seen.g) + std::abs(seen.b) > kSame;
    };
    return std::ranges::none_of(log.pixels, hasOthers) &&
           std::ranges::any_of(log.pixels, isOfOthers);
}

}  // namespace

std::size_t LensLog::rayCount() const {
    std::size_t count = 0;
    for (const LensPixel& pixel : pixels)
        count += pixel.rays.size();
    return count;
}

bool lacksRays(const LensLog& log) {
    return showsOnlyPinholeRays(log) || std::ranges::any_of(log.pixels, [](const LensPixel& pixel) {
               return pixel.rays.empty();
           });
}

Vector3 pinholeDirection(const raytracer::RenderSettings& settings, int x, int y) {
    const double pitch = 2.0 * std::tan(std::numbers::pi / 8.0) / settings.width;
    return Vector3{(x + 0.5 - settings.width / 2.0) * pitch,
                   (settings.height / 2.0 - y - 0.5) * pitch, 1.0}
        .normalised();
}

double halfPixel(int width) {
    return std::tan(std::numbers::pi / 8.0) / width;
}

Vector3 focalPointOf(const LensPixel& pixel, const raytracer::RenderSettings& settings) {
    return pixel.pinhole * (settings.dofFocalPlane / pixel.pinhole.z);
}

LensLog readLensLog(const probe::RenderQuestion& asked, const probe::RenderAnswer& answer) {
    LensLog log;
    log.asked = &asked;
    log.cut = answer.eventsCut;
    for (int repetition = 0; repetition < asked.repetitions; ++repetition)
        for (int y = 0; y < asked.settings.height; ++y)
            for (int x = 0; x < asked.settings.width; ++x) {
                LensPixel pixel;
                pixel.repetition = repetition;
                pixel.pinhole = pinholeDirection(asked.settings, x, y);
                const auto image = static_cast<std::size_t>(repetition);
                const auto at = static_cast<std::size_t>(y * asked.settings.width + x);
                if (image < answer.images.size() && at < answer.images[image].size())
                    pixel.colour = answer.images[image][at];
                log.pixels.push_back(std::move(pixel));
            }
    const ReadRays rays = readThreads(asked, answer.events);
    std::vector<PlacedRay> traced = rays.entered;
    std::erase_if(traced, [](const PlacedRay& placed) { return placed.untraced; });
    if (traced.empty()) {
        place(log, rays.cast);
        return log;
    }
    place(log, traced);
    // Rays that hit nothing and were not traced are samples if the traced ones are too few, or if
    // the colours are the means of all of them alone: code may send more rays than it is asked for.
    if (traced.size() < rays.entered.size()) {
        LensLog withMisses = log;
        place(withMisses, rays.entered);
        if (!hasAllRays(log) || (!isExplained(log) && isExplained(withMisses))) log = withMisses;
    }
    if (!hasAllRays(log)) placeTogether(log, traced, rays.cast);
    return log;
}

}  // namespace ticker::tasks

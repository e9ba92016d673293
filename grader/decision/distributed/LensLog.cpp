#include <grader/decision/distributed/LensLog.h>
#include <grader/decision/distributed/Surfaces.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

namespace ticker::decision {
namespace {

using probe::Event;

/// A lens ray with all that may tell its pixel; -1 where nothing does.
struct PlacedRay {
    LensRay ray;
    int repetition = 0;
    int bySet = -1;
    int byCamera = -1;
};

bool isUsable(const Event& event) {
    const auto finite = [](const Vector3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    return finite(event.a) && finite(event.b) && event.b.magnitude() > 0.0;
}

// Follows one thread of one repetition.
class ThreadReader {
public:
    ThreadReader(const raytracer::RenderSettings& settings, const Surfaces& surfaces,
                 int repetition)
        : settings_(settings), surfaces_(surfaces), repetition_(repetition) {}

    void read(const Event& event) {
        switch (event.kind) {
            case Event::Kind::cameraRayAsked:
                camera_ = indexOf(event);
                break;
            case Event::Kind::traceBegan:
                begin(event);
                break;
            case Event::Kind::traceEnded:
                end(event);
                break;
            case Event::Kind::rayCast:
                cast(event);
                break;
            case Event::Kind::pixelSet:
                set(event);
                break;
            case Event::Kind::illuminateBegan:
            case Event::Kind::illuminateEnded:
                break;
        }
    }
    [[nodiscard]] const std::vector<PlacedRay>& traced() const { return traced_; }
    [[nodiscard]] const std::vector<PlacedRay>& cast() const { return cast_; }

private:
    [[nodiscard]] int indexOf(const Event& event) const {
        const bool inside =
            event.x >= 0 && event.x < settings_.width && event.y >= 0 && event.y < settings_.height;
        return inside ? event.y * settings_.width + event.x : -1;
    }
    [[nodiscard]] PlacedRay placed(const Event& event) const {
        PlacedRay placed;
        placed.ray.origin = event.a;
        placed.ray.direction = event.b.normalised();
        placed.repetition = repetition_;
        placed.byCamera = camera_;
        return placed;
    }
    void begin(const Event& event) {
        if (depth_++ > 0) return;
        open_ = isUsable(event);
        if (!open_) return;
        traced_.push_back(placed(event));
        traced_.back().ray.bounces = event.bounces;
    }
    void end(const Event& event) {
        if (depth_ == 0 || --depth_ > 0 || !open_) return;
        traced_.back().ray.value = ColourRGB{event.a.x, event.a.y, event.a.z};
    }
    // Rays that do not start on a surface are no shadow rays and no reflections.
    void cast(const Event& event) {
        constexpr double kOnSurface = 0.01;
        if (depth_ > 0 || !isUsable(event)) return;
        if (surfaces_.distanceToNearest(event.a) > kOnSurface) cast_.push_back(placed(event));
    }
    void set(const Event& event) {
        const int index = indexOf(event);
        for (auto* list : {&traced_, &cast_})
            for (auto ray = list->rbegin(); ray != list->rend() && ray->bySet < 0; ++ray)
                ray->bySet = index;
    }

    const raytracer::RenderSettings& settings_;
    const Surfaces& surfaces_;
    int repetition_;
    int depth_ = 0;
    bool open_ = false;
    int camera_ = -1;
    std::vector<PlacedRay> traced_;
    std::vector<PlacedRay> cast_;
};

std::vector<PlacedRay> readThreads(const probe::RenderQuestion& asked,
                                   const std::vector<Event>& events) {
    const Surfaces surfaces{asked.scene};
    std::map<std::pair<std::uint32_t, std::uint32_t>, ThreadReader> threads;
    for (const Event& event : events) {
        if (event.ask >= static_cast<std::uint32_t>(asked.repetitions)) continue;
        threads
            .try_emplace({event.ask, event.thread}, asked.settings, surfaces,
                         static_cast<int>(event.ask))
            .first->second.read(event);
    }
    std::vector<PlacedRay> traced;
    std::vector<PlacedRay> cast;
    for (const auto& [key, reader] : threads) {
        traced.insert(traced.end(), reader.traced().begin(), reader.traced().end());
        cast.insert(cast.end(), reader.cast().begin(), reader.cast().end());
    }
    return traced.empty() ? cast : traced;
}

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

// Succeeds only where every pixel gets a ray.
bool distribute(LensLog& log, const std::vector<PlacedRay>& rays,
                const std::function<int(const PlacedRay&)>& pixelOf) {
    for (LensPixel& pixel : log.pixels)
        pixel.rays.clear();
    const int count = log.asked->settings.width * log.asked->settings.height;
    for (const PlacedRay& placed : rays) {
        const int pixel = pixelOf(placed);
        if (pixel < 0) continue;
        log.pixels[static_cast<std::size_t>(placed.repetition * count + pixel)].rays.push_back(
            placed.ray);
    }
    return std::none_of(log.pixels.begin(), log.pixels.end(),
                        [](const LensPixel& pixel) { return pixel.rays.empty(); });
}

}  // namespace

std::size_t LensLog::rayCount() const {
    std::size_t count = 0;
    for (const LensPixel& pixel : pixels)
        count += pixel.rays.size();
    return count;
}

Vector3 pinholeDirection(const raytracer::RenderSettings& settings, int x, int y) {
    const double pitch = 2.0 * std::tan(std::numbers::pi / 8.0) / settings.width;
    return Vector3{(x + 0.5 - settings.width / 2.0) * pitch,
                   (settings.height / 2.0 - y - 0.5) * pitch, 1.0}
        .normalised();
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
    const std::vector<PlacedRay> rays = readThreads(asked, answer.events);
    if (rays.empty()) return log;
    if (distribute(log, rays, [](const PlacedRay& placed) { return placed.bySet; })) return log;
    if (distribute(log, rays, [](const PlacedRay& placed) { return placed.byCamera; })) return log;
    distribute(log, rays, [&](const PlacedRay& placed) { return nearestByFocus(placed.ray, log); });
    return log;
}

}  // namespace ticker::decision

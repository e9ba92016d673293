#include <grader/tasks/lens/answers/LensThreads.h>

#include <grader/tasks/support/Background.h>
#include <grader/tasks/support/Surfaces.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace ticker::tasks {
namespace {

using probe::Event;

bool isUsable(const Event& event) {
    const auto finite = [](const Vector3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    return finite(event.a) && finite(event.b) && event.b.magnitude() > 0.0;
}

bool isSameRay(const LensRay& a, const LensRay& b) {
    constexpr double kSame = 1e-9;
    return (a.origin - b.origin).magnitude() < kSame &&
           (a.direction - b.direction).magnitude() < kSame;
}

// Follows one thread of one repetition.
class ThreadReader {
public:
    ThreadReader(const probe::RenderQuestion& asked, const Surfaces& surfaces, int repetition)
        : scene_(asked.scene),
          settings_(asked.settings),
          surfaces_(surfaces),
          repetition_(repetition) {}

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
            case Event::Kind::illuminateViewer:
            case Event::Kind::illuminateEnded:
                break;
        }
    }
    /// To be called after the last event of this thread.
    void finish() {
        for (auto* list : {&entered_, &cast_})
            for (PlacedRay& ray : *list)
                ray.byHelper = !setsPixels_;
    }
    [[nodiscard]] const std::vector<PlacedRay>& entered() const { return entered_; }
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
    // Rays that start on a surface are shadow rays and reflections. `begin` makes an exception for
    // rays traced with all bounces: a lens that is far too large may reach the floor.
    [[nodiscard]] bool isFromOutside(const Event& event) const {
        constexpr double kOnSurface = 0.01;
        return isUsable(event) && surfaces_.distanceToNearest(event.a) > kOnSurface;
    }
    [[nodiscard]] ColourRGB ambientOf(int object) const {
        const auto objects = static_cast<int>(scene_.spheres.size() + scene_.planes.size());
        if (object < 0 || object >= objects) return kBackground;
        return materialOf(scene_, object).colour * scene_.ambientLighting;
    }
    void begin(const Event& event) {
        if (depth_++ > 0) return;
        const bool whole = event.bounces == settings_.bounces && isUsable(event);
        open_ = whole || isFromOutside(event);
        if (!open_) return;
        PlacedRay traced = placed(event);
        traced.ray.bounces = event.bounces;
        const auto askedAbout = [&](const std::vector<PlacedRay>& rays) {
            return !rays.empty() && isSameRay(rays.back().ray, traced.ray);
        };
        if (askedAbout(entered_) && entered_.back().untraced) entered_.pop_back();
        if (askedAbout(cast_)) cast_.pop_back();
        entered_.push_back(traced);
    }
    void end(const Event& event) {
        if (depth_ == 0 || --depth_ > 0 || !open_) return;
        entered_.back().ray.value = ColourRGB{event.a.x, event.a.y, event.a.z};
    }
    void cast(const Event& event) {
        if (depth_ > 0 || !isFromOutside(event)) return;
        PlacedRay cast = placed(event);
        cast.ray.ambient = ambientOf(event.object);
        cast_.push_back(cast);
        if (event.object >= 0) return;
        cast.untraced = true;
        cast.ray.value = kBackground;
        entered_.push_back(cast);
    }
    void set(const Event& event) {
        setsPixels_ = true;
        const int index = indexOf(event);
        for (auto* list : {&entered_, &cast_})
            for (auto ray = list->rbegin(); ray != list->rend() && ray->bySet < 0; ++ray)
                ray->bySet = index;
    }

    const raytracer::SceneDescription& scene_;
    const raytracer::RenderSettings& settings_;
    const Surfaces& surfaces_;
    int repetition_;
    int depth_ = 0;
    bool open_ = false;
    bool setsPixels_ = false;
    int camera_ = -1;
    std::vector<PlacedRay> entered_;
    std::vector<PlacedRay> cast_;
};

}  // namespace

ReadRays readThreads(const probe::RenderQuestion& asked, const std::vector<Event>& events) {
    const Surfaces surfaces{asked.scene};
    std::map<std::pair<std::uint32_t, std::uint32_t>, ThreadReader> threads;
    for (const Event& event : events) {
        if (event.ask >= static_cast<std::uint32_t>(asked.repetitions)) continue;
        threads.try_emplace({event.ask, event.thread}, asked, surfaces, static_cast<int>(event.ask))
            .first->second.read(event);
    }
    ReadRays rays;
    for (auto& [key, reader] : threads) {
        reader.finish();
        rays.entered.insert(rays.entered.end(), reader.entered().begin(), reader.entered().end());
        rays.cast.insert(rays.cast.end(), reader.cast().begin(), reader.cast().end());
    }
    return rays;
}

ThreadsMet threadsMet(const std::vector<Event>& events) {
    ThreadsMet met;
    std::map<std::uint16_t, bool> hasOpenPixel;  // of the threads that traced rays
    const Event* before = nullptr;
    for (const Event& event : events) {
        if (before != nullptr && before->thread != event.thread)
            if (const auto last = hasOpenPixel.find(before->thread);
                last != hasOpenPixel.end() && last->second)
                ++met.interrupted;
        if (event.kind == Event::Kind::traceBegan)
            hasOpenPixel[event.thread] = true;
        else if (event.kind == Event::Kind::pixelSet && hasOpenPixel.contains(event.thread))
            hasOpenPixel[event.thread] = false;
        before = &event;
    }
    met.several = hasOpenPixel.size() > 1;
    return met;
}

}  // namespace ticker::tasks

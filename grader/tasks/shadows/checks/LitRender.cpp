#include <grader/tasks/shadows/answers/ShadowCache.h>
#include <grader/tasks/shadows/checks/LitRender.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>

#include <grader/tasks/support/Distinct.h>
#include <grader/tasks/support/Finite.h>

#include <questions/RayGeometry.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace ticker::tasks {
namespace {

using probe::Event;

// Larger than every accepted shadow bias.
constexpr double kOnSurface = 0.01;

// Whether the ray starts towards some light and passes near it, with a margin.
bool aimsAtALight(const raytracer::SceneDescription& scene, double radius, const Event& ray) {
    const auto passes = [&](const raytracer::PointLight& light) {
        const Vector3 towards = light.position() - ray.a;
        const Vector3 direction = ray.b.normalised();
        return towards.dot(direction) > 0.0 && towards.cross(direction).magnitude() < 1.5 * radius;
    };
    return std::ranges::any_of(scene.pointLights, passes);
}

// Whether the ray starts within some light, as shadow rays do that run to the point.
bool startsInALight(const raytracer::SceneDescription& scene, double radius, const Event& ray) {
    return std::ranges::any_of(scene.pointLights, [&](const raytracer::PointLight& light) {
        return (light.position() - ray.a).magnitude() < 1.5 * radius;
    });
}

class Reader {
public:
    explicit Reader(const probe::RenderQuestion& asked)
        : surfaces_(asked.scene), wall_(static_cast<int>(asked.scene.spheres.size())) {
        lit_.asked.purpose = ShadowQuestion::Purpose::severalLights;
        lit_.asked.question.scene = asked.scene;
        lit_.asked.question.settings = asked.settings;
    }

    void read(const Event& event) {
        for (auto& [thread, open] : open_)
            if (thread != event.thread) open.isInterrupted = true;
        switch (event.kind) {
            case Event::Kind::illuminateBegan:
                begin(event);
                break;
            case Event::Kind::illuminateViewer:
                setViewer(event);
                break;
            case Event::Kind::rayCast:
                cast(event);
                break;
            case Event::Kind::illuminateEnded:
                end(event);
                break;
            case Event::Kind::cameraRayAsked:
            case Event::Kind::traceBegan:
            case Event::Kind::traceEnded:
            case Event::Kind::pixelSet:
                break;
        }
    }
    [[nodiscard]] LitRender take() && {
        lit_.lensRays = numberOfDifferent(std::move(lensRays_));
        return std::move(lit_);
    }

private:
    /// A point that a thread is lighting.
    struct Open {
        probe::LitPoint point;
        std::vector<Event> rays;
        bool isInterrupted = false;
    };

    void begin(const Event& event) {
        if (event.object != wall_ || !isFinite(event.a) || !isFinite(event.b)) return;
        open_[event.thread] = {{event.object, event.a, event.b, {}}, {}};
        if (!firstThread_) firstThread_ = event.thread;
        if (*firstThread_ != event.thread) lit_.severalThreads = true;
    }
    void setViewer(const Event& event) {
        if (const auto open = open_.find(event.thread); open != open_.end())
            open->second.point.viewer = event.a;
    }
    void cast(const Event& event) {
        if (!isFinite(event.a) || !isFinite(event.b) || !(event.b.magnitude() > 0.0)) return;
        const raytracer::SceneDescription& scene = lit_.asked.question.scene;
        const double radius = lit_.asked.question.settings.lightSize;
        if (const auto open = open_.find(event.thread); open != open_.end()) {
            open->second.rays.push_back(event);
            // NOLINTNEXTLINE(bugprone-branch-clone): a ray of the lens may aim at a light, too
        } else if (startsInALight(scene, radius, event)) {
            ++lit_.looseRays;
        } else if (surfaces_.distanceToNearest(event.a) > kOnSurface) {
            const auto cell = [](double value) { return std::llround(value * 1e9); };
            lensRays_.push_back({cell(event.a.x), cell(event.a.y), cell(event.a.z), cell(event.b.x),
                                 cell(event.b.y), cell(event.b.z)});
        } else if (aimsAtALight(scene, radius, event)) {
            ++lit_.looseRays;
        }
    }
    // Points whose lighting never ended are left out.
    void end(const Event& event) {
        const auto open = open_.find(event.thread);
        if (open == open_.end()) return;
        const auto number = static_cast<std::uint32_t>(lit_.answer.colours.size());
        for (Event& ray : open->second.rays) {
            ray.ask = number;
            lit_.answer.events.push_back(ray);
        }
        lit_.asked.question.points.push_back(open->second.point);
        lit_.asked.zones.emplace_back(lit_.asked.question.scene.pointLights.size(), Zone::penumbra);
        lit_.answer.colours.push_back({event.a.x, event.a.y, event.a.z});
        if (open->second.isInterrupted) ++lit_.interrupted;
        open_.erase(open);
    }

    Surfaces surfaces_;
    int wall_;
    LitRender lit_;
    std::map<std::uint16_t, Open> open_;  // by thread
    std::optional<std::uint16_t> firstThread_;
    std::vector<std::array<long long, 6>> lensRays_;
};

// Whether rays start elsewhere or miss their light.
bool goAstray(const ShadowLog& log) {
    const double reach = log.settings().lightSize * (1.0 + 1e-6) + kLargestBias;
    for (const PointLog& point : log.points)
        for (const std::vector<AimLine>& lines : point.lines)
            for (const AimLine& line : lines)
                if (line.miss > reach || biasOf(line, point) > kLargestBias) return true;
    return false;
}

// The reading that fits the most points. Readings with wide intervals may fit a point by chance.
FitCount bestFit(const ShadowLog& log) {
    FitCount best;
    for (const ShadowReading& reading : acceptedShadowReadings()) {
        const FitCount fits = countFits(log, reading, ShadowArithmetic::right);
        if (best.points == 0 || fits.fitting > best.fitting) best = fits;
    }
    return best;
}

std::size_t raysAsked(const LitRender& lit) {
    return static_cast<std::size_t>(lit.asked.question.settings.shadowRayCount);
}

std::size_t raysFor(const LitRender& lit, std::size_t points, std::size_t toALight) {
    return points * lit.asked.question.scene.pointLights.size() * toALight;
}

// True if illuminate has threads of its own, whose rays cannot be assigned to a point.
bool helpersCastTheRest(const LitRender& lit) {
    const std::size_t rays = lit.answer.events.size() + lit.looseRays;
    return lit.looseRays > 0 && rays >= raysFor(lit, lit.answer.colours.size(), raysAsked(lit));
}

// The difference if `render` never calls `illuminate`, but lights its points by itself: its rays
// are then only counted.
std::optional<std::string> looseDifference(const LitRender& lit, const VisibleRays& visible) {
    const std::size_t toALight = visible.toALight.value_or(raysAsked(lit));
    const std::size_t expected = raysFor(lit, lit.lensRays, toALight);
    if (lit.looseRays == 0 || lit.looseRays >= expected) return std::nullopt;
    const double share = static_cast<double>(lit.looseRays) / static_cast<double>(expected);
    return fmt::format("a point gets {:.2g} of {} shadow rays to a light, in the mean",
                       share * static_cast<double>(toALight), toALight);
}

}  // namespace

LitRender readLitRender(const probe::RenderQuestion& asked, const probe::RenderAnswer& answer) {
    Reader reader{asked};
    if (!answer.eventsCut)
        for (const Event& event : answer.events)
            reader.read(event);
    return std::move(reader).take();
}

std::optional<std::string> litDifference(const LitRender& lit, const VisibleRays& visible) {
    if (lit.answer.colours.empty())
        return visible.cached ? std::nullopt : looseDifference(lit, visible);
    if (!visible.all || lit.answer.events.empty() || helpersCastTheRest(lit)) return std::nullopt;
    ShadowLog log = readShadowLog(lit.asked, lit.answer);
    if (visible.cached) log = withCachedRays(std::move(log));
    const std::size_t asked = raysAsked(lit);
    if (const RayCounts counts = countRays({&log}); counts.fewest < asked)
        return fmt::format("some points get {} of {} shadow rays to a light", counts.fewest, asked);
    if (goAstray(log)) return "some shadow rays start at another point, or pass the light";
    if (fitsAnyReading(log)) return std::nullopt;
    const FitCount best = bestFit(log);
    return fmt::format("{} of {} points have another colour than their own shadow rays give",
                       best.points - best.fitting, best.points);
}

}  // namespace ticker::tasks

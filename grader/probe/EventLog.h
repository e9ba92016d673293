#ifndef TICKER_PROBE_EVENTLOG_H
#define TICKER_PROBE_EVENTLOG_H

#include <grader/probe/Question.h>

#include <raytracer/base/RenderObserver.h>
#include <raytracer/scene/Scene.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ticker::probe {

/// Writes observed events into the caller's memory at once, so that a crash loses none of the
/// earlier ones. Any number of threads may be observed.
class EventLog final : public raytracer::RenderObserver {
public:
    /// @param slots  Zero bytes for a whole number of `Event`s, aligned to 8.
    /// @param seen   Counts all events, including those that do not fit; set to 0.
    EventLog(std::span<std::byte> slots, std::uint64_t& seen);

    /// Subsequent events belong to this position, point or repetition.
    void beginAsk(std::uint32_t ask) { ask_ = ask; }

    /// Makes the observed threads give way to each other after every traced ray and after the first
    /// shadow ray of every point, the first time after a short wait for a second thread. Data races
    /// between pixels and between lights then show even on a busy machine. If `trace` is the
    /// student's own code, which reports nothing, the threads give way after every ray.
    void takeTurns() { takesTurns_ = true; }

    /// Later events are not kept: the question has its answer, but code that remembers an earlier
    /// scene casts rays in it.
    void close() { capacity_ = 0; }

    /// Sets the scene whose objects are numbered; not owned; null: every object is -1.
    void watch(const raytracer::Scene* scene) { scene_ = scene; }

    void cameraRayAsked(int x, int y, const raytracer::Ray& ray) override;
    void traceBegan(const raytracer::Ray& ray, int bouncesLeft) override;
    void traceEnded(const ColourRGB& colour) override;
    void illuminateBegan(const raytracer::SceneObject& object, const Vector3& position,
                         const Vector3& normal, const Vector3& viewer) override;
    void illuminateEnded(const ColourRGB& colour) override;
    void rayCast(const raytracer::Ray& ray, const raytracer::RaycastHit* hit) override;
    void pixelSet(int x, int y, const ColourRGB& colour) override;

private:
    /// Checked before anything else: a picture casts millions of rays, and most questions need no
    /// log.
    [[nodiscard]] bool keepsNothing() const { return capacity_ == 0; }
    void record(Event event);
    /// Asks the kernel for the memory of the next slots at once.
    void prepareBlock(std::uint64_t slot) const;
    [[nodiscard]] std::uint32_t threadNumber();
    void giveWay();
    /// @param mostWaits  Milliseconds, of all threads together.
    void awaitSecondThread(int mostWaits);
    [[nodiscard]] std::int32_t numberOf(const raytracer::SceneObject* object) const;

    std::byte* slots_;
    std::uint64_t capacity_;
    std::uint64_t& seen_;
    const raytracer::Scene* scene_ = nullptr;
    bool takesTurns_ = false;
    std::atomic<bool> seesTraces_{false};
    std::atomic<int> waits_{0};
    std::atomic<std::uint32_t> ask_{0};
    std::atomic<std::uint32_t> threads_{0};
    std::uint64_t generation_;
};

}  // namespace ticker::probe

#endif

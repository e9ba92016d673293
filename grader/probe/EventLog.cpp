#include <grader/probe/EventLog.h>

#include <raytracer/geometry/RaycastHit.h>
#include <raytracer/geometry/SceneObject.h>

#include <sys/mman.h>
#include <sys/syscall.h>
#include <algorithm>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

namespace ticker::probe {
namespace {

// Identifies a log: a thread can outlive it, and a new log may get the same address.
std::uint64_t nextGeneration() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

// Set for a thread between the start of a point's lighting and its first shadow ray: one turn for
// each point is enough, and each turn may cost a time slice on a busy machine.
bool& turnIsDue() {
    thread_local bool isDue = false;
    return isDue;
}

// One page fault for each page of a long log would take longer than the questions.
constexpr std::uint64_t kSlotsOfABlock = (64U << 10U) / sizeof(Event);

// The system call is made directly: a submission with a madvise of its own would learn that its
// rays are logged.
void populate(const std::byte* first, std::uint64_t bytes) {
#if defined(__x86_64__)
    long result = SYS_madvise;
    asm volatile("syscall"
                 : "+a"(result)
                 : "D"(first), "S"(bytes), "d"(MADV_POPULATE_WRITE)
                 : "rcx", "r11", "memory");
#else
    static_cast<void>(first);
    static_cast<void>(bytes);
#endif
}

Vector3 asVector(const ColourRGB& colour) {
    return {colour.r, colour.g, colour.b};
}

Event rayEvent(Event::Kind kind, const raytracer::Ray& ray) {
    Event event;
    event.kind = kind;
    event.a = ray.origin;
    event.b = ray.direction;
    return event;
}

Event colourEvent(Event::Kind kind, const ColourRGB& colour) {
    Event event;
    event.kind = kind;
    event.a = asVector(colour);
    return event;
}

}  // namespace

EventLog::EventLog(std::span<std::byte> slots, std::uint64_t& seen)
    : slots_(slots.data()),
      capacity_(slots.size() / sizeof(Event)),
      seen_(seen),
      generation_(nextGeneration()) {
    seen_ = 0;
}

void EventLog::cameraRayAsked(int x, int y, const raytracer::Ray& ray) {
    if (keepsNothing()) return;
    Event event = rayEvent(Event::Kind::cameraRayAsked, ray);
    event.x = x;
    event.y = y;
    record(event);
}

void EventLog::traceBegan(const raytracer::Ray& ray, int bouncesLeft) {
    if (keepsNothing()) return;
    seesTraces_ = true;
    Event event = rayEvent(Event::Kind::traceBegan, ray);
    event.bounces = bouncesLeft;
    record(event);
}

void EventLog::traceEnded(const ColourRGB& colour) {
    if (keepsNothing()) return;
    record(colourEvent(Event::Kind::traceEnded, colour));
    if (takesTurns_) giveWay();
}

void EventLog::illuminateBegan(const raytracer::SceneObject& object, const Vector3& position,
                               const Vector3& normal, const Vector3& viewer) {
    if (keepsNothing()) return;
    turnIsDue() = takesTurns_;
    Event event;
    event.kind = Event::Kind::illuminateBegan;
    event.object = numberOf(&object);
    event.a = position;
    event.b = normal;
    record(event);
    event = {};
    event.kind = Event::Kind::illuminateViewer;
    event.a = viewer;
    record(event);
}

void EventLog::illuminateEnded(const ColourRGB& colour) {
    if (keepsNothing()) return;
    turnIsDue() = false;
    record(colourEvent(Event::Kind::illuminateEnded, colour));
}

void EventLog::rayCast(const raytracer::Ray& ray, const raytracer::RaycastHit* hit) {
    if (keepsNothing()) return;
    Event event = rayEvent(Event::Kind::rayCast, ray);
    if (hit != nullptr) {
        event.object = numberOf(hit->object);
        event.distance = hit->distance;
    }
    record(event);
    if (std::exchange(turnIsDue(), false)) giveWay();
    // A yield does nothing while a processor is idle, and costs a whole time slice while all are
    // busy. A short sleep lets the other thread run in both cases.
    if (!takesTurns_ || seesTraces_) return;
    constexpr int kMostWaits = 200;
    awaitSecondThread(kMostWaits);
    std::this_thread::sleep_for(std::chrono::microseconds{1});
}

void EventLog::pixelSet(int x, int y, const ColourRGB& colour) {
    if (keepsNothing()) return;
    Event event = colourEvent(Event::Kind::pixelSet, colour);
    event.x = x;
    event.y = y;
    record(event);
}

void EventLog::record(Event event) {
    const std::uint64_t slot =
        std::atomic_ref<std::uint64_t>{seen_}.fetch_add(1, std::memory_order_relaxed);
    if (slot >= capacity_) return;
    event.thread = static_cast<std::uint16_t>(threadNumber());
    event.ask = ask_;
    if (slot % kSlotsOfABlock == 0) prepareBlock(slot);
    std::byte* at = slots_ + slot * sizeof(Event);
    constexpr std::size_t kBody = sizeof event.kind;
    std::memcpy(at + kBody, reinterpret_cast<const std::byte*>(&event) + kBody,
                sizeof event - kBody);
    // The kind is written last, plus one: a slot with kind 0 was not completely written.
    auto& kind = *reinterpret_cast<std::uint16_t*>(at);
    const auto written = static_cast<std::uint16_t>(static_cast<std::uint16_t>(event.kind) + 1U);
    std::atomic_ref<std::uint16_t>{kind}.store(written, std::memory_order_release);
}

// Older kernels refuse MADV_POPULATE_WRITE; the pages then come one page fault at a time.
void EventLog::prepareBlock(std::uint64_t slot) const {
    constexpr std::uintptr_t kPageBytes = 4096;
    const std::uint64_t end = std::min(slot + kSlotsOfABlock, capacity_);
    std::byte* const first = slots_ + slot * sizeof(Event);
    const std::uintptr_t beforeIt = reinterpret_cast<std::uintptr_t>(first) % kPageBytes;
    populate(first - beforeIt, beforeIt + (end - slot) * sizeof(Event));
}

// Waits up to 20 ms for a second thread, since a new thread may have to wait for a processor. A
// submission with one thread pays that once for each question. The wait comes after a traced ray,
// never before the first one: code that fills a table for all pixels at the first pixel must not be
// delayed in the middle of that.
void EventLog::giveWay() {
    constexpr int kMostWaits = 20;
    awaitSecondThread(kMostWaits);
    std::this_thread::yield();
}

void EventLog::awaitSecondThread(int mostWaits) {
    while (threads_ < 2 && waits_++ < mostWaits)
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
}

std::uint32_t EventLog::threadNumber() {
    struct Known {
        std::uint64_t generation = 0;
        std::uint32_t number = 0;
    };
    thread_local Known known;
    if (known.generation != generation_) known = {generation_, threads_++};
    return known.number;
}

std::int32_t EventLog::numberOf(const raytracer::SceneObject* object) const {
    if (scene_ == nullptr) return -1;
    std::int32_t number = 0;
    for (const auto& candidate : scene_->objects()) {
        if (candidate.get() == object) return number;
        ++number;
    }
    return -1;
}

}  // namespace ticker::probe

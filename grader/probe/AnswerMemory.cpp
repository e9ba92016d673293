#include <grader/probe/AnswerMemory.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

namespace ticker::probe {
namespace {

constexpr std::uint64_t kMostBytes = 1U << 30U;

std::uint64_t valueCountOf(const NormalQuestion& question) {
    return question.positions.size();
}
std::uint64_t valueCountOf(const IlluminateQuestion& question) {
    return question.points.size();
}
std::uint64_t valueCountOf(const RenderQuestion& question) {
    return static_cast<std::uint64_t>(question.settings.imageWidth()) *
           static_cast<std::uint64_t>(question.settings.imageHeight()) *
           static_cast<std::uint64_t>(question.repetitions);
}

std::uint64_t valueCountOf(const HitQuestion& question) {
    return question.rays.size() * kValuesOfHit;
}
std::uint64_t valueCountOf(const TraceQuestion& question) {
    return question.rays.size();
}

std::uint64_t valueCountOf(const CallQuestion& question) {
    return question.width == 0 ? 0 : question.arguments.size() / question.width;
}

std::uint64_t askCountOf(const HitQuestion& question) {
    return question.rays.size();
}
std::uint64_t askCountOf(const RenderQuestion& question) {
    return static_cast<std::uint64_t>(question.repetitions);
}
template <typename AnyQuestion>
std::uint64_t askCountOf(const AnyQuestion& question) {
    return valueCountOf(question);
}

std::uint32_t eventCapacityOf(const NormalQuestion& /*question*/) {
    return 0;
}
std::uint32_t eventCapacityOf(const HitQuestion& /*question*/) {
    return 0;
}
std::uint32_t eventCapacityOf(const CallQuestion& /*question*/) {
    return 0;
}
template <typename AnyQuestion>
std::uint32_t eventCapacityOf(const AnyQuestion& question) {
    return question.eventCapacity;
}

std::size_t claim(std::uint64_t& used, std::uint64_t count, std::uint64_t size) {
    const std::uint64_t at = used;
    if (count > (kMostBytes - used) / size)
        throw raytracer::Error("questions: the answers would take more than 1 GiB");
    used += count * size;
    return static_cast<std::size_t>(at);
}

template <typename Value>
Value load(const CopyBytes& copy, std::size_t at) {
    Value value{};
    copy(at, std::as_writable_bytes(std::span{&value, 1}));
    return value;
}

template <typename Value>
std::vector<Value> loadAll(const CopyBytes& copy, std::size_t at, std::size_t count) {
    std::vector<Value> values(count);
    if (count > 0) copy(at, std::as_writable_bytes(std::span{values}));
    return values;
}

CopyBytes copyOf(std::span<const std::byte> memory) {
    return [memory](std::size_t at, std::span<std::byte> to) {
        std::memcpy(to.data(), memory.data() + at, to.size());
    };
}

AnswerState stateOf(const AnswerHeader& header) {
    if (header.state == static_cast<std::uint32_t>(AnswerState::answered))
        return AnswerState::answered;
    if (header.state == static_cast<std::uint32_t>(AnswerState::threw)) return AnswerState::threw;
    return AnswerState::missing;
}

// A header that was not begun still holds the fill pattern.
bool wasBegun(const AnswerHeader& header) {
    return stateOf(header) != AnswerState::missing || header.state == AnswerHeader::kBegun;
}

std::string messageOf(const AnswerHeader& header) {
    if (!wasBegun(header)) return {};
    const auto* end = std::find(std::begin(header.message), std::end(header.message) - 1, '\0');
    return {std::begin(header.message), end};
}

std::vector<Event> eventsOf(const AnswerHeader& header, const CopyBytes& copy,
                            const AnswerPlace& place, std::size_t objectCount) {
    if (!wasBegun(header)) return {};
    const std::uint64_t count = std::min<std::uint64_t>(header.eventsSeen, place.eventCapacity);
    auto events = loadAll<Event>(copy, place.events, static_cast<std::size_t>(count));
    const auto isImpossible = [&](Event& event) {
        // A slot holds kind + 1: 0 marks an event that was not completely written.
        const auto kind = static_cast<std::uint32_t>(event.kind);
        if (kind == 0 || kind > static_cast<std::uint32_t>(Event::Kind::pixelSet) + 1) return true;
        event.kind = static_cast<Event::Kind>(kind - 1);
        const bool objectKnown =
            event.object >= -1 && event.object < static_cast<std::int64_t>(objectCount);
        return event.ask >= place.askCount || !objectKnown;
    };
    std::erase_if(events, isImpossible);
    return events;
}

struct Read {
    const CopyBytes& memory;
    const AnswerPlace& place;
    AnswerHeader header = load<AnswerHeader>(memory, place.header);

    Answer operator()(const NormalQuestion& /*question*/) const {
        NormalAnswer answer;
        answer.state = stateOf(header);
        answer.message = messageOf(header);
        answer.exceptions = exceptions();
        answer.normals = loadAll<Vector3>(memory, place.values, place.valueCount);
        return answer;
    }

    Answer operator()(const IlluminateQuestion& question) const { return colours(question.scene); }
    Answer operator()(const TraceQuestion& question) const { return colours(question.scene); }

    Answer operator()(const HitQuestion& question) const {
        HitAnswer answer;
        answer.state = stateOf(header);
        answer.message = messageOf(header);
        answer.exceptions = exceptions();
        const auto values = loadAll<Vector3>(memory, place.values, place.valueCount);
        for (std::size_t i = 0; i + kValuesOfHit <= values.size(); i += kValuesOfHit) {
            const double object = values[i].z;
            const bool known =
                object >= 0.0 && object < static_cast<double>(objectCount(question.scene));
            answer.hits.push_back({values[i].x == 1.0, values[i].y,
                                   known ? static_cast<int>(object) : -1, values[i + 1],
                                   values[i + 2]});
        }
        return answer;
    }

    Answer operator()(const CallQuestion& /*question*/) const {
        CallAnswer answer;
        answer.state = stateOf(header);
        answer.message = messageOf(header);
        answer.exceptions = exceptions();
        answer.values = loadAll<Vector3>(memory, place.values, place.valueCount);
        return answer;
    }

    Answer operator()(const RenderQuestion& question) const {
        RenderAnswer answer;
        answer.state = stateOf(header);
        answer.message = messageOf(header);
        answer.exceptions = exceptions();
        answer.width = question.settings.imageWidth();
        answer.height = question.settings.imageHeight();
        answer.wrongSize = wasBegun(header) && header.wrongSize != 0;
        const std::size_t pixels = place.valueCount / place.askCount;
        for (std::size_t i = 0; i < place.askCount; ++i)
            answer.images.push_back(
                loadAll<ColourRGB>(memory, place.values + i * pixels * sizeof(ColourRGB), pixels));
        answer.events = eventsOf(header, memory, place, objectCount(question.scene));
        answer.eventsCut = eventsCut();
        return answer;
    }

private:
    [[nodiscard]] IlluminateAnswer colours(const raytracer::SceneDescription& scene) const {
        IlluminateAnswer answer;
        answer.state = stateOf(header);
        answer.message = messageOf(header);
        answer.exceptions = exceptions();
        answer.colours = loadAll<ColourRGB>(memory, place.values, place.valueCount);
        answer.events = eventsOf(header, memory, place, objectCount(scene));
        answer.eventsCut = eventsCut();
        return answer;
    }
    [[nodiscard]] std::uint32_t exceptions() const {
        return wasBegun(header) ? std::min(header.exceptions, place.askCount) : 0;
    }
    [[nodiscard]] bool eventsCut() const {
        return wasBegun(header) && header.eventsSeen > place.eventCapacity &&
               place.eventCapacity > 0;
    }
    static std::size_t objectCount(const raytracer::SceneDescription& scene) {
        return scene.spheres.size() + scene.planes.size();
    }
};

void requireRoom(std::span<const std::byte> memory, const AnswerLayout& layout) {
    if (memory.size() < layout.totalBytes)
        throw raytracer::Error("the answer memory is smaller than the answers");
}

bool isFilling(double a, double b, double c) {
    return std::bit_cast<std::uint64_t>(a) == kUnansweredWord &&
           std::bit_cast<std::uint64_t>(b) == kUnansweredWord &&
           std::bit_cast<std::uint64_t>(c) == kUnansweredWord;
}

}  // namespace

AnswerLayout layoutFor(const std::vector<Question>& questions) {
    AnswerLayout layout;
    std::uint64_t used = sizeof(SheetHeader);
    for (const Question& question : questions) {
        AnswerPlace place;
        const auto count = std::visit([](const auto& q) { return valueCountOf(q); }, question);
        place.header = claim(used, 1, sizeof(AnswerHeader));
        place.values = claim(used, count, sizeof(Vector3));
        place.valueCount = static_cast<std::size_t>(count);
        place.eventCapacity =
            std::visit([](const auto& q) { return eventCapacityOf(q); }, question);
        place.askCount = static_cast<std::uint32_t>(
            std::visit([](const auto& q) { return askCountOf(q); }, question));
        layout.places.push_back(place);
    }
    layout.filledBytes = static_cast<std::size_t>(used);
    for (AnswerPlace& place : layout.places)
        place.events = claim(used, place.eventCapacity, sizeof(Event));
    layout.totalBytes = static_cast<std::size_t>(used);
    return layout;
}

std::vector<std::byte> unanswered(const AnswerLayout& layout) {
    const std::vector<std::uint64_t> words(layout.filledBytes / sizeof kUnansweredWord,
                                           kUnansweredWord);
    const auto bytes = std::as_bytes(std::span{words});
    return {bytes.begin(), bytes.end()};
}

void fillUnanswered(std::span<std::byte> memory, const AnswerLayout& layout) {
    requireRoom(memory, layout);
    std::ranges::copy(unanswered(layout), memory.begin());
}

std::vector<Answer> readAnswers(const std::vector<Question>& questions, const CopyBytes& copy) {
    const AnswerLayout layout = layoutFor(questions);
    std::vector<Answer> answers;
    answers.reserve(questions.size());
    for (std::size_t i = 0; i < questions.size(); ++i)
        answers.push_back(std::visit(Read{copy, layout.places[i]}, questions[i]));
    return answers;
}

std::vector<Answer> readAnswers(const std::vector<Question>& questions,
                                std::span<const std::byte> memory) {
    requireRoom(memory, layoutFor(questions));
    return readAnswers(questions, copyOf(memory));
}

bool saysFinished(const CopyBytes& copy) {
    return load<SheetHeader>(copy, 0).finished == kSheetFinished;
}

bool saysFinished(std::span<const std::byte> memory) {
    return memory.size() >= sizeof(SheetHeader) && saysFinished(copyOf(memory));
}

bool isUnanswered(const Vector3& value) {
    return isFilling(value.x, value.y, value.z);
}

bool isUnanswered(const ColourRGB& value) {
    return isFilling(value.r, value.g, value.b);
}

}  // namespace ticker::probe

// The answer memory of a submission's process, which is untrusted.
#include "../support/SampleQuestions.h"
#include "Fuzz.h"

#include <grader/probe/AnswerMemory.h>
#include <grader/probe/Calls.h>
#include <grader/probe/Respond.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace ticker {
namespace {

probe::Vector3 noPlace(const raytracer::Scene& /*scene*/, std::span<const double> /*arguments*/) {
    return {};
}

constexpr std::array kCalls{probe::Call{"any", noPlace}};

}  // namespace

std::span<const probe::Call> probe::calls() {
    return kCalls;
}

}  // namespace ticker

namespace ticker::fuzz {
namespace {

using Words = std::vector<std::uint64_t>;

constexpr std::uint32_t kMostEvents = 20;

const std::vector<probe::Question>& questions() {
    static const std::vector<probe::Question> asked{
        tests::normalQuestion(), tests::illuminateQuestion(kMostEvents),
        tests::renderQuestion(kMostEvents), probe::HitQuestion{tests::smallScene(), {{}, {}}},
        probe::CallQuestion{"any", tests::smallScene(), 0, 2, {0.0, 1.0}}};
    return asked;
}

Words emptyMemory() {
    const probe::AnswerLayout layout = probe::layoutFor(questions());
    Words words((layout.totalBytes + 7) / 8);
    probe::fillUnanswered(std::as_writable_bytes(std::span{words}), layout);
    return words;
}

void checkEvents(const std::vector<probe::Event>& events, std::size_t asks) {
    require(events.size() <= kMostEvents, "no more events than there is room for");
    for (const probe::Event& event : events)
        require(event.kind <= probe::Event::Kind::pixelSet && event.ask < asks &&
                    event.object >= -1 && event.object < 2,
                "events are of what was asked");
}

void check(const probe::NormalAnswer& answer) {
    require(answer.normals.size() == 3 && answer.exceptions <= 3, "one normal for each position");
}
void check(const probe::IlluminateAnswer& answer) {
    require(answer.colours.size() == 2 && answer.exceptions <= 2, "one colour for each point");
    checkEvents(answer.events, 2);
}
void check(const probe::HitAnswer& answer) {
    require(answer.hits.size() == 2 && answer.exceptions <= 2, "one hit for each ray");
}
void check(const probe::CallAnswer& answer) {
    require(answer.values.size() == 1 && answer.exceptions <= 1, "one value for each row");
}
void check(const probe::RenderAnswer& answer) {
    require(answer.images.size() == 2 && answer.images[1].size() == 48 && answer.exceptions <= 2,
            "pictures of the size that was asked for");
    checkEvents(answer.events, 2);
}

}  // namespace

bool give(std::string_view input) {
    Words words = emptyMemory();
    const auto memory = std::as_writable_bytes(std::span{words});
    std::memcpy(memory.data(), input.data(), std::min(input.size(), memory.size()));
    const std::vector<probe::Answer> answers = probe::readAnswers(questions(), memory);
    require(answers.size() == questions().size(), "one answer for each question");
    for (const probe::Answer& answer : answers)
        std::visit(
            [](const auto& any) {
                require(any.state <= probe::AnswerState::threw && any.message.size() < 232,
                        "states and messages are bounded");
                check(any);
            },
            answer);
    return probe::saysFinished(memory);
}

std::vector<std::string> seeds() {
    Words answered = emptyMemory();
    const auto memory = std::as_writable_bytes(std::span{answered});
    probe::respond(questions(), memory);
    const auto text = [](const Words& words) {
        return std::string{reinterpret_cast<const char*>(words.data()), words.size() * 8};
    };
    return {text(answered), text(emptyMemory())};
}

}  // namespace ticker::fuzz

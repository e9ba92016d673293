#include <grader/tasks/support/ThreadPictures.h>

#include <variant>

namespace ticker::tasks {
namespace {

using probe::RenderAnswer;

const RenderAnswer* picturesAt(const probe::Run& run, std::size_t index, int pictures) {
    if (index >= run.answers.size()) return nullptr;
    const auto* answer = std::get_if<RenderAnswer>(&run.answers[index]);
    const bool isWhole = answer != nullptr && answer->state == probe::AnswerState::answered &&
                         !answer->wrongSize &&
                         answer->images.size() == static_cast<std::size_t>(pictures);
    return isWhole ? answer : nullptr;
}

}  // namespace

void addWithOneThreadAndWithTwo(std::vector<probe::Question>& questions,
                                probe::RenderQuestion question) {
    question.eventCapacity = 64;
    for (const int threads : {1, 2}) {
        question.settings.threads = threads;
        questions.emplace_back(question);
    }
}

std::optional<ThreadPictures> threadPicturesAt(const probe::Run& run, std::size_t first,
                                               int pictures) {
    const RenderAnswer* alone = picturesAt(run, first, pictures);
    const RenderAnswer* together = picturesAt(run, first + 1, pictures);
    if (alone == nullptr || together == nullptr) return std::nullopt;
    return ThreadPictures{alone, together};
}

}  // namespace ticker::tasks

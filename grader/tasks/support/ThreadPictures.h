#ifndef TICKER_TASKS_SUPPORT_THREADPICTURES_H
#define TICKER_TASKS_SUPPORT_THREADPICTURES_H

#include <grader/probe/Examinee.h>
#include <grader/probe/Question.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace ticker::tasks {

/// Asks for the same pictures with one thread, and then with two. With the little log that they
/// have threads wait for each other, so that variables which calls share show more often.
void addWithOneThreadAndWithTwo(std::vector<probe::Question>& questions,
                                probe::RenderQuestion question);

/// The pictures of such a pair.
struct ThreadPictures {
    const probe::RenderAnswer* alone = nullptr;
    const probe::RenderAnswer* together = nullptr;

    /// Number of pixels for which isSame(alone, together) is false.
    template <class IsSame>
    [[nodiscard]] std::size_t differing(const IsSame& isSame) const {
        std::size_t count = 0;
        for (std::size_t k = 0; k < alone->images.size(); ++k)
            for (std::size_t i = 0; i < alone->images[k].size(); ++i)
                if (!isSame(alone->images[k][i], together->images.at(k).at(i))) ++count;
        return count;
    }
};

/// Empty if a picture is missing.
/// @param first     Index of the answer with one thread.
/// @param pictures  How many each of the two renders has.
[[nodiscard]] std::optional<ThreadPictures> threadPicturesAt(const probe::Run& run,
                                                             std::size_t first, int pictures);

}  // namespace ticker::tasks

#endif

#ifndef TICKER_TESTS_TASKS_LENS_ORACLEPICTURES_H
#define TICKER_TESTS_TASKS_LENS_ORACLEPICTURES_H

#include <grader/oracle/Oracle.h>
#include <grader/probe/Question.h>
#include <grader/tasks/lens/checks/PictureCheck.h>

#include <cstdint>

namespace ticker::tasks {

/// The answer of code with this reading of the handout and this mistake, drawn by the oracle.
inline probe::RenderAnswer answerOf(const probe::RenderQuestion& asked, std::uint64_t seed,
                                    const oracle::Mistake& mistake = {},
                                    const oracle::Reading& reading = {}) {
    const oracle::Oracle student{asked.scene, asked.settings, reading, mistake};
    probe::RenderAnswer answer;
    answer.state = probe::AnswerState::answered;
    answer.width = asked.settings.width;
    answer.height = asked.settings.height;
    for (int i = 0; i < asked.repetitions; ++i) {
        const raytracer::Image image =
            student.studentRender(seed * 100 + static_cast<std::uint64_t>(i));
        auto& pixels = answer.images.emplace_back();
        for (int y = 0; y < answer.height; ++y)
            for (int x = 0; x < answer.width; ++x)
                pixels.push_back(image.at(x, y));
    }
    return answer;
}

/// Judges one answer, with expectations that are computed for it alone.
inline PictureVerdict judgePictures(const probe::RenderQuestion& asked,
                                    const probe::RenderAnswer& answer, std::uint64_t seed) {
    Expectations expectations{asked, seed};
    return judgePictures(expectations, answer);
}

}  // namespace ticker::tasks

#endif

#include <grader/base/SplitMix.h>
#include <grader/lab/calibrate/OwnNoise.h>

#include <variant>

namespace ticker::calibrate {

probe::Run OwnNoise::ask(const std::vector<probe::Question>& questions) {
    std::vector<probe::Question> own = questions;
    for (probe::Question& question : own)
        std::visit(
            [this](auto& any) {
                if constexpr (requires { any.settings.seed; }) {
                    std::uint64_t state = any.settings.seed ^ seed_;
                    any.settings.seed = splitMix(state) >> 1U;
                }
            },
            question);
    return examinee_.ask(own);
}

}  // namespace ticker::calibrate

#ifndef TICKER_TESTS_ALTEREDEXAMINEE_H
#define TICKER_TESTS_ALTEREDEXAMINEE_H

#include <grader/probe/Examinee.h>

#include <functional>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks {

/// Passes questions on to another examinee with altered settings, and hides its rays if told to:
/// simulates mistakes of size, count and plane, and code whose rays are not visible, without
/// compiling.
class AlteredExaminee final : public probe::Examinee {
public:
    using Alter = std::function<void(raytracer::RenderSettings&)>;

    /// @param inner  Must outlive this object.
    AlteredExaminee(probe::Examinee& inner, Alter alter, bool hideRays = false)
        : inner_(inner), alter_(std::move(alter)), hideRays_(hideRays) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        std::vector<probe::Question> altered = questions;
        for (probe::Question& question : altered)
            std::visit([this](auto& asked) { change(asked); }, question);
        return inner_.ask(altered);
    }

private:
    // Questions about normals, hits or functions have no settings.
    template <class Asked>
    void change(Asked& asked) const {
        if constexpr (requires { asked.settings; })
            if (alter_) alter_(asked.settings);
        if constexpr (requires { asked.eventCapacity; })
            if (hideRays_) asked.eventCapacity = 0;
    }

    probe::Examinee& inner_;
    Alter alter_;
    bool hideRays_;
};

}  // namespace ticker::tasks

#endif

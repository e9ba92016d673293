#ifndef TICKER_TASKS_BUMP_TILT_H
#define TICKER_TASKS_BUMP_TILT_H

#include <grader/probe/Examinee.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/support/Finite.h>
#include <questions/BumpQuestions.h>

#include <raytracer/math/Vector3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::tasks::bump {

using raytracer::Vector3;

/// One grey step of a picture, as a height.
inline constexpr double kByte = raytracer::kBumpFactor / 255.0;

/// The sphere of a question.
struct Ball {
    Vector3 centre;
    double radius = 1.0;

    [[nodiscard]] Vector3 at(const Vector3& direction) const { return centre + direction * radius; }
};

using raytracer::questions::tiltOf;

/// A map without slope, of height `level`: by default half of the greatest height.
[[nodiscard]] probe::HeightMapDescription flatMap(int width, int height, double level = 2.5);

/// A map of random bytes: neighbours differ at nearly every texel.
[[nodiscard]] probe::HeightMapDescription noiseMap(Draws& draws, int width, int height);

/// A map, and a flat map of its size at the same points.
struct LevelPair {
    std::size_t flat = 0;
    std::size_t map = 0;
};

/// The same points of the same map, in two orders.
struct OrderPair {
    std::size_t forwards = 0;
    std::size_t backwards = 0;
};

/// Collects the questions of one run; a question's number later finds its answer.
class Questionnaire {
public:
    /// @param seed  Source of the spheres' materials and of the other objects in their scenes: a
    ///              submission must not be able to tell a question's sphere from a picture's.
    explicit Questionnaire(std::uint64_t seed = 0) : draws_(seed + 0xFACADEU) {}

    /// Asks for the normals of `ball` at the points that lie in `directions`.
    /// @return  The question's number.
    std::size_t add(const Ball& ball, probe::HeightMapDescription map,
                    const std::vector<Vector3>& directions);

    /// Asks for `map` and for a flat map of its size, at the same points.
    LevelPair addPair(const Ball& ball, probe::HeightMapDescription map,
                      const std::vector<Vector3>& directions);

    OrderPair addInBothOrders(const Ball& ball, const probe::HeightMapDescription& map,
                              const std::vector<Vector3>& directions);

    [[nodiscard]] const std::vector<probe::Question>& questions() const { return questions_; }
    [[nodiscard]] const probe::NormalQuestion& question(std::size_t number) const;

private:
    Draws draws_;
    std::vector<probe::Question> questions_;
};

/// The answers of one run, with their questions.
class Answers {
public:
    Answers(const Questionnaire& asked, probe::Run run);

    [[nodiscard]] const probe::ProcessEnd& end() const { return run_.end; }
    [[nodiscard]] const Questionnaire& asked() const { return *asked_; }
    /// The answer to a question. It has as many normals as were asked for; a missing normal is NaN.
    [[nodiscard]] const probe::NormalAnswer& answer(std::size_t number) const;
    /// For each point the part of the normal across the smooth one, divided by the part along it,
    /// so that it is proportional to the slope. Not finite for a missing normal.
    [[nodiscard]] std::vector<Vector3> tilts(std::size_t number) const;
    /// The tilts less those on a flat map of the same size at the same points: the chords of a
    /// displaced surface lean even on a flat map, by half of their step.
    [[nodiscard]] std::vector<Vector3> tiltsBeyond(std::size_t flat, std::size_t number) const;
    /// Share of the points whose normal depends on the points before it. Right code gives 0.
    [[nodiscard]] double shareThatOrderChanges(const OrderPair& pair) const;

private:
    const Questionnaire* asked_;
    probe::Run run_;
};

}  // namespace ticker::tasks::bump

#endif

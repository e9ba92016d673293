#ifndef TICKER_TASKS_BUMP_PHRASES_H
#define TICKER_TASKS_BUMP_PHRASES_H

#include <grader/tasks/bump/questions/Conduct.h>

#include <raytracer/math/Vector3.h>

#include <string>

namespace ticker::tasks::bump {

/// Message, hint and section of one finding.
struct Words {
    std::string message;
    std::string hint;
    std::string section;
};

/// "13 %", "0.2 %".
[[nodiscard]] std::string percent(double share);
/// What the student's code said, as one short line of printable characters.
[[nodiscard]] std::string quoted(const std::string& text);
/// "12 of 17000 points".
[[nodiscard]] std::string pointsOf(const Offence& offence);
/// The first point and the size of its map.
[[nodiscard]] std::string firstAt(const Offence& offence);
/// A point's place on the sphere, in everyday words.
[[nodiscard]] std::string placeInWords(const raytracer::Vector3& direction);

}  // namespace ticker::tasks::bump

#endif

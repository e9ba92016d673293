#ifndef TICKER_TASKS_BUMP_GROWTHWORDS_H
#define TICKER_TASKS_BUMP_GROWTHWORDS_H

#include <grader/tasks/bump/Examination.h>
#include <grader/tasks/bump/words/Phrases.h>

namespace ticker::tasks::bump {

// Words of bump.wrong for tilts that do not grow with the slope.

/// Steps tilt, even slopes do not.
[[nodiscard]] Words smallSlopesWords();
/// Steep slopes tilt hardly more than gentle ones.
[[nodiscard]] Words growthWords(const Examination& examination);
/// Steep slopes turn the normal past the horizon.
[[nodiscard]] Words horizonWords(const Proportion& proportion);
/// The same slope tilts more, or less, where the map is bright.
[[nodiscard]] Words heightsBentWords(const Proportion& proportion);
/// Edges that fall, or edges that rise, leave hardly any slope.
[[nodiscard]] Words lostStepsWords(const StepBalance& balance);
/// Places where the normal stays smooth on a rough map.
[[nodiscard]] Words untiltedWords(const Untilted& untilted);
/// The gentlest slope turns the normal by 90 degrees.
[[nodiscard]] Words normalMissingWords();

/// Words of bump.longitude-dependent: another strength, or tangents of another parametrisation.
[[nodiscard]] Words longitudeWords(const Examination& examination);

}  // namespace ticker::tasks::bump

#endif

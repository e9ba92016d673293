#ifndef TICKER_TASKS_SCREENSHOT_DIFFERENCERASTER_H
#define TICKER_TASKS_SCREENSHOT_DIFFERENCERASTER_H

#include <grader/tasks/screenshot/ScreenshotWords.h>

namespace ticker::tasks::screenshot {

/// Brightness of the picture minus that of the code's render, at a small size.
[[nodiscard]] Raster differenceOf(const ByteView& reference, const ByteView& picture);

}  // namespace ticker::tasks::screenshot

#endif

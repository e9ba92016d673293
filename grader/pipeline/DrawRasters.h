#ifndef TICKER_PIPELINE_DRAWRASTERS_H
#define TICKER_PIPELINE_DRAWRASTERS_H

#include <grader/result/SubmissionResult.h>

namespace ticker::pipeline {

/// Makes a picture of each raster of the result, in its colours, and puts it among the result's
/// pictures: from here on a raster is a title and a file.
void drawRasters(SubmissionResult& result);

}  // namespace ticker::pipeline

#endif

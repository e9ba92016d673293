#ifndef TICKER_PIPELINE_DRAWRASTERS_H
#define TICKER_PIPELINE_DRAWRASTERS_H

#include <grader/result/SubmissionResult.h>

namespace ticker::pipeline {

/// Draws each raster of the result as a picture in its colours, and adds the files to the result's
/// pictures. The raster keeps its title and the file's name.
void drawRasters(SubmissionResult& result);

}  // namespace ticker::pipeline

#endif

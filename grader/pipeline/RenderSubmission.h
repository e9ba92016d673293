#ifndef TICKER_PIPELINE_RENDERSUBMISSION_H
#define TICKER_PIPELINE_RENDERSUBMISSION_H

#include <grader/intake/Submission.h>
#include <grader/pipeline/Grade.h>

#include <raytracer/base/RenderSettings.h>
#include <raytracer/io/ImageReader.h>
#include <raytracer/scene/SceneDescription.h>

namespace ticker::pipeline {

/// The picture that a submission's code renders in the sandbox. The file of the first task that is
/// seen in the scene (`Task::isSeenIn`) is used; the template's files replace the others.
/// @throws raytracer::InputError with the reason why there is no picture: the file is missing, does
///         not compile, crashed, ran out of time. raytracer::Error if it could not be compiled
///         or run for reasons that are ours.
[[nodiscard]] raytracer::ByteImage renderSubmission(const intake::Submission& submission,
                                                    const Grader& grader,
                                                    const raytracer::SceneDescription& scene,
                                                    const raytracer::RenderSettings& settings);

}  // namespace ticker::pipeline

#endif

#ifndef TICKER_RESULT_FINDINGWORDS_H
#define TICKER_RESULT_FINDINGWORDS_H

#include <array>
#include <string_view>
#include <utility>

namespace ticker {

/// Every finding by its id, with words that go on "14 of 60 ..."; a test holds docs/findings.md
/// against them.
inline constexpr auto kFindingWords = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"bump.not-finite", "gave normals that are no numbers"},
    {"bump.not-unit", "gave normals of another length than 1"},
    {"bump.flat", "showed no bumps at all"},
    {"bump.longitude-dependent", "tilted the same slope differently round the sphere"},
    {"bump.swapped-axes", "swapped the axes of the bumps"},
    {"bump.inverted", "inverted the bumps along both axes"},
    {"bump.inverted-u", "inverted the bumps along u"},
    {"bump.inverted-v", "inverted the bumps along v"},
    {"bump.upside-down", "laid the map upside down"},
    {"bump.wrong", "tilted normals in no known way"},
    {"bump.picture-differs", "rendered another picture than the bumps that were answered"},
    {"bump.mirrored", "laid the map mirrored"},
    {"shadow.hard", "cast hard shadows"},
    {"shadow.too-few-rays", "cast too few shadow rays"},
    {"shadow.fixed-samples", "aimed at the same points everywhere"},
    {"shadow.inverted", "exchanged light and shadow"},
    {"shadow.all-or-nothing", "made shadow all or nothing"},
    {"shadow.ambient-scaled", "shadowed the ambient light, too"},
    {"shadow.specular-unshadowed", "let highlights shine in shadow"},
    {"shadow.diffuse-unshadowed", "let diffuse light into shadow"},
    {"shadow.lights-mixed", "mixed up several lights"},
    {"shadow.beyond-light", "let objects behind a light cast shadows"},
    {"shadow.point-jittered", "moved the lit point instead of the light"},
    {"shadow.direction-offset", "let the light grow with its distance"},
    {"shadow.light-size", "gave the light another size"},
    {"shadow.not-a-ball", "gave the light another shape than a ball"},
    {"shadow.clustered", "crowded the samples in the light"},
    {"shadow.threads-mixed", "let several threads share what a light adds up"},
    {"shadow.not-in-renders", "cast other shadow rays in pictures than when asked"},
    {"shadow.view-from-eye", "took the eye for the viewer of a reflection"},
    {"shadow.unseen-rays", "cast shadow rays that cannot be seen"},
    {"shadow.wrong", "computed light in no known way"},
    {"dof.none", "let every ray start at the eye"},
    {"dof.too-few-rays", "cast too few rays for a pixel"},
    {"dof.shared-samples", "shared lens samples between rays"},
    {"dof.not-averaged", "did not average the rays of a pixel"},
    {"dof.threads-mixed", "let several threads share what a pixel adds up"},
    {"dof.focal-distance", "measured the focal distance along the ray"},
    {"dof.focal-plane", "focused on another plane, or none"},
    {"dof.off-centre", "put the aperture off the eye"},
    {"dof.disc", "gave the aperture another shape than a square"},
    {"dof.aperture-size", "gave the aperture another size"},
    {"dof.reused-pattern", "used one pattern of rays for all pixels"},
    {"dof.picture-differs", "rendered a picture that its answers do not explain"},
    {"dof.unseen-rays", "cast camera rays that cannot be seen"},
    {"dof.wrong", "blurred in no known way"},
    {"screenshot.missing", "handed in no screenshot"},
    {"screenshot.unreadable", "handed in a screenshot that is no PNG"},
    {"screenshot.wrong-size", "handed in a screenshot of another size"},
    {"screenshot.not-this-scene", "handed in a screenshot of something else"},
    {"screenshot.edited", "handed in a screenshot that was altered"},
    {"screenshot.not-from-this-code", "handed in a screenshot that this code did not make"},
    {"screenshot.colours", "handed in a screenshot of slightly other colours"},
    {"screenshot.resaved", "handed in a screenshot that was packed with losses"},
    {"screenshot.unverified", "handed in a screenshot that could not be compared"},
    {"screenshot.is-the-reference", "handed in the reference as a screenshot"},
    {"build.failed", "did not compile"},
    {"build.limit", "took the compiler beyond its limits"},
    {"build.forbidden", "defined what belongs to the framework"},
    {"run.crashed", "crashed"},
    {"run.timed-out", "ran out of time"},
    {"run.memory", "ran out of memory"},
    {"run.output-limit", "wrote more than it may"},
    {"run.forbidden-call", "made a forbidden call"},
    {"run.no-answer", "gave no answer"},
    {"run.exited-early", "ended too early"},
    {"settings.hard-coded", "ignored the settings"},
    {"intake.missing-file", "left a file out"},
    {"intake.ambiguous", "handed in two versions of a file"},
    {"intake.unsafe-archive", "sent an archive that is not safe"},
    {"intake.not-text", "sent a source file that is no text"},
    {"intake.too-large", "sent a file that is too large"},
});

}  // namespace ticker

#endif

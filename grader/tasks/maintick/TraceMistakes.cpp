#include <grader/tasks/maintick/MirrorFindings.h>
#include <grader/tasks/maintick/TraceModel.h>

namespace ticker::tasks::maintick {
namespace {

using At = MirrorColours;
using V = Vector3;

constexpr TraceMistake kTraceMistakes[] = {
    {&kMirrorBackground, {.background = {}, .mirroredBackground = {}}},
    {&kMirrorBackground, {.mirroredBackground = {}}},
    {&kMirrorBackground,
     {.isDirectWhereNothingIsSeen = true},
     "A mirrored ray that meets nothing shows the background: blend with it as well."},
    {&kMirrorDirection,
     {.mirrored = [](const V& D, const V& N) { return D.reflectIn(N); }},
     "The minus is missing: reflectIn mirrors what points away from the surface, and ray.direction "
     "points at it: (-ray.direction).reflectIn(N)."},
    {&kMirrorDirection,
     {.mirrored = [](const V& D, const V&) { return D; }},
     "The ray goes straight on through the surface: mirror it, (-ray.direction).reflectIn(N)."},
    {&kMirrorDirection,
     {.mirrored = [](const V& D, const V&) { return -D; }},
     "The ray goes back the way it came: mirror it, (-ray.direction).reflectIn(N)."},
    {&kMirrorDirection,
     {.mirrored = [](const V&, const V& N) { return N; }},
     "The ray leaves along the normal: mirror the direction in it, "
     "(-ray.direction).reflectIn(N)."},
    {&kMirrorStart,
     {.startsAtOrigin = true},
     "The mirrored ray starts where the first one did: start it at P + N * kShadowBias."},
    {&kMirrorStart,
     {.bias = -1e-4},
     "The mirrored ray starts below the surface: P + N * kShadowBias, not minus."},
    {&kMirrorEndless, {.spent = 0}},
    {&kMirrorBounces,
     {.last = 1},
     "One bounce too few is followed: the recursion ends at bouncesLeft == 0, not at 1, and each "
     "call hands on bouncesLeft - 1."},
    {&kMirrorBounces,
     {.last = -1},
     "One bounce too many is followed: the recursion ends at bouncesLeft == 0."},
    {&kMirrorBounces,
     {.most = 0},
     "Mirrors in mirrors show nothing: follow the mirrored ray with trace itself, with bouncesLeft "
     "- 1."},
    {&kMirrorBounces,
     {.spent = 2},
     "Each mirror spends one bounce: hand bouncesLeft - 1 on to trace."},
    {&kMirrorBlend,
     {.blend = [](const At& at) { return at.own + at.seen; }},
     "Both colours are added whole: direct * (1 - rho) + reflected * rho, with rho = "
     "object.reflectivity()."},
    {&kMirrorBlend,
     {.blend = [](const At& at) { return at.own * at.share + at.seen * (1.0 - at.share); }},
     "The shares are exchanged: rho belongs to the reflected colour, 1 - rho to the direct one."},
    {&kMirrorBlend,
     {.blend = [](const At& at) { return at.own + at.seen * at.share; }},
     "The direct colour counts whole: multiply it by 1 - rho."},
    {&kMirrorBlend,
     {.blend = [](const At& at) { return at.own * (1.0 - at.share) + at.seen; }},
     "The reflected colour counts whole: multiply it by rho."},
    {&kMirrorBlend,
     {.blend = [](const At& at) { return at.seen * at.share; }},
     "The direct colour is lost: add direct * (1 - rho)."},
    {&kMirrorBlend, {.blend = [](const At& at) { return at.seen; }}},
    {&kMirrorBlend, {.blend = [](const At& at) { return (at.own + at.seen) * 0.5; }}},
    {&kMirrorBlend,
     {.blend =
          [](const At& at) { return at.own * (1.0 - at.share) + at.seen * at.tint * at.share; }},
     "A mirror does not tint what it shows: leave object.colour() out."},
    {&kMirrorBase,
     {.endsDark = true},
     "Where no bounce is left the direct colour counts whole: return it before it is multiplied by "
     "1 - rho."},
    {&kMirrorNone,
     {.weakest = 0.1},
     "Weak mirrors are left out: return the direct light alone only where rho is 0."},
    {&kMirrorBlend,
     {.blend =
          [](const At& at) {
              return at.own * (1.0 - at.share) + at.seen * (at.share / at.before);
          }},
     "From the second mirror on the shares of those before it are lost. In a loop the weight is "
     "multiplied: weight *= rho."},
};

constexpr TraceMistake kNoMirrors{&kMirrorNone, {.last = 1000}};

}  // namespace

const TraceMistake& noMirrors() {
    return kNoMirrors;
}

std::span<const TraceMistake> traceMistakes() {
    return kTraceMistakes;
}

}  // namespace ticker::tasks::maintick

// One source for all instruction sets: Highway compiles this file once for each of them and picks
// the best one at run time.
#include <grader/oracle/kernel/Kernel.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "grader/oracle/kernel/Kernel.cpp"
#include <hwy/foreach_target.h>

#include <grader/oracle/kernel/Paths-inl.h>
#include <grader/oracle/kernel/Sums-inl.h>

#include <hwy/highway.h>

#if HWY_ONCE
#include <hwy/targets.h>
#endif

HWY_BEFORE_NAMESPACE();
namespace ticker::oracle::HWY_NAMESPACE {

void tracePathsHere(const Setup& setup, Drawing drawing, Workspace& work, LaneSeeds& seeds) {
    const bool lattice = drawing == Drawing::paired && setup.tricks.lowDiscrepancy;
    if (drawing == Drawing::student) {
        LaneGenerator generator{seeds};
        StudentLens lens{setup, generator, seeds};
        PoolAims aims{setup, generator};
        traceAll(setup, drawing, lens, aims, work);
    } else {
        const PathNumbers numbers{work, lattice};
        NumberedLens lens{setup, numbers};
        NumberedAims aims{setup, numbers, drawing == Drawing::paired};
        traceAll(setup, drawing, lens, aims, work);
    }
}

const char* instructionSetHere() {
    return hwy::TargetName(HWY_TARGET);
}

}  // namespace ticker::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ticker::oracle {

HWY_EXPORT(tracePathsHere);
HWY_EXPORT(coloursHere);
HWY_EXPORT(sumsHere);
HWY_EXPORT(instructionSetHere);

void tracePaths(const Setup& setup, Drawing drawing, Workspace& work, LaneSeeds& seeds) {
    HWY_DYNAMIC_DISPATCH(tracePathsHere)(setup, drawing, work, seeds);
}

std::array<double, 3> sumColours(const Workspace& work, std::size_t first, std::size_t end) {
    return HWY_DYNAMIC_DISPATCH(coloursHere)(work, first, end);
}

PathSums sumPaths(const Workspace& work, std::size_t first, std::size_t end, bool paired) {
    return HWY_DYNAMIC_DISPATCH(sumsHere)(work, first, end, paired);
}

const char* instructionSet() {
    return HWY_DYNAMIC_DISPATCH(instructionSetHere)();
}

}  // namespace ticker::oracle
#endif

#include <grader/repair/Workbench.h>

#include <grader/build/Build.h>

#include <utility>

namespace ticker::repair {

Bench* Workbench::bench(Reach reach) {
    Place& place = reach == Reach::simple ? simple_ : wide_;
    if (!place.wasTried && !clock_.isStepOver()) {
        place.wasTried = true;
        if (auto bench = made(reach)) place.bench.emplace(*std::move(bench));
    }
    return place.bench ? &*place.bench : nullptr;
}

std::optional<Bench> Workbench::made(Reach reach) const {
    const sandbox::Limits limits = clock_.cut(grader_.policy.compile);
    const Wanted wanted{reach, leftAlone_, grader_.exercise->formulasOf(file_, leftAlone_)};
    Candidates candidates =
        findCandidates(grader_.kit, grader_.sandbox, limits, file_, source_, wanted);
    clock_.add(Work::parse, candidates.cpuMs);
    if (candidates.program.empty()) return std::nullopt;
    build::BuildResult built =
        build::buildProgram(grader_.kit, grader_.sandbox, clock_.cut(grader_.policy.compile), file_,
                            candidates.program, build::Purpose::switched);
    clock_.add(Work::compile, built.cpuMs);
    if (!built.program) return std::nullopt;
    const bool keepsState = candidates.keepsState;
    return Bench{
        std::move(candidates),
        {*std::move(built.program), grader_.sandbox, grader_.policy.run, keepsState, clock_}};
}

}  // namespace ticker::repair

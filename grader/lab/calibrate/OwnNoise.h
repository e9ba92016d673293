#ifndef TICKER_CALIBRATE_OWNNOISE_H
#define TICKER_CALIBRATE_OWNNOISE_H

#include <grader/probe/Examinee.h>

#include <cstdint>

namespace ticker::calibrate {

/// A submission that is asked the same scenes as others, with random numbers of its own: the kit's
/// generator is seeded with another number.
class OwnNoise final : public probe::Examinee {
public:
    /// @param examinee  Must outlive this object.
    OwnNoise(probe::Examinee& examinee, std::uint64_t seed) : examinee_(examinee), seed_(seed) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override;

private:
    probe::Examinee& examinee_;
    std::uint64_t seed_;
};

}  // namespace ticker::calibrate

#endif

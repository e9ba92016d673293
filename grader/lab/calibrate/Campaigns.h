#ifndef TICKER_CALIBRATE_CAMPAIGNS_H
#define TICKER_CALIBRATE_CAMPAIGNS_H

#include <grader/lab/calibrate/Campaign.h>
#include <grader/lab/calibrate/Subject.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace ticker::calibrate {

/// All campaigns, in the order of docs/calibration.md.
/// @param data      The data folder, `Home::data`.
/// @param programs  Must outlive the campaigns.
/// @throws raytracer::InputError if the catalogue cannot be read.
[[nodiscard]] std::vector<std::unique_ptr<Campaign>> campaigns(const std::filesystem::path& data,
                                                               Programs& programs);

}  // namespace ticker::calibrate

#endif

#include <grader/lab/calibrate/Campaign.h>

#include <nlohmann/json.hpp>

namespace ticker::calibrate {
namespace {

nlohmann::json withoutCpu(const std::string& found) {
    nlohmann::json object = nlohmann::json::parse(found);
    object.erase("cpu");
    return object;
}

}  // namespace

bool Campaign::agrees(const std::string& before, const std::string& now) const {
    return withoutCpu(before) == withoutCpu(now);
}

}  // namespace ticker::calibrate

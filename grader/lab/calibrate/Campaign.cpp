#include <grader/lab/calibrate/Campaign.h>

#include <nlohmann/json.hpp>

#include <string>

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

double cpuMsOf(const std::string& found) {
    const nlohmann::json object = nlohmann::json::parse(found);
    const auto cpu = object.find("cpu");
    if (cpu == object.end()) return 0.0;
    if (cpu->is_number()) return cpu->get<double>();
    double sum = 0.0;
    for (const auto& [ms, times] : cpu->items())
        sum += std::stod(ms) * times.get<double>();
    return sum;
}

}  // namespace ticker::calibrate

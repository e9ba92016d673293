#include <grader/lab/calibrate/BlockRecord.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace ticker::calibrate {

std::string BlockRecord::json() const {
    nlohmann::json object{{"subject", subject},
                          {"seed", seed},
                          {"task", task},
                          {"decisions", decisions},
                          {"wrongState", wrongState},
                          {"wrongName", wrongName},
                          {"reviews", reviews}};
    if (!seen.empty()) object["seen"] = seen;
    for (const auto& [ms, times] : cpu)
        object["cpu"][std::to_string(ms)] = times;
    return object.dump();
}

BlockRecord BlockRecord::parse(const std::string& text) {
    try {
        const nlohmann::json object = nlohmann::json::parse(text);
        BlockRecord record;
        record.subject = object.at("subject");
        record.seed = object.at("seed");
        record.task = object.at("task");
        record.decisions = object.at("decisions");
        record.wrongState = object.at("wrongState");
        record.wrongName = object.at("wrongName");
        record.reviews = object.at("reviews");
        if (object.contains("seen"))
            record.seen = object["seen"].get<std::map<std::string, std::size_t>>();
        for (const auto& [ms, times] : object.at("cpu").items())
            record.cpu[std::stoi(ms)] = times.get<std::size_t>();
        return record;
    } catch (const nlohmann::json::exception& error) {
        throw raytracer::Error(fmt::format("no record of decisions: {}", error.what()));
    }
}

}  // namespace ticker::calibrate

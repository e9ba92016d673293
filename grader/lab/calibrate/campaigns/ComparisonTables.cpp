#include <grader/lab/calibrate/campaigns/ComparisonTables.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>

namespace ticker::calibrate {
namespace {

using nlohmann::json;

/// A method's distance of a picture from the expectation; larger is worse.
struct Judged {
    std::string subject;
    bool right = true;
    double badness = 0.0;
};

struct Method {
    std::string name;
    std::vector<Judged> judged;
    double limit = 0.0;  // fails every larger distance
    std::string limitText;

    [[nodiscard]] std::vector<Judged> wrongly(bool right) const {
        std::vector<Judged> some;
        std::copy_if(judged.begin(), judged.end(), std::back_inserter(some),
                     [&](const Judged& each) {
                         return each.right == right && (each.badness > limit) == right;
                     });
        return some;
    }
    [[nodiscard]] std::size_t count(bool right) const {
        return static_cast<std::size_t>(std::count_if(
            judged.begin(), judged.end(), [&](const Judged& each) { return each.right == right; }));
    }
    [[nodiscard]] double rate(bool right) const {
        return static_cast<double>(wrongly(right).size()) /
               static_cast<double>(std::max<std::size_t>(1, count(right)));
    }
};

Method methodOf(const std::string& name, const std::vector<json>& records,
                const std::function<double(const json&)>& badness) {
    Method method{name, {}, 0.0, ""};
    for (const json& record : records)
        method.judged.push_back({record.at("subject"), record.at("right"), badness(record)});
    std::sort(method.judged.begin(), method.judged.end(),
              [](const Judged& a, const Judged& b) { return a.badness < b.badness; });
    return method;
}

// The limit with the smallest sum of both rates: no other limit is better.
Method atItsBest(Method method) {
    double best = 3.0;
    double bestLimit = 0.0;
    for (const Judged& each : method.judged) {
        method.limit = each.badness;
        const double sum = method.rate(true) + method.rate(false);
        if (sum >= best) continue;
        best = sum;
        bestLimit = each.badness;
    }
    method.limit = bestLimit;
    return method;
}

// The largest limit that fails no right subject.
Method atNoFalseFail(Method method) {
    method.limit = std::numeric_limits<double>::lowest();
    for (const Judged& each : method.judged)
        if (each.right) method.limit = std::max(method.limit, each.badness);
    return method;
}

std::string examples(const std::vector<Judged>& some, bool worstFirst) {
    constexpr std::size_t kMost = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(kMost, some.size()); ++i)
        text += (i == 0 ? "" : ", ") + some[worstFirst ? some.size() - 1 - i : i].subject;
    return some.size() > kMost ? text + ", ..." : text;
}

std::string line(const Method& method) {
    const auto falseFails = method.wrongly(true);
    const auto misses = method.wrongly(false);
    return fmt::format("| {} | {} | {} of {} ({:.0f} %) | {} of {} ({:.0f} %) | {} | {} |\n",
                       method.name, method.limitText, falseFails.size(), method.count(true),
                       100.0 * method.rate(true), misses.size(), method.count(false),
                       100.0 * method.rate(false), examples(falseFails, true),
                       examples(misses, false));
}

Method limited(Method method, double limit, std::string text) {
    method.limit = limit;
    method.limitText = std::move(text);
    return method;
}

Method told(Method method, const char* what, double sign) {
    method.limitText = fmt::format("{} {:.4g}", what, sign * method.limit);
    return method;
}

}  // namespace

Summary comparisonTables(const std::vector<std::string>& texts) {
    std::vector<json> records;
    for (const std::string& text : texts)
        records.push_back(json::parse(text));
    const Method ours = limited(
        methodOf("this decision", records,
                 [](const json& record) { return record.at("ours").get<bool>() ? 0.0 : 1.0; }),
        0.5, "any failure");
    const Method rmse = methodOf("RMSE of bytes", records, [](const json& record) {
        return record.at("rmse").get<double>();
    });
    const Method ssim = methodOf(
        "SSIM", records, [](const json& record) { return -record.at("ssim").get<double>(); });
    const Method flip = methodOf(
        "FLIP, mean", records, [](const json& record) { return record.at("flip").get<double>(); });
    const Method zTest = methodOf("Mitsuba's z-test", records, [](const json& record) {
        return -record.at("zTest").get<double>();
    });
    Summary summary;
    summary.asExpected = ours.wrongly(true).empty() && ours.wrongly(false).empty();
    summary.text =
        "| method | limit | right ones failed | wrong ones passed | failed wrongly, worst first | "
        "passed wrongly, best first |\n|---|---|---|---|---|---|\n" +
        line(ours) + line(told(atItsBest(rmse), "best:", 1.0)) +
        line(told(atNoFalseFail(rmse), "no false fail:", 1.0)) +
        line(told(atItsBest(ssim), "best:", -1.0)) +
        line(told(atNoFalseFail(ssim), "no false fail:", -1.0)) +
        line(limited(flip, 0.05, "0.05")) + line(told(atItsBest(flip), "best:", 1.0)) +
        line(limited(zTest, -0.9975, "99.75 % of channels")) +
        line(told(atItsBest(zTest), "best:", -1.0));
    return summary;
}

}  // namespace ticker::calibrate

#include <grader/repair/SameAnswers.h>

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <variant>
#include <vector>

namespace ticker::repair {
namespace {

template <class Value>
bool sameValue(const Value& a, const Value& b) {
    static_assert(std::is_trivially_copyable_v<Value>);
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the same bits, a NaN's as well
    return std::memcmp(&a, &b, sizeof(Value)) == 0;
}

template <class Value>
bool sameBytes(const std::vector<Value>& a, const std::vector<Value>& b) {
    return std::ranges::equal(a, b, sameValue<Value>);
}

// Compares field by field: the padding between fields may differ.
bool sameHit(const probe::Hit& a, const probe::Hit& b) {
    return a.isHit == b.isHit && a.object == b.object && sameValue(a.distance, b.distance) &&
           sameValue(a.location, b.location) && sameValue(a.normal, b.normal);
}

struct Same {
    bool operator()(const probe::NormalAnswer& a, const probe::NormalAnswer& b) const {
        return a.exceptions == b.exceptions && sameBytes(a.normals, b.normals);
    }
    bool operator()(const probe::IlluminateAnswer& a, const probe::IlluminateAnswer& b) const {
        return a.exceptions == b.exceptions && sameBytes(a.colours, b.colours) &&
               sameBytes(a.events, b.events);
    }
    bool operator()(const probe::RenderAnswer& a, const probe::RenderAnswer& b) const {
        return a.exceptions == b.exceptions && a.wrongSize == b.wrongSize &&
               std::ranges::equal(a.images, b.images, sameBytes<probe::ColourRGB>) &&
               sameBytes(a.events, b.events);
    }
    bool operator()(const probe::HitAnswer& a, const probe::HitAnswer& b) const {
        return a.exceptions == b.exceptions && std::ranges::equal(a.hits, b.hits, sameHit);
    }
    bool operator()(const probe::CallAnswer& a, const probe::CallAnswer& b) const {
        return a.exceptions == b.exceptions && sameBytes(a.values, b.values);
    }
    template <class A, class B>
    bool operator()(const A& /*a*/, const B& /*b*/) const {
        return false;
    }
};

}  // namespace

bool sameAnswers(const probe::Run& a, const probe::Run& b) {
    return a.end.kind == b.end.kind &&
           std::ranges::equal(a.answers, b.answers, [](const auto& one, const auto& other) {
               return std::visit(Same{}, one, other);
           });
}

}  // namespace ticker::repair

#include <grader/metrics/FlipColour.h>

namespace ticker::metrics {
namespace {

std::array<float, 256> makeLinearOfByte() {
    std::array<float, 256> table{};
    for (std::size_t byte = 0; byte < table.size(); ++byte) {
        const double s = static_cast<double>(byte) / 255.0;
        table[byte] =
            static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
    }
    return table;
}

}  // namespace

const std::array<float, 256>& linearOfByte() {
    static const std::array<float, 256> kTable = makeLinearOfByte();
    return kTable;
}

}  // namespace ticker::metrics

#include <cmath>

namespace toy {

// The share of light that fog leaves after a distance.
double transmittance(double distance) {
    // TASK T9 begin
    return distance > 0.0 ? 1.0 : 1.0;
    // TASK T9 end
}

}  // namespace toy

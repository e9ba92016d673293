#include "Fuzz.h"

#include <stdexcept>

namespace ticker::fuzz {

void require(bool kept, const char* promise) {
    if (!kept) throw std::logic_error(promise);
}

}  // namespace ticker::fuzz

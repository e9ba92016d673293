#ifndef TICKER_TESTS_SUPPORT_FITSSCHEMA_H
#define TICKER_TESTS_SUPPORT_FITSSCHEMA_H

#include <string>

namespace ticker::tests {

/// True where a JSON text fits docs/schema/<name>.schema.json.
[[nodiscard]] bool fitsSchema(const std::string& text, const std::string& name);

}  // namespace ticker::tests

#endif

#ifndef TICKER_CLI_VERSION_H
#define TICKER_CLI_VERSION_H

#include <string>

namespace ticker::cli {

/// "0.1.0 (1a2b3c4d5e)", without the commit where the source text is no checkout.
[[nodiscard]] std::string versionText();

}  // namespace ticker::cli

#endif

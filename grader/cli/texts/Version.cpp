// Compiled anew after each commit, and therefore without the other sources.
#include <grader/cli/texts/Version.h>

namespace ticker::cli {

std::string versionText() {
    const std::string commit = TICKER_COMMIT;
    return TICKER_VERSION + (commit.empty() ? "" : " (" + commit + ")");
}

}  // namespace ticker::cli

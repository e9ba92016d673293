#ifndef TICKER_SESSION_REQUESTS_H
#define TICKER_SESSION_REQUESTS_H

#include <grader/store/Store.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ticker::session {

// The JSON of requests and answers.

[[nodiscard]] nlohmann::json jsonOf(const Decision& decision);
[[nodiscard]] nlohmann::json jsonOf(const ProvenLine& line);
[[nodiscard]] nlohmann::json jsonOf(const store::ResultRow& row);
[[nodiscard]] nlohmann::json jsonOf(const store::SavedComment& comment);

/// Any bytes as valid JSON text.
[[nodiscard]] std::string textOf(const nlohmann::json& value);

/// The decisions of a request, or why one of them cannot be stored.
struct DecisionsRead {
    std::vector<Decision> decisions;
    std::string refusal;  ///< a sentence for the ticker; empty: all can be stored
};

/// {"decisions": [{"submission", "version", "ruling", "comment", "who", "notes", "bulk",
/// "files"}]}, the last three optional; "files" is the digest of the files that the ticker saw.
/// Refused if one of them is malformed or too long.
[[nodiscard]] DecisionsRead readDecisions(const std::string& body);

/// {"finding", "text", "who"}
[[nodiscard]] std::optional<store::SavedComment> readSavedComment(const std::string& body);

/// A member of a request; empty if it is no string, or too long.
[[nodiscard]] std::optional<std::string> readText(const std::string& body, const char* member);

}  // namespace ticker::session

#endif

#ifndef TICKER_SESSION_CLASSVIEW_H
#define TICKER_SESSION_CLASSVIEW_H

#include <grader/store/Store.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ticker::session {

/// The answer to a request.
struct Reply {
    int status = 200;  ///< HTTP status code
    std::string type = "application/json";
    std::string body;
};

/// The class behind the session's page. All decisions of the session are stored through it.
/// Threads may share it. It uses the status codes of HTTP, and nothing else of it.
class ClassView {
public:
    /// @throws raytracer::InputError if ticker grade did not write `out`.
    explicit ClassView(std::filesystem::path out);

    /// All submissions by name, with verdict, findings and decision; the saved comments; and
    /// `state`, a digest of all of it. A submission whose folder was removed is left out. Every
    /// open page sends this request each second.
    /// @param known  The digest that the page has. If it is still valid, the answer contains only
    ///               the digest.
    [[nodiscard]] Reply list(const std::string& known = {}) const;

    /// One submission as HTML, the digest of its files, and all decisions about it. 404: no
    /// submission has this name, or its result cannot be read; 503: it has no result.json, since it
    /// is being graded at this moment, or since a grading was interrupted. {"error"} says which.
    [[nodiscard]] Reply submission(const std::string& name) const;

    /// A file of a submission's images/. 404 for anything else.
    [[nodiscard]] Reply image(const std::string& name, const std::string& file) const;

    /// The submission's report.html.
    [[nodiscard]] Reply reportPage(const std::string& name) const;

    /// The class's similar.html, which ticker similar writes.
    [[nodiscard]] Reply similarPage() const;

    /// For a contact sheet: the submitted and the expected pictures of a submission, and its
    /// findings.
    [[nodiscard]] Reply pictures(const std::string& name) const;

    /// Stores decisions in one transaction (see `readDecisions`). Each has the version that the
    /// page saw. 200 once they are on disk, with {"answers": [{"isKept", "decision"}]}: `decision`
    /// is the valid one, which is another ticker's if that was stored first. 400 if one is
    /// malformed or too long, 404 if there is no such submission, with {"error"}: none is stored
    /// then. A request that is sent again, because its answer was lost, is stored once.
    [[nodiscard]] Reply decide(const std::string& body);

    /// Stores a comment that all tickers of the class can insert (see `readSavedComment`).
    [[nodiscard]] Reply saveComment(const std::string& body);
    [[nodiscard]] Reply dropComment(const std::string& body);

    /// Converts {"text"}, Markdown, to {"html"}, as reports show it.
    [[nodiscard]] Reply preview(const std::string& body) const;

    /// The store's message for the user; may be empty.
    [[nodiscard]] const std::string& notice() const { return store_.notice(); }
    /// Number of requests for decisions that were accepted, also of those in which another decision
    /// was stored first.
    [[nodiscard]] std::uint64_t changes() const { return changes_; }
    [[nodiscard]] std::size_t size() const { return rows().size(); }

private:
    [[nodiscard]] std::vector<store::ResultRow> rows() const;

    std::filesystem::path out_;
    store::Store store_;
    std::atomic<std::uint64_t> changes_ = 0;
};

}  // namespace ticker::session

#endif

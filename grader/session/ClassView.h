#ifndef TICKER_SESSION_CLASSVIEW_H
#define TICKER_SESSION_CLASSVIEW_H

#include <grader/store/Store.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace ticker::session {

/// What a request gets back.
struct Reply {
    int status = 200;  ///< as HTTP has it
    std::string type = "application/json";
    std::string body;
};

/// A class as the ticking session shows it, and the one way to decide in it. May be shared by
/// threads. Knows nothing of HTTP but the statuses.
class ClassView {
public:
    /// @throws raytracer::InputError where `out` is no OUT of ticker grade.
    explicit ClassView(std::filesystem::path out);

    /// All submissions with verdict, findings and decision, by name, the saved comments, and a
    /// state. Every page asks for it each second, and mostly nothing has changed.
    /// @param known  The state that the page has; where it still holds, the answer is that alone.
    [[nodiscard]] Reply list(const std::string& known = {}) const;

    /// One submission as HTML, and all decisions about it. 404: nobody of this name; 503: it is
    /// being graded at this moment.
    [[nodiscard]] Reply submission(const std::string& name) const;

    /// A file of a submission's images/. 404 for anything else.
    [[nodiscard]] Reply image(const std::string& name, const std::string& file) const;

    /// The submission's report.html.
    [[nodiscard]] Reply reportPage(const std::string& name) const;

    /// For a contact sheet: the renders of a submission beside what was expected, and what was
    /// found.
    [[nodiscard]] Reply pictures(const std::string& name) const;

    /// Keeps decisions, all at once (see `readDecisions`), each with the version that the page saw.
    /// 200 once they are on disk, with {"answers": [{"isKept", "decision"}]}: the decision that
    /// stands now, which is another one's where one was made meanwhile. 400 where one is none. Sent
    /// again after a lost answer, each is kept once.
    [[nodiscard]] Reply decide(const std::string& body);

    /// Words for students that all tickers of the class are offered (see `readSavedComment`).
    [[nodiscard]] Reply saveComment(const std::string& body);
    [[nodiscard]] Reply dropComment(const std::string& body);

    /// {"text"} as the student will see it: {"html"}.
    [[nodiscard]] Reply preview(const std::string& body) const;

    /// What a notice should tell the user of the store; may be empty.
    [[nodiscard]] const std::string& notice() const { return store_.notice(); }
    /// Grows with each request that stored decisions.
    [[nodiscard]] std::uint64_t changes() const { return changes_; }
    [[nodiscard]] std::size_t size() const { return store_.results().size(); }

private:
    std::filesystem::path out_;
    store::Store store_;
    std::atomic<std::uint64_t> changes_ = 0;
};

}  // namespace ticker::session

#endif

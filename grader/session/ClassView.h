#ifndef TICKER_SESSION_CLASSVIEW_H
#define TICKER_SESSION_CLASSVIEW_H

#include <grader/store/Store.h>

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

    /// All submissions with verdict, findings and decision, by name.
    [[nodiscard]] Reply list() const;

    /// One submission as HTML, and all decisions about it. 404: nobody of this name; 503: it is
    /// being graded at this moment.
    [[nodiscard]] Reply submission(const std::string& name) const;

    /// A file of a submission's images/. 404 for anything else.
    [[nodiscard]] Reply image(const std::string& name, const std::string& file) const;

    /// The submission's report.html.
    [[nodiscard]] Reply reportPage(const std::string& name) const;

    /// Keeps a decision: {"submission", "version", "ruling", "comment", "who"}, version as the page
    /// saw it. 200 with the decision once it is on disk; 409 with the one that somebody made
    /// meanwhile; 400 where it is none. Sent again after a lost answer, it is kept once.
    [[nodiscard]] Reply decide(const std::string& body);

    /// What a notice should tell the user of the store; may be empty.
    [[nodiscard]] const std::string& notice() const { return store_.notice(); }
    [[nodiscard]] std::size_t size() const { return store_.results().size(); }

private:
    std::filesystem::path out_;
    store::Store store_;
};

}  // namespace ticker::session

#endif

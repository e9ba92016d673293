#include <grader/cli/Output.h>
#include <grader/cli/verbs/StudentPages.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/report/ReportWords.h>
#include <grader/session/Server.h>
#include <grader/store/ClassFolder.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <csignal>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace ticker::cli {
namespace {

struct SessionOptions {
    std::string out;
    int port = 0;
    std::string studentView;
};

/// Blocks the signals that end a session, for this thread and its children.
sigset_t blockEnding() {
    sigset_t ending;
    sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        sigaddset(&ending, signal);
    pthread_sigmask(SIG_BLOCK, &ending, nullptr);
    return ending;
}

/// Answers the page's requests in a thread of its own, until the end of this object: also where an
/// error ends the session, which would otherwise wait for that thread for ever.
class Serving {
public:
    explicit Serving(session::Server& server)
        : server_(server), thread_([&server] { server.serve(); }) {}
    ~Serving() { server_.stop(); }
    Serving(const Serving&) = delete;
    Serving& operator=(const Serving&) = delete;

private:
    session::Server& server_;
    std::jthread thread_;
};

/// Writes the class's tables again after new decisions.
class Tables {
public:
    Tables(const session::ClassView& view, std::string out)
        : view_(view), out_(std::move(out)), written_(view.changes()) {}

    /// An error, such as a full disk, is printed once. The next call tries again: it may have gone
    /// by then, and the decisions are in the store.
    void update() {
        const std::uint64_t now = view_.changes();
        if (now == written_) return;
        try {
            writeClass(out_, store::readClass(out_));
            written_ = now;
            printed_.clear();
        } catch (const std::exception& error) {
            if (printed_ == error.what()) return;
            printed_ = error.what();
            fmt::print(stderr,
                       "ticker: {}\nticker: So index.html and summary.csv are not up to date. The "
                       "decisions are kept; the tables are tried again every few seconds.\n",
                       printed_);
        }
    }

private:
    const session::ClassView& view_;
    std::string out_;
    std::uint64_t written_;
    std::string printed_;
};

/// Waits for a signal that ends the session; meanwhile calls `work` every few seconds.
void waitForEnd(const sigset_t& ending, const std::function<void()>& work) {
    constexpr timespec kPause{3, 0};
    while (sigtimedwait(&ending, nullptr, &kPause) < 0)
        work();
}

/// Stores the session's address for the next one. If the last one's is in use, that stays the
/// stored one: browsers may keep decisions which are sent to it alone.
void keepAddress(const session::Server& server, const std::string& out) {
    if (const std::optional<session::Access>& missed = server.missed())
        fmt::print(
            stderr,
            "ticker: The last session's address, {}, is in use, so this session has another. "
            "Decisions that wait in a browser for that one are sent when a session has it "
            "again: --port {}\n",
            session::addressOf(*missed), missed->port);
    else
        session::writeAccess(server.access(), out);
}

raytracer::ExitCode run(const SessionOptions& options, const GlobalOptions& global) {
    if (!store::Store::isIn(options.out))
        throw raytracer::InputError(options.out, 0,
                                    "holds no results.sqlite; expected the OUT of ticker grade");
    const sigset_t ending = blockEnding();
    store::expectResults(options.out, store::Store{options.out});
    session::ClassView view{options.out};
    session::Server server{view, session::readAccess(options.out), options.port};
    keepAddress(server, options.out);
    if (!view.notice().empty()) fmt::print(stderr, "ticker: {}\n", view.notice());
    fmt::print("{}\n", server.address());
    std::fflush(stdout);
    if (!global.quiet)
        fmt::print(stderr,
                   "{}. Open the address in a browser on this machine. It contains the key: "
                   "everyone who has it can decide. Ctrl-C ends the session.\n",
                   report::counted(view.size(), "submission"));
    {
        const Serving serving{server};
        Tables tables{view, options.out};
        waitForEnd(ending, [&] { tables.update(); });
    }
    // The store has the decisions; this updates the tables for readers, and an error decides the
    // exit code.
    const std::vector<store::ClassEntry> entries = store::readClass(options.out);
    writeClass(options.out, entries);
    writeStudentPages(options.out, entries, options.studentView);
    warnOfStale(entries, false);
    return raytracer::ExitCode::success;
}

}  // namespace

Run addSession(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<SessionOptions>();
    CLI::App* verb =
        app.add_subcommand("session", "Decide about the submissions in OUT, in a browser");
    verb->add_option("out", options->out, "Folder that ticker grade wrote")->required();
    verb->add_option("--port", options->port, "Port of 127.0.0.1; the last session's, or any")
        ->check(CLI::Range(1, 65535));
    addStudentView(*verb, options->studentView);
    return [options, &global] { return run(*options, global); };
}

}  // namespace ticker::cli

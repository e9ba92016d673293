#include <grader/session/Listener.h>
#include <grader/session/Server.h>
#include <grader/session/SessionSources.h>

#include <raytracer/base/Error.h>
#include <raytracer/serve/Door.h>

#include <fmt/core.h>
#include <httplib.h>

#include <sys/socket.h>

#include <string_view>
#include <utility>

namespace ticker::session {
namespace {

constexpr const char* kHost = "127.0.0.1";
// A browser keeps several connections open for each tab, and each takes a thread.
constexpr std::size_t kThreads = 32 + kMostNewcomers;
constexpr std::size_t kLargestBody = 256U << 10U;  // model.js stays below it
constexpr int kTooLarge = 413;
constexpr std::size_t kLargestRequest = kLargestBody + (64U << 10U);

// A report runs its own script, which may load this server's pictures and nothing else of it.
constexpr const char* kReportPolicy =
    "sandbox allow-scripts; default-src 'none'; script-src 'unsafe-inline'; "
    "style-src 'unsafe-inline'; img-src 'self' data:; frame-ancestors 'none'";

void answer(httplib::Response& response, const Reply& reply) {
    response.status = reply.status;
    response.set_content(reply.body, reply.type);
}

void answerText(httplib::Response& response, std::string_view text, const char* type) {
    response.set_content(text.data(), text.size(), type);
}

/// Content type of a style sheet or script; null for other files.
const char* typeOf(std::string_view name) {
    if (name.ends_with(".css")) return "text/css; charset=utf-8";
    return name.ends_with(".js") ? "text/javascript; charset=utf-8" : nullptr;
}

void refuse(httplib::Response& response) {
    response.status = 403;
    response.set_content("not here\n", "text/plain");
}

// Such a request is refused only after its body was read; otherwise the body would be read as the
// next request.
bool mayCarryBody(const httplib::Request& request) {
    return request.method == "POST" || request.method == "PUT" || request.method == "PATCH" ||
           request.method == "DELETE";
}

}  // namespace

class Server::Routes {
public:
    Routes(ClassView& view, Access access, int port) : view_(view), access_(std::move(access)) {
        http_.set_payload_max_length(kLargestBody);
        http_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
        // The library's own answer has no words.
        http_.set_error_handler(httplib::Server::HandlerWithResponse{
            [](const httplib::Request& /*request*/, httplib::Response& response) {
                if (response.status != kTooLarge)
                    return httplib::Server::HandlerResponse::Unhandled;
                response.set_content(R"({"error": "The request is too large."})",
                                     "application/json");
                return httplib::Server::HandlerResponse::Handled;
            }});
        http_.set_keep_alive_timeout(kLongestIdle.count());
        http_.set_keep_alive_max_count(kMostRequests);
        http_.set_tcp_nodelay(true);
        // The library's default, SO_REUSEPORT, would let two sessions share a port.
        http_.set_socket_options([](int socket) {
            const int yes = 1;
            setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
        });
        http_.set_pre_routing_handler(
            [this](const httplib::Request& request, httplib::Response& response) {
                if (mayCarryBody(request) || mayEnter(request))
                    return httplib::Server::HandlerResponse::Unhandled;
                refuse(response);
                return httplib::Server::HandlerResponse::Handled;
            });
        addPage();
        addClass();
        bind(port);
    }

    [[nodiscard]] const Access& access() const { return access_; }
    [[nodiscard]] const std::optional<Access>& missed() const { return missed_; }
    void serve() { http_.listen_after_bind(); }
    void stop() { http_.end(); }

private:
    void bind(int wanted) {
        if (wanted > 0 || access_.port > 0) {
            const int port = wanted > 0 ? wanted : access_.port;
            if (http_.bind_to_port(kHost, port)) {
                access_.port = port;
                http_.queueMany();
                return;
            }
            if (wanted > 0)
                throw raytracer::InputError(
                    "", 0, fmt::format("port {} is taken; try another, or none", wanted));
            missed_ = access_;
        }
        access_.port = http_.bind_to_any_port(kHost);
        if (access_.port <= 0) throw raytracer::Error("no port of 127.0.0.1 can be had");
        http_.queueMany();
    }

    [[nodiscard]] bool mayEnter(const httplib::Request& request) const {
        return raytracer::mayEnter(
            {request.method, request.path, request.get_header_value("Host"),
             request.get_header_value("Origin"), request.get_header_value("X-Ticker")},
            access_.token, access_.port);
    }

    [[nodiscard]] std::string at(std::string_view rest) const {
        return fmt::format("/{}/{}", access_.token, rest);
    }

    void get(std::string_view rest, httplib::Server::Handler handler) {
        http_.Get(at(rest), std::move(handler));
    }

    void addPage() {
        http_.set_default_headers(
            {raytracer::kAnswerHeaders.begin(), raytracer::kAnswerHeaders.end()});
        get("", [](const httplib::Request& /*request*/, httplib::Response& response) {
            response.set_header("Content-Security-Policy", raytracer::kPagePolicy);
            answerText(response, pageFiles().at("session.html"), "text/html; charset=utf-8");
        });
        for (const auto& [name, text] : pageFiles())
            if (const char* type = typeOf(name); type != nullptr)
                get(name, [&text = text, type](const httplib::Request& /*request*/,
                                               httplib::Response& response) {
                    answerText(response, text, type);
                });
    }

    void addClass() {
        get("class", [this](const httplib::Request& request, httplib::Response& response) {
            answer(response, view_.list(request.get_param_value("known")));
        });
        get("pictures", [this](const httplib::Request& request, httplib::Response& response) {
            answer(response, view_.pictures(request.get_param_value("name")));
        });
        get("submission", [this](const httplib::Request& request, httplib::Response& response) {
            answer(response, view_.submission(request.get_param_value("name")));
        });
        // A report names its pictures from its own place.
        get("of/([^/]+)/report\\.html",
            [this](const httplib::Request& request, httplib::Response& response) {
                response.set_header("Content-Security-Policy", kReportPolicy);
                answer(response, view_.reportPage(request.matches[1]));
            });
        get("similar", [this](const httplib::Request& /*request*/, httplib::Response& response) {
            response.set_header("Content-Security-Policy", kReportPolicy);
            answer(response, view_.similarPage());
        });
        get("of/([^/]+)/images/([^/]+)",
            [this](const httplib::Request& request, httplib::Response& response) {
                // A report is sandboxed, and so of another origin.
                response.headers.erase("Cross-Origin-Resource-Policy");
                response.set_header("Cross-Origin-Resource-Policy", "cross-origin");
                answer(response, view_.image(request.matches[1], request.matches[2]));
            });
        http_.Post(".*", [this](const httplib::Request& request, httplib::Response& response) {
            if (!mayEnter(request)) return refuse(response);
            if (request.path == at("decide")) return answer(response, view_.decide(request.body));
            if (request.path == at("save-comment"))
                return answer(response, view_.saveComment(request.body));
            if (request.path == at("drop-comment"))
                return answer(response, view_.dropComment(request.body));
            if (request.path == at("preview")) return answer(response, view_.preview(request.body));
            refuse(response);
        });
        const auto never = [](const httplib::Request& /*request*/, httplib::Response& response) {
            refuse(response);
        };
        http_.Put(".*", never);
        http_.Patch(".*", never);
        http_.Delete(".*", never);
    }

    ClassView& view_;
    Access access_;
    std::optional<Access> missed_;
    Listener http_{[this](const httplib::Request& request) { return mayEnter(request); },
                   kLargestRequest};
};

std::string addressOf(const Access& access) {
    return fmt::format("http://{}:{}/{}/", kHost, access.port, access.token);
}

Server::Server(ClassView& view, Access access, int port)
    : routes_(std::make_unique<Routes>(view, std::move(access), port)) {}
Server::~Server() = default;

const Access& Server::access() const {
    return routes_->access();
}
std::string Server::address() const {
    return addressOf(access());
}
const std::optional<Access>& Server::missed() const {
    return routes_->missed();
}
void Server::serve() {
    routes_->serve();
}
void Server::stop() {
    routes_->stop();
}

}  // namespace ticker::session

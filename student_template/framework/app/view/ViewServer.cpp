#include "ViewServer.h"

#include "PageFiles.h"

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>
#include <raytracer/serve/Door.h>

#include <httplib.h>

#include <atomic>
#include <chrono>
#include <map>
#include <string_view>
#include <thread>
#include <utility>

namespace raytracer::view {
namespace {

constexpr const char* kHost = "127.0.0.1";
// Every page waits for news on one of them.
constexpr std::size_t kThreads = 16;
constexpr std::size_t kLargestBody = 16'384;
// Seconds for which a connection may stay open without a request, as a browser opens them in
// advance. The end of the viewer waits for it.
constexpr int kLongestIdle = 1;

// JSON under this name: the library would compress what is called JSON, which takes seconds where a
// whole picture is in it.
constexpr const char* kJson = "application/octet-stream";

void answer(httplib::Response& response, const std::string& body, const char* type) {
    response.set_content(body, type);
}

void refuse(httplib::Response& response, int status, const std::string& words) {
    response.status = status;
    response.set_content(words, "text/plain; charset=utf-8");
}

void answer(httplib::Response& response, const SolutionRunner::Answer& answered, const char* type) {
    if (!answered.isGood) return refuse(response, 409, answered.payload);
    answer(response, answered.payload, type);
}

}  // namespace

class ViewServer::Routes {
public:
    explicit Routes(Studio& studio) : studio_(studio) {
        http_.set_payload_max_length(kLargestBody);
        http_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
        http_.set_tcp_nodelay(true);
        http_.set_keep_alive_timeout(kLongestIdle);
        http_.set_keep_alive_max_count(1);
        http_.set_default_headers({kAnswerHeaders.begin(), kAnswerHeaders.end()});
        http_.set_pre_routing_handler(
            [this](const httplib::Request& request, httplib::Response& response) {
                // A POST is refused after its body was read: what is left of one would be taken
                // for the next request.
                if (request.method == "POST" || isLetIn(request))
                    return httplib::Server::HandlerResponse::Unhandled;
                refuse(response, 403, "not here\n");
                return httplib::Server::HandlerResponse::Handled;
            });
        addPage();
        addQuestions();
        addChanges();
        port_ = http_.bind_to_any_port(kHost);
        if (port_ <= 0) throw Error("no port of 127.0.0.1 can be had");
    }

    [[nodiscard]] std::string address() const {
        return std::string{"http://"} + kHost + ":" + std::to_string(port_) + "/" + token_ + "/";
    }
    void serve() {
        isServing_ = true;
        if (!isStopped_) http_.listen_after_bind();
        isServing_ = false;
    }
    // The library ignores `stop` until it runs.
    void stop() {
        isStopped_ = true;
        while (isServing_ && !http_.is_running())
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        http_.stop();
    }

private:
    [[nodiscard]] bool isLetIn(const httplib::Request& request) const {
        return mayEnter({request.method, request.path, request.get_header_value("Host"),
                         request.get_header_value("Origin"), request.get_header_value("X-Ticker")},
                        token_, port_);
    }

    void get(std::string_view rest, httplib::Server::Handler handler) {
        http_.Get("/" + token_ + "/" + std::string{rest}, std::move(handler));
    }

    void addPage() {
        get("", [](const httplib::Request& /*request*/, httplib::Response& response) {
            response.set_header("Content-Security-Policy", kPagePolicy);
            answer(response, viewHtml(), "text/html; charset=utf-8");
        });
        get("view.css", [](const httplib::Request& /*request*/, httplib::Response& response) {
            answer(response, viewCss(), "text/css; charset=utf-8");
        });
        get("view.js", [](const httplib::Request& /*request*/, httplib::Response& response) {
            answer(response, viewJs(), "text/javascript; charset=utf-8");
        });
    }

    void addQuestions() {
        get("news", [this](const httplib::Request& request, httplib::Response& response) {
            const auto after = parseCount(request.get_param_value("after"));
            answer(response, studio_.board().newsAfter(after.value_or(0)), kJson);
        });
        get("pixel", [this](const httplib::Request& request, httplib::Response& response) {
            answer(response,
                   studio_.pixel(request.get_param_value("x"), request.get_param_value("y")),
                   kJson);
        });
        get("point", [this](const httplib::Request& request, httplib::Response& response) {
            answer(response,
                   studio_.point(request.get_param_value("x"), request.get_param_value("y"),
                                 request.get_param_value("z")),
                   kJson);
        });
        get("pinhole", [this](const httplib::Request& /*request*/, httplib::Response& response) {
            answer(response, studio_.pinhole(), "application/octet-stream");
        });
    }

    void addChanges() {
        http_.Post(".*", [this](const httplib::Request& request, httplib::Response& response) {
            if (!isLetIn(request) || request.path != "/" + token_ + "/settings")
                return refuse(response, 403, "not here\n");
            std::map<std::string, std::string> changes;
            for (const auto& [name, value] : request.params)
                changes[name] = value;
            try {
                studio_.change(changes);
                answer(response, "{}", kJson);
            } catch (const InputError& error) {
                refuse(response, 400, error.what());
            }
        });
    }

    Studio& studio_;
    std::string token_ = freshToken();
    int port_ = 0;
    httplib::Server http_;
    std::atomic<bool> isServing_{false};
    std::atomic<bool> isStopped_{false};
};

ViewServer::ViewServer(Studio& studio) : routes_(std::make_unique<Routes>(studio)) {}
ViewServer::~ViewServer() = default;

std::string ViewServer::address() const {
    return routes_->address();
}
void ViewServer::serve() {
    routes_->serve();
}
void ViewServer::stop() {
    routes_->stop();
}

}  // namespace raytracer::view

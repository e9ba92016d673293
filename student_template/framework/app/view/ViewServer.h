#ifndef RAYTRACER_APP_VIEW_VIEWSERVER_H
#define RAYTRACER_APP_VIEW_VIEWSERVER_H

#include "Studio.h"

#include <memory>
#include <string>

namespace raytracer::view {

/// The viewer's page on 127.0.0.1, for the browser that knows its token (raytracer/serve/Door.h).
class ViewServer {
public:
    explicit ViewServer(Studio& studio);
    ~ViewServer();
    ViewServer(const ViewServer&) = delete;
    ViewServer& operator=(const ViewServer&) = delete;

    /// "http://127.0.0.1:8123/<token>/"
    [[nodiscard]] std::string address() const;
    /// Answers requests until `stop`, which another thread may call, also before this.
    void serve();
    void stop();

private:
    class Routes;
    std::unique_ptr<Routes> routes_;
};

}  // namespace raytracer::view

#endif

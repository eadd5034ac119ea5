#pragma once

#include <memory>
#include <string>

#include "app/serve/web/live_feed.h"

namespace knuckle {

/// Where a WebServer listens, and whom it answers.
struct WebOptions {
    std::string host = "127.0.0.1";
    int port = 8080;    ///< 0: one that is free.
    std::string token;  ///< Every request has to name it; empty: none, on a loopback address only.
};

/// Serves the page of a live scene, its pictures and figures, and takes inputs, on threads of its own:
/// GET / the page, /stream multipart JPEG, /events server-sent JSON; POST /input.
class WebServer {
public:
    /// Most who look at pictures at a time, and who read figures.
    static constexpr int MOST_STREAMS = 16;
    static constexpr size_t MOST_BODY = 64 * 1024;  ///< Of a request [bytes].

    /// Listens from now on. @param page of "/". @param feed must outlive it.
    /// @throws InputError if the port is in use, the address is not this machine's, or it may be reached from others
    /// without a token.
    WebServer(const WebOptions& options, std::string page, LiveFeed& feed);
    /// Ends all connections.
    ~WebServer();
    WebServer(const WebServer&) = delete;
    WebServer& operator=(const WebServer&) = delete;

    int port() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace knuckle

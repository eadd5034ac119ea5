#include "app/serve/web/web_server.h"

#include <fmt/format.h>
#include <httplib.h>

#include <cerrno>
#include <cstring>
#include <thread>
#include <utility>

#include "app/json/json.h"
#include "app/serve/web/access.h"
#include "app/serve/web/bounded_pool.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

using httplib::Request;
using httplib::Response;
using Routing = httplib::Server::HandlerResponse;

constexpr const char* BOUNDARY = "knuckleframe";
/// After which the last frame is sent again: whoever has gone is noticed, and no proxy takes the stream for dead.
constexpr std::chrono::milliseconds AGAIN{1000};
/// The first time something is picked, shaders are compiled.
constexpr std::chrono::seconds LONGEST_ANSWER{20};
constexpr time_t PATIENCE = 2;  // with who neither reads nor writes [s]

void refuse(Response& response, int status, const std::string& why)
{
    response.status = status;
    response.set_content(why + "\n", "text/plain; charset=utf-8");
}

/// A place among the few who are served for long; it is given back when the connection ends.
std::shared_ptr<void> seatAmong(std::atomic<int>& taken, Inbox& inbox)
{
    if (taken.fetch_add(1) >= WebServer::MOST_STREAMS) {
        taken.fetch_sub(1);
        return nullptr;
    }
    inbox.wake();
    return {&taken, [](std::atomic<int>* count) { count->fetch_sub(1); }};
}

bool send(httplib::DataSink& sink, const std::string& bytes)
{
    return sink.write(bytes.data(), bytes.size());
}

/// Sends what is newest as long as somebody reads, first what is newer than `after`.
/// @param write puts it in the format of its stream.
template <typename Write>
void follow(Response& response, const std::string& type, Latest& latest, std::shared_ptr<void> seat, uint64_t after,
            Write write)
{
    auto number = std::make_shared<uint64_t>(after);
    response.set_content_provider(type,
                                  [&latest, seat = std::move(seat), number, write](size_t, httplib::DataSink& sink) {
                                      const Latest::Shown shown = latest.next(*number, AGAIN);
                                      if (latest.isClosed()) return false;
                                      *number = shown.number;
                                      return shown.bytes ? write(sink, *shown.bytes) : sink.is_writable();
                                  });
}

}  // namespace

struct WebServer::Impl {
    Impl(const WebOptions& given, std::string pageText, LiveFeed& feedIn)
        : options(given), page(std::move(pageText)), feed(feedIn)
    {
        if (!isLoopback(options.host) && options.token.empty())
            throw InputError(fmt::format("--host {}: others could reach it, and steer; give a secret by --token as "
                                         "well, or leave it out for this machine alone",
                                         options.host));
        server.new_task_queue = [this] { return pool.release(); };
        server.set_keep_alive_max_count(1);  // a refused body is never taken for the next request
        server.set_read_timeout(PATIENCE);
        server.set_write_timeout(PATIENCE);
        server.set_tcp_nodelay(true);
        server.set_payload_max_length(MOST_BODY);
        server.set_socket_options([](socket_t socket) {
            // The library's own choice lets two programs share a port. And few frames wait for who is slow.
            const int yes = 1, bytes = 256 * 1024;
            setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
            setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &bytes, sizeof bytes);
        });
        server.set_default_headers(
            {{"Cache-Control", "no-store"},
             {"X-Content-Type-Options", "nosniff"},
             {"X-Frame-Options", "DENY"},
             {"Referrer-Policy", "no-referrer"},
             {"Content-Security-Policy", "default-src 'none'; img-src 'self' data:; connect-src 'self'; style-src "
                                         "'unsafe-inline'; script-src 'unsafe-inline'; base-uri 'none'; form-action "
                                         "'none'; frame-ancestors 'none'"}});
        route();
        listen();
    }

    ~Impl()
    {
        feed.frame.close();
        feed.figures.close();
        server.stop();
        thread.join();
    }

    void listen()
    {
        errno = 0;
        port = options.port;
        const bool bound = port == 0 ? (port = server.bind_to_any_port(options.host)) > 0
                                     : server.bind_to_port(options.host, port);
        if (!bound) {
            const int error = errno;
            if (error == EADDRINUSE)
                throw InputError(fmt::format("--port {}: is in use on {}; name another one, or 0 for any that is free",
                                             options.port, options.host));
            throw InputError(fmt::format("--host {} --port {}: cannot listen there: {}; name an address of this "
                                         "machine and a free port",
                                         options.host, options.port,
                                         error != 0 ? std::strerror(error) : "unknown address"));
        }
        thread = std::thread([this] { server.listen_after_bind(); });
    }

    void route()
    {
        server.set_pre_routing_handler([this](const Request& request, Response& response) {
            return admit(request, response) ? Routing::Unhandled : Routing::Handled;
        });
        server.Get("/", [this](const Request&, Response& response) {
            response.set_content(page, "text/html; charset=utf-8");
        });
        server.Get("/stream", [this](const Request&, Response& response) { stream(response); });
        server.Get("/events", [this](const Request&, Response& response) { events(response); });
        server.Post("/input", [this](const Request& request, Response& response, const httplib::ContentReader& reader) {
            static_cast<void>(request);
            std::string body;
            const bool read = reader([&](const char* data, size_t size) {
                body.append(data, size);
                return body.size() <= MOST_BODY;
            });
            if (body.size() > MOST_BODY) refuse(response, 413, "the body is larger than 64 KiB");
            else if (read) take(body, response);
        });
    }

    /// Whether a request is answered at all; else says why not.
    bool admit(const Request& request, Response& response) const
    {
        const std::string host = request.get_header_value("Host");
        // A page of another site whose name leads here would be told by its name.
        if (isLoopback(options.host) && !isLoopback(nameOfHost(host))) {
            refuse(response, 403, "this is not the host that is asked for");
            return false;
        }
        // Of pictures that another site shows browsers name no origin.
        const bool isElsewhere = isOfAnotherSite(request.get_header_value("Sec-Fetch-Site")) && request.path != "/";
        if (isElsewhere || !isOwnOrigin(request.get_header_value("Origin"), host)) {
            refuse(response, 403, "pages of other sites are not answered");
            return false;
        }
        if (!options.token.empty() && !isSameSecret(tokenOf(request), options.token)) {
            refuse(response, 401, "the token is missing or wrong: add ?token=TEXT, or Authorization: Bearer TEXT");
            return false;
        }
        // What is a little too much is read and refused; the library would read whatever is announced.
        const std::string length = request.get_header_value("Content-Length");
        if (length.size() > 6) {
            refuse(response, 413, "the body is larger than 64 KiB");
            return false;
        }
        return true;
    }

    static std::string tokenOf(const Request& request)
    {
        const std::string bearer = request.get_header_value("Authorization");
        constexpr std::string_view WORD = "Bearer ";
        if (bearer.starts_with(WORD)) return bearer.substr(WORD.size());
        return request.get_param_value("token");
    }

    void stream(Response& response)
    {
        auto seat = seatAmong(feed.viewers, feed.inbox);
        if (!seat) return refuse(response, 503, "too many look already");
        // The next part's boundary comes at once: browsers show a frame when they have seen it.
        const auto write = [first = std::make_shared<bool>(true)](httplib::DataSink& sink, const std::string& jpeg) {
            const std::string head = fmt::format("{}Content-Type: image/jpeg\r\nContent-Length: {}\r\n\r\n",
                                                 std::exchange(*first, false) ? fmt::format("--{}\r\n", BOUNDARY) : "",
                                                 jpeg.size());
            return send(sink, head) && send(sink, jpeg) && send(sink, fmt::format("\r\n--{}\r\n", BOUNDARY));
        };
        follow(response, fmt::format("multipart/x-mixed-replace; boundary={}", BOUNDARY), feed.frame, std::move(seat),
               0, write);
    }

    void events(Response& response)
    {
        auto seat = seatAmong(feed.listeners, feed.inbox);
        if (!seat) return refuse(response, 503, "too many listen already");
        // Those of before somebody listened.
        const uint64_t old = feed.figures.next(0, std::chrono::milliseconds(0)).number;
        follow(response, "text/event-stream", feed.figures, std::move(seat), old,
               [](httplib::DataSink& sink, const std::string& json) { return send(sink, "data: " + json + "\n\n"); });
    }

    void take(const std::string& body, Response& response)
    {
        try {
            Input input = parseInput(body);
            std::future<std::string> answer;
            if (input.wantsAnswer()) {
                input.answer = std::make_shared<std::promise<std::string>>();
                answer = input.answer->get_future();
            }
            if (!feed.inbox.put(input)) return refuse(response, 429, "too many inputs a second");
            if (answer.valid() && answer.wait_for(LONGEST_ANSWER) != std::future_status::ready)
                return refuse(response, 503, "the simulation takes too long to answer");
            response.set_content(answer.valid() ? answer.get() + "\n" : "{}\n", "application/json");
        } catch (const InputError& error) {
            refuse(response, 400, error.what());
        }
    }

    WebOptions options;
    std::string page;
    LiveFeed& feed;
    int port = 0;
    /// One thread for each who stays, and some for who comes and goes. Made here, where it may fail: the server, which
    /// takes it as it starts, asks on a thread of its own.
    std::unique_ptr<BoundedPool> pool = std::make_unique<BoundedPool>(2 * MOST_STREAMS + 8);
    httplib::Server server;
    std::thread thread;
};

WebServer::WebServer(const WebOptions& options, std::string page, LiveFeed& feed)
    : impl_(std::make_unique<Impl>(options, std::move(page), feed))
{
}

WebServer::~WebServer() = default;

int WebServer::port() const
{
    return impl_->port;
}

}  // namespace knuckle

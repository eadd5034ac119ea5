#include "tests/report/browser.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "sim/base/base64.h"
#include "tests/report/made_entries.h"

namespace knuckle::test {

namespace {

constexpr int PATIENCE = 30000;  ///< [ms]

[[noreturn]] void startBrowser(const std::string& program, const std::string& profile, int in, int out)
{
    // The protocol's descriptors are 3 and 4; both ends may lie there.
    const int from = fcntl(in, F_DUPFD, 10), to = fcntl(out, F_DUPFD, 10);
    dup2(from, 3);
    dup2(to, 4);
    const int null = open("/dev/null", O_RDWR);
    for (int i = 0; i < 3; ++i) dup2(null, i);
    const std::string folder = "--user-data-dir=" + profile;
    execlp(program.c_str(), program.c_str(), "--headless=new", "--no-sandbox", "--disable-gpu",
           "--disable-dev-shm-usage", "--no-first-run", "--disable-extensions", "--disable-background-networking",
           "--hide-scrollbars", "--force-color-profile=srgb", "--remote-debugging-pipe", folder.c_str(), "about:blank",
           nullptr);
    _exit(126);
}

}  // namespace

std::string Browser::program()
{
    if (const char* named = std::getenv("KNUCKLE_BROWSER")) return named;
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (std::string file = folder + "/chromium"; access(file.c_str(), X_OK) == 0) return file;
    return "";
}

Browser::Browser(int width, int height, bool phone) : phone_(phone)
{
    std::signal(SIGPIPE, SIG_IGN);  // A browser that has ended is an error like others.
    std::array<int, 2> to{}, from{};
    if (pipe2(to.data(), O_CLOEXEC) != 0 || pipe2(from.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    process_ = fork();
    if (process_ == 0) startBrowser(program(), profile_.path(), to[0], from[1]);
    close(to[0]);
    close(from[1]);
    toBrowser_ = to[1];
    fromBrowser_ = from[0];
    const std::string target = call("Target.createTarget", {{"url", "about:blank"}}).at("targetId");
    session_ = call("Target.attachToTarget", {{"targetId", target}, {"flatten", true}}).at("sessionId");
    call("Page.enable");
    call("Emulation.setDeviceMetricsOverride",
         {{"width", width}, {"height", height}, {"deviceScaleFactor", phone ? 2 : 1}, {"mobile", phone}});
    if (phone) call("Emulation.setTouchEmulationEnabled", {{"enabled", true}, {"maxTouchPoints", 5}});
}

Browser::~Browser()
{
    try {
        session_.clear();
        call("Browser.close");
        // It ends when it has written its profile, which is removed afterwards.
        while (true) read();
    } catch (const std::exception&) {
        kill(process_, SIGKILL);
    }
    waitpid(process_, nullptr, 0);
    close(toBrowser_);
    close(fromBrowser_);
}

/// The next message, which ends with a zero.
Json Browser::read()
{
    for (size_t end = unread_.find('\0'); end == std::string::npos; end = unread_.find('\0')) {
        pollfd ready{fromBrowser_, POLLIN, 0};
        std::array<char, 65536> bytes{};
        const ssize_t count = poll(&ready, 1, PATIENCE) == 1 ? ::read(fromBrowser_, bytes.data(), bytes.size()) : 0;
        if (count <= 0) throw std::runtime_error("the browser does not answer");
        unread_.append(bytes.data(), static_cast<size_t>(count));
    }
    const size_t end = unread_.find('\0');
    Json message = Json::parse(unread_.substr(0, end));
    unread_.erase(0, end + 1);
    if (message.value("method", "") == "Page.loadEventFired") loaded_ = true;
    return message;
}

Json Browser::call(const std::string& method, const Json& parameters)
{
    Json request = {{"id", ++calls_}, {"method", method}, {"params", parameters}};
    if (!session_.empty()) request["sessionId"] = session_;
    const std::string text = request.dump();
    // With its zero.
    if (write(toBrowser_, text.c_str(), text.size() + 1) != static_cast<ssize_t>(text.size() + 1))
        throw std::runtime_error("the browser does not listen");
    for (;;) {
        Json answer = read();
        if (answer.value("id", 0) != calls_) continue;
        if (answer.contains("error")) throw std::runtime_error(method + ": " + answer["error"].dump());
        return answer.at("result");
    }
}

void Browser::open(const std::string& file, const std::string& hash)
{
    // By way of another page: of the same one only the hash would change.
    for (const std::string& url : {std::string("about:blank"), "file://" + file + hash}) {
        loaded_ = false;
        call("Page.navigate", {{"url", url}});
        while (!loaded_) read();
    }
}

void Browser::openAddress(const std::string& address)
{
    call("Page.navigate", {{"url", address}});
    if (!waitFor("location.href !== 'about:blank' && document.readyState !== 'loading'"))
        throw std::runtime_error("no page at " + address);
}

void Browser::emulate(const std::string& media, const std::string& value)
{
    call("Emulation.setEmulatedMedia", {{"features", Json::array({{{"name", media}, {"value", value}}})}});
}

void Browser::setScripts(bool run)
{
    call("Emulation.setScriptExecutionDisabled", {{"value", !run}});
}

Json Browser::evaluate(const std::string& expression)
{
    const Json answer = call("Runtime.evaluate",
                             {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
    if (answer.contains("exceptionDetails")) throw std::runtime_error(expression + ": " + answer.dump());
    return answer.at("result").value("value", Json());
}

bool Browser::waitFor(const std::string& expression)
{
    for (int tries = 0; tries < 200; ++tries) {
        if (evaluate(expression) == true) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
}

void Browser::mouse(const std::string& type, double x, double y, const Json& more)
{
    Json parameters = {{"type", type}, {"x", x}, {"y", y}};
    parameters.update(more);
    call("Input.dispatchMouseEvent", parameters);
}

void Browser::touch(const std::string& type, const Json& points)
{
    call("Input.dispatchTouchEvent", {{"type", type}, {"touchPoints", points}});
}

void Browser::click(const std::string& selector)
{
    const Json place = evaluate("(() => { const e = document.querySelector(" + Json(selector).dump() +
                                "); e.scrollIntoView({ block: 'nearest' }); const r = e.getBoundingClientRect();"
                                " return [r.x + r.width / 2, r.y + r.height / 2]; })()");
    const double x = place.at(0), y = place.at(1);
    drag(x, y, x, y);
}

void Browser::drag(double fromX, double fromY, double toX, double toY)
{
    constexpr int STEPS_OF_DRAG = 6;
    const bool moves = fromX != toX || fromY != toY;
    const auto at = [&](int i) {
        const double part = static_cast<double>(i) / STEPS_OF_DRAG;
        return std::pair{fromX + (toX - fromX) * part, fromY + (toY - fromY) * part};
    };
    const auto finger = [](std::pair<double, double> place) {
        return Json::array({Json({{"x", place.first}, {"y", place.second}})});
    };
    const Json button = {{"button", "left"}, {"buttons", 1}, {"clickCount", 1}};
    if (phone_) touch("touchStart", finger(at(0)));
    else mouse("mousePressed", fromX, fromY, button);
    for (int i = 1; moves && i <= STEPS_OF_DRAG; ++i) {
        if (phone_) touch("touchMove", finger(at(i)));
        else mouse("mouseMoved", at(i).first, at(i).second, button);
    }
    if (phone_) touch("touchEnd", Json::array());
    else mouse("mouseReleased", toX, toY, button);
}

void Browser::moveTo(double x, double y)
{
    mouse("mouseMoved", x, y);
}

void Browser::mouseDown(double x, double y, int keys)
{
    mouse("mousePressed", x, y, {{"button", "left"}, {"buttons", 1}, {"clickCount", 1}, {"modifiers", keys}});
}

void Browser::mouseMove(double x, double y, int keys)
{
    mouse("mouseMoved", x, y, {{"button", "left"}, {"buttons", 1}, {"modifiers", keys}});
}

void Browser::mouseUp(double x, double y, int keys)
{
    mouse("mouseReleased", x, y, {{"button", "left"}, {"clickCount", 1}, {"modifiers", keys}});
}

void Browser::doubleClick(double x, double y)
{
    for (const int count : {1, 2})
        for (const char* type : {"mousePressed", "mouseReleased"})
            mouse(type, x, y, {{"button", "left"}, {"clickCount", count}});
}

void Browser::wheel(double x, double y, double delta)
{
    mouse("mouseWheel", x, y, {{"deltaX", 0}, {"deltaY", delta}});
}

void Browser::pinch(double x, double y, double fromDistance, double toDistance)
{
    constexpr int STEPS_OF_PINCH = 8;
    for (int i = 0; i <= STEPS_OF_PINCH; ++i) {
        const double half = (fromDistance + (toDistance - fromDistance) * i / STEPS_OF_PINCH) / 2;
        touch(i == 0 ? "touchStart" : "touchMove",
              Json::array({{{"x", x - half}, {"y", y}, {"id", 1}}, {{"x", x + half}, {"y", y}, {"id", 2}}}));
    }
    touch("touchEnd", Json::array());
}

void Browser::press(const std::string& key)
{
    const Json parameters = {{"key", key}, {"text", key.size() == 1 ? key : ""}};
    for (const char* type : {"keyDown", "keyUp"}) {
        Json event = parameters;
        event["type"] = type;
        call("Input.dispatchKeyEvent", event);
    }
}

void Browser::screenshot(const std::string& name)
{
    const char* folder = std::getenv("KNUCKLE_SCREENSHOTS");
    if (folder == nullptr) return;
    const std::string data = call("Page.captureScreenshot", {{"format", "png"}}).at("data");
    std::ofstream(std::string(folder) + "/" + name + ".png", std::ios::binary) << fromBase64(data);
}

}  // namespace knuckle::test

#pragma once

#include <sys/types.h>

#include <memory>
#include <string>

#include "sim/base/json.h"
#include "tests/temp_folder.h"

namespace knuckle::test {

using Json = nlohmann::json;

/// Headless Chromium with one page, by its DevTools protocol over a pipe.
class Browser {
public:
    /// The program: $KNUCKLE_BROWSER, or chromium of $PATH. Empty: there is none.
    static std::string program();
    /// @throws std::runtime_error if it does not start.
    Browser(int width, int height, bool phone);
    ~Browser();
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;

    /// Loads a file and waits until it is complete. @param file absolute. @param hash with its #, or nothing.
    void open(const std::string& file, const std::string& hash = "");
    /// The same for a page of a server, which may go on to send pictures: waits until its scripts have run.
    void openAddress(const std::string& address);
    void emulate(const std::string& media, const std::string& value);
    void setScripts(bool run);
    /// The value of a JavaScript expression; promises are waited for. @throws std::runtime_error for an exception.
    Json evaluate(const std::string& expression);
    /// Waits until an expression is true. @returns false after ten seconds.
    bool waitFor(const std::string& expression);
    /// Clicks, or touches, the middle of the first element that a selector finds, after scrolling to it.
    void click(const std::string& selector);
    /// Presses, moves in steps and releases.
    void drag(double fromX, double fromY, double toX, double toY);
    void moveTo(double x, double y);
    // The left button, with keys held: CONTROL or none.
    static constexpr int CONTROL = 2;
    void mouseDown(double x, double y, int keys = 0);
    void mouseMove(double x, double y, int keys = 0);
    void mouseUp(double x, double y, int keys = 0);
    void doubleClick(double x, double y);
    void wheel(double x, double y, double delta);
    /// Two fingers move apart around a point.
    void pinch(double x, double y, double fromDistance, double toDistance);
    /// @param key as KeyboardEvent.key.
    void press(const std::string& key);
    /// Writes a PNG file of what is seen into $KNUCKLE_SCREENSHOTS; nothing where that is not set.
    void screenshot(const std::string& name);

private:
    Json call(const std::string& method, const Json& parameters = Json::object());
    Json read();
    void mouse(const std::string& type, double x, double y, const Json& more = Json::object());
    void touch(const std::string& type, const Json& points);

    TempFolder profile_;
    pid_t process_ = -1;
    int toBrowser_ = -1, fromBrowser_ = -1, calls_ = 0;
    bool phone_ = false, loaded_ = false;
    std::string session_, unread_;
};

}  // namespace knuckle::test

#pragma once

#include <memory>
#include <mutex>
#include <vector>

namespace knuckle {

class Session;

/// Sessions of one thread that others let go of: they can only end where they were made, where their context is.
class SessionEnds {
public:
    /// Of a thread that has ended it stays for ever, as nobody has its context.
    void leave(Session* session);
    /// Ends what was left. For this thread alone.
    void end();
    /// The same, for the last time.
    void close();

private:
    std::mutex mutex_;
    std::vector<Session*> left_;
    bool closed_ = false;
};

/// Of this thread; what is left there ends with it.
const std::shared_ptr<SessionEnds>& sessionEnds();
/// Ends what other threads have left to this one.
void endLeftSessions();

/// Python's collector lets go of objects in whichever thread it runs in.
struct EndAtHome {
    void operator()(Session* session) const;
};

using SessionHolder = std::unique_ptr<Session, EndAtHome>;

}  // namespace knuckle

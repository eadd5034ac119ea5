#include "app/python/session_end.h"

#include "app/python/session.h"

namespace knuckle {

namespace {

struct EndsOfThread {
    std::shared_ptr<SessionEnds> ends = std::make_shared<SessionEnds>();

    ~EndsOfThread() { ends->close(); }
};

}  // namespace

void SessionEnds::leave(Session* session)
{
    const std::lock_guard lock(mutex_);
    if (!closed_) left_.push_back(session);
}

void SessionEnds::end()
{
    std::vector<Session*> left;
    {
        const std::lock_guard lock(mutex_);
        left.swap(left_);
    }
    for (const Session* session : left) delete session;
}

void SessionEnds::close()
{
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    end();
}

const std::shared_ptr<SessionEnds>& sessionEnds()
{
    thread_local const EndsOfThread here;
    return here.ends;
}

void endLeftSessions()
{
    sessionEnds()->end();
}

void EndAtHome::operator()(Session* session) const
{
    const std::shared_ptr<SessionEnds> home = session->ends();
    if (home == sessionEnds()) delete session;
    else home->leave(session);
}

}  // namespace knuckle

#include "app/run/interrupt.h"

#include <csignal>

namespace knuckle {

namespace {

volatile std::sig_atomic_t signalled = 0;

void handle(void (*handler)(int), int flags)
{
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

InterruptGuard::InterruptGuard()
{
    signalled = 0;
    handle([](int) { signalled = 1; }, static_cast<int>(SA_RESETHAND | SA_RESTART));
}

InterruptGuard::~InterruptGuard()
{
    handle(SIG_DFL, 0);
}

void InterruptGuard::check() const
{
    if (signalled) throw Interrupted{};
}

}  // namespace knuckle

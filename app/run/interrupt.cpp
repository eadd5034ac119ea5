#include "app/run/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "sim/base/files/leftovers.h"

namespace knuckle {

namespace {

constexpr int EXIT_CODE = 130;
constexpr const char* MESSAGE = "knuckle: stopped; what was finished is kept\n";

std::atomic<bool> graceful = false, signalled = false;

void endAtOnce()
{
    clearLeftovers();
    const ssize_t ignored = write(fileno(stderr), MESSAGE, std::strlen(MESSAGE));
    static_cast<void>(ignored);
    _exit(EXIT_CODE);
}

/// A program that started this one may repeat what reached it and this one together: it queues its signal.
void onSignal(int signal, siginfo_t* facts, void*)
{
    if (signal == SIGALRM || !graceful || (signalled.exchange(true) && facts->si_code != SI_QUEUE)) endAtOnce();
    alarm(InterruptGuard::GRACE_SECONDS);
}

}  // namespace

void endOnSignals()
{
    struct sigaction action = {};
    action.sa_sigaction = onSignal;
    action.sa_flags = SA_RESTART | SA_SIGINFO;
    for (const int signal : {SIGINT, SIGTERM, SIGALRM}) sigaction(signal, &action, nullptr);
    // nohup makes the program ignore it.
    struct sigaction before = {};
    sigaction(SIGHUP, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

InterruptGuard::InterruptGuard()
{
    graceful = true;
}

InterruptGuard::~InterruptGuard()
{
    graceful = false;
}

bool InterruptGuard::isSignalled() const
{
    return signalled;
}

void InterruptGuard::check() const
{
    if (signalled) throw Interrupted{};
}

}  // namespace knuckle

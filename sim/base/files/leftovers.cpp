#include "sim/base/files/leftovers.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>

namespace knuckle {

namespace {

/// A signal handler must not allocate, nor read memory that another thread may free: so these places always exist.
struct Place {
    enum : int { Free, Changing, Used };
    std::atomic<int> state = Free;
    pid_t child = 0;  // 0: a file
    std::array<char, PATH_MAX> file;
};
constexpr int MOST = 256;  // further ones are not noted
std::array<Place, MOST> places;

/// @returns the index of the place passed to `fill`, -1 if all are taken.
template <typename Fill>
int take(Fill fill)
{
    for (int i = 0; i < MOST; ++i) {
        Place& place = places[static_cast<size_t>(i)];
        int expected = Place::Free;
        if (!place.state.compare_exchange_strong(expected, Place::Changing)) continue;
        fill(place);
        place.state = Place::Used;
        return i;
    }
    return -1;
}

}  // namespace

Leftover::Leftover(const std::string& temporaryFile)
{
    if (temporaryFile.size() >= PATH_MAX) return;
    place_ = take([&](Place& place) {
        place.child = 0;
        std::memcpy(place.file.data(), temporaryFile.c_str(), temporaryFile.size() + 1);
    });
}

Leftover::Leftover(pid_t child)
{
    place_ = take([&](Place& place) { place.child = child; });
}

Leftover::~Leftover()
{
    if (place_ >= 0) places[static_cast<size_t>(place_)].state = Place::Free;
}

void clearLeftovers()
{
    // Programs first: one of them may be about to create its file.
    for (const Place& place : places)
        if (place.state == Place::Used && place.child != 0) kill(place.child, SIGKILL);
    for (const Place& place : places)
        if (place.state == Place::Used && place.child == 0) unlink(place.file.data());
}

}  // namespace knuckle

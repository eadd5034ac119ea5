// Transfers of a film between host and device, counted at GL's own functions, whoever calls them.
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <mutex>
#include <set>
#include <thread>

#include "app/film/film_run.h"
#include "shared/counters.h"
#include "tests/places.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

constexpr size_t KIB = 1024;
/// Size of a transfer by a function that the project does not use: if it is ever used, this test fails.
constexpr size_t UNKNOWN = size_t{1} << 40;
constexpr uint64_t FRAMES = 24;
constexpr uint32_t WIDTH = 64, HEIGHT = 36;

enum class Way { Upload, Read, Picture };

struct Transfer {
    const char* function;
    Way way;
    size_t bytes;
    uint64_t frame;  ///< Pictures drawn before, so 0 until the first frame has been drawn.
    std::thread::id thread;
};

std::mutex mutex;  ///< A film may be drawn on a separate thread.
std::vector<Transfer> transfers;
std::atomic<uint64_t> picturesTaken = 0;

void note(const char* function, Way way, size_t bytes)
{
    const std::lock_guard lock(mutex);
    transfers.push_back({function, way, bytes, picturesTaken, std::this_thread::get_id()});
}

/// Calls NOTE with the arguments of each call of the GL function behind libepoxy's pointer FUNCTION.
template <auto FUNCTION, auto NOTE>
struct Watch;

template <typename Result, typename... Arguments, Result (**FUNCTION)(Arguments...), auto NOTE>
struct Watch<FUNCTION, NOTE> {
    explicit Watch(const char* name)
    {
        // Not the value of libepoxy's pointer: until its first call that is a resolver, which would undo the watch.
        real = reinterpret_cast<Result (*)(Arguments...)>(eglGetProcAddress(name));
        *FUNCTION = call;
    }
    ~Watch() { *FUNCTION = real; }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

private:
    static Result call(Arguments... arguments)
    {
        NOTE(arguments...);
        return real(arguments...);
    }
    static inline Result (*real)(Arguments...) = nullptr;
};

void noteBufferData(GLenum, GLsizeiptr bytes, const void* data, GLenum)
{
    if (data != nullptr) note("glBufferData", Way::Upload, static_cast<size_t>(bytes));
}

void noteBufferSubData(GLenum, GLintptr, GLsizeiptr bytes, const void*)
{
    note("glBufferSubData", Way::Upload, static_cast<size_t>(bytes));
}

void noteGetBufferSubData(GLenum, GLintptr, GLsizeiptr bytes, void*)
{
    note("glGetBufferSubData", Way::Read, static_cast<size_t>(bytes));
}

void noteMapBufferRange(GLenum target, GLintptr, GLsizeiptr bytes, GLbitfield access)
{
    const auto size = static_cast<size_t>(bytes);
    if ((access & GL_MAP_WRITE_BIT) != 0) note("glMapBufferRange", Way::Upload, size);
    if ((access & GL_MAP_READ_BIT) != 0)
        note("glMapBufferRange", target == GL_PIXEL_PACK_BUFFER ? Way::Picture : Way::Read, size);
}

void noteReadPixels(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*)
{
    ++picturesTaken;
}

/// Every way of OpenGL 4.3 to move an array that a film could use.
struct Watches {
    Watch<&glBufferData, noteBufferData> bufferData{"glBufferData"};
    Watch<&glBufferSubData, noteBufferSubData> bufferSubData{"glBufferSubData"};
    Watch<&glGetBufferSubData, noteGetBufferSubData> getBufferSubData{"glGetBufferSubData"};
    Watch<&glMapBufferRange, noteMapBufferRange> mapBufferRange{"glMapBufferRange"};
    Watch<&glReadPixels, noteReadPixels> readPixels{"glReadPixels"};
    Watch<&glMapBuffer, [](auto...) { note("glMapBuffer", Way::Upload, UNKNOWN); }> mapBuffer{"glMapBuffer"};
    Watch<&glTexImage2D, [](auto...) { note("glTexImage2D", Way::Upload, UNKNOWN); }> texImage{"glTexImage2D"};
    Watch<&glTexSubImage2D, [](auto...) { note("glTexSubImage2D", Way::Upload, UNKNOWN); }> texSubImage{
        "glTexSubImage2D"};
    Watch<&glGetTexImage, [](auto...) { note("glGetTexImage", Way::Read, UNKNOWN); }> getTexImage{"glGetTexImage"};
};

/// Makes a scene's picture small, and its water if there is much.
std::vector<Override> smaller(const std::string& name)
{
    std::vector<Override> changes = {{"render.width", WIDTH}, {"render.height", HEIGHT}};
    if (name == "wade.json") changes.push_back({"objects.0.size", Json{3.8, 0.072, 1.1}});
    return changes;
}

/// The transfers of the first frames of a scene's film. @returns its last picture.
std::string film(const std::string& name, bool drawAside)
{
    transfers.clear();
    picturesTaken = 0;
    const test::TempFolder folder;
    const Scene scene = loadScene(test::inSource("assets/scenes/" + name), smaller(name));
    FilmOptions options;
    options.outputs = {folder.path("out")};
    options.frames = {1, FRAMES};
    options.drawAside = drawAside;
    CommonOptions common;
    common.device = "software";
    common.quiet = true;
    const Watches watches;
    runFilm(scene, options, common);
    return test::readText(folder.path(fmt::format("out/frame_{:04}.png", FRAMES)));
}

/// The number of threads that moved anything after the first frame.
size_t threadCount()
{
    std::set<std::thread::id> threads;
    for (const Transfer& t : transfers)
        if (t.frame > 0) threads.insert(t.thread);
    return threads.size();
}

size_t countOf(Way way, bool afterFirstFrame)
{
    return static_cast<size_t>(std::count_if(transfers.begin(), transfers.end(), [&](const Transfer& t) {
        return t.way == way && (t.frame > 0) == afterFirstFrame;
    }));
}

class TrafficOf : public testing::TestWithParam<const char*> {
protected:
    static void expectPicturesOnly();
};

void TrafficOf::expectPicturesOnly()
{
    ASSERT_EQ(picturesTaken, FRAMES);
    EXPECT_TRUE(std::any_of(transfers.begin(), transfers.end(), [](const Transfer& t) {
        return t.way == Way::Upload && t.bytes > KIB && t.frame == 0;
    })) << "the watches do not see the world's upload";
    EXPECT_EQ(countOf(Way::Picture, true), FRAMES);
    EXPECT_GT(countOf(Way::Read, true), 0u) << "the watches do not see the counters";
    for (const Transfer& t : transfers) {
        if (t.frame == 0) continue;
        const testing::Message place = testing::Message() << t.function << " after frame " << t.frame;
        switch (t.way) {
            case Way::Upload: ASSERT_LE(t.bytes, KIB) << place; break;
            case Way::Picture: ASSERT_EQ(t.bytes, size_t{4} * WIDTH * HEIGHT) << place; break;
            case Way::Read:
                // Whether fluids have come to rest before the first step; sizes of passes, on a software driver alone.
                if (t.bytes == sizeof(uint32_t)) break;
                // The state's hash, for the frame's label.
                if (t.bytes == sizeof(uint64_t)) break;
                ASSERT_EQ(t.bytes, sizeof(gpu::Counters)) << place;
                break;
        }
    }
}

TEST_P(TrafficOf, AFilmUploadsItsWorldOnceAndReadsBackPicturesOnly)
{
    const std::string here = film(GetParam(), false);
    EXPECT_EQ(threadCount(), 1u);
    expectPicturesOnly();
    const std::string aside = film(GetParam(), true);
    EXPECT_EQ(threadCount(), 2u) << "the other thread's transfers are not seen";
    expectPicturesOnly();
    EXPECT_FALSE(here.empty());
    EXPECT_TRUE(here == aside) << "the pictures differ";
}

// Particles that flow out of emitters exist from the start; blows, touches, drives, catches, moving colliders, bodies'
// shapes, and the surfaces of cloth, ropes and soft bodies need no host.
INSTANTIATE_TEST_SUITE_P(Scenes, TrafficOf,
                         testing::Values("ragdoll.json", "fountain.json", "dance.json", "troupe.json", "wade.json",
                                         "struck.json", "hit.json", "catch.json", "mill.json", "rocker.json",
                                         "drape.json", "jelly.json"),
                         [](const auto& scene) { return std::string(scene.param, strchr(scene.param, '.')); });

}  // namespace
}  // namespace knuckle

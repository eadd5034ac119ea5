#include "app/film/frame_drawing.h"

#include <algorithm>
#include <utility>

#include "app/run/stopwatch.h"

namespace knuckle {

namespace {

using PassTotals = std::vector<std::pair<std::string, KernelTimer::Total>>;

/// Adds what the passes of one view took to those of the others.
void addTotals(const PassTotals& own, PassTotals& all)
{
    for (const auto& [name, total] : own) {
        const auto found = std::ranges::find(all, name, &PassTotals::value_type::first);
        if (found == all.end()) {
            all.emplace_back(name, total);
            continue;
        }
        found->second.milliseconds += total.milliseconds;
        found->second.count += total.count;
    }
}

/// Of all views, for what is copied of a state.
std::vector<RenderSettings> shownBy(const std::vector<FilmView>& views)
{
    std::vector<RenderSettings> pictures;
    for (const FilmView& view : views) pictures.push_back(view.picture);
    return pictures;
}

}  // namespace

DrawingHere::View::View(Gpu& gpu, const World& world, const FilmView& view)
    : camera(view.camera), draws(drawsOf(view.picture)), renderer(gpu, world, view.picture)
{
}

DrawingHere::DrawingHere(Gpu& gpu, const Scene& scene, const std::vector<FilmView>& views, const FrameSinks& sinks,
                         bool timed)
    : gpu_(gpu)
{
    for (const FilmView& view : views) {
        View& own = *views_.emplace_back(std::make_unique<View>(gpu, scene.world, view));
        for (const size_t output : view.outputs) own.sinks.push_back(sinks.at(output).get());
        if (timed) own.renderer.timer().enable(gpu);
    }
}

bool DrawingHere::take(View& own, const ParticleView& view, const Frame& frame)
{
    const auto wants = [&](FrameSink* sink) { return sink->wants(frame.number); };
    if (!frame.drawn || std::ranges::none_of(own.sinks, wants)) {
        own.renderer.look(view, frame.time);
        return false;
    }
    if (frame.draw) own.renderer.expose(view, frame.time, *frame.draw);
    else own.renderer.draw(view, frame.time);
    if (frame.draw && *frame.draw + 1 < own.draws) return false;
    own.unread = frame;
    return true;
}

void DrawingHere::take(const ParticleView& view, const Frame& frame)
{
    const Stopwatch watch(figures_.seconds);
    bool finished = false;
    for (const auto& own : views_) finished = take(*own, view, frame) || finished;
    if (finished) ++figures_.frames;
}

void DrawingHere::fetch()
{
    const auto isUnread = [](const auto& own) { return own->unread.has_value(); };
    if (std::ranges::none_of(views_, isUnread)) return;
    {
        const Stopwatch watch(figures_.seconds);
        figures_.passes.clear();
        for (const auto& own : views_) fetch(*own);
    }
    if (figures_.frames == 1) figures_.firstSeconds = figures_.seconds;
}

void DrawingHere::fetch(View& own)
{
    own.renderer.timer().collect();
    addTotals(own.renderer.timer().totals(), figures_.passes);
    if (!own.unread) return;
    Image image = own.renderer.readImage();
    image.text = std::move(own.unread->labels);
    gpu_.checkErrors();
    for (FrameSink* sink : own.sinks)
        if (sink->wants(own.unread->number)) sink->write(image, own.unread->number);
    own.unread.reset();
}

CameraStates DrawingHere::saveState()
{
    CameraStates states;
    for (const auto& own : views_) states[own->camera] = own->renderer.saveState();
    return states;
}

void DrawingHere::loadState(const CameraStates& states)
{
    for (const auto& own : views_)
        if (const auto state = states.find(own->camera); state != states.end()) own->renderer.loadState(state->second);
}

DrawingThread::DrawingThread(const Gpu& gpu, const Scene& scene, const std::vector<FilmView>& views,
                             const FrameSinks& sinks, bool timed)
    : snapshots_{FrameSnapshot(scene.world, shownBy(views)), FrameSnapshot(scene.world, shownBy(views))},
      thread_(SNAPSHOTS, [this] {
          drawing_.reset();
          if (gpu_) gpu_->leave();
      })
{
    gpu_ = Gpu::sharingWith(gpu);
    // Meanwhile the solver's kernels are compiled.
    thread_.push([this, &scene, &views, &sinks, timed] {
        gpu_->enter();
        drawing_ = std::make_unique<DrawingHere>(*gpu_, scene, views, sinks, timed);
    });
}

void DrawingThread::take(const ParticleView& view, const Frame& frame)
{
    thread_.waitForRoom();
    FrameSnapshot& snapshot = snapshots_[next_];
    next_ = (next_ + 1) % SNAPSHOTS;
    snapshot.take(view);
    thread_.push([this, &snapshot, frame] {
        drawing_->take(snapshot.begin(), frame);
        snapshot.end();
        drawing_->fetch();
    });
}

CameraStates DrawingThread::saveState()
{
    CameraStates states;
    thread_.push([&] { states = drawing_->saveState(); });
    thread_.drain();
    return states;
}

void DrawingThread::loadState(const CameraStates& states)
{
    thread_.push([&] { drawing_->loadState(states); });
    thread_.drain();
}

}  // namespace knuckle

#include "app/film/frame_drawing.h"

#include <utility>

#include "app/run/stopwatch.h"

namespace knuckle {

DrawingHere::DrawingHere(Gpu& gpu, const Scene& scene, const FrameSinks& sinks, bool timed)
    : gpu_(gpu), sinks_(sinks), draws_(drawsOf(scene.render)), renderer_(gpu, scene.world, scene.render)
{
    if (timed) renderer_.timer().enable(gpu);
}

void DrawingHere::take(const ParticleView& view, const Frame& frame)
{
    if (!frame.drawn) return renderer_.look(view, frame.time);
    const Stopwatch watch(figures_.seconds);
    if (frame.draw) renderer_.expose(view, frame.time, *frame.draw);
    else renderer_.draw(view, frame.time);
    if (frame.draw && *frame.draw + 1 < draws_) return;
    unread_ = frame;
    ++figures_.frames;
}

void DrawingHere::fetch()
{
    if (!unread_) return;
    const Stopwatch watch(figures_.seconds);
    Image image = renderer_.readImage();
    image.text = std::move(unread_->labels);
    renderer_.timer().collect();
    figures_.passes = renderer_.timer().totals();
    gpu_.checkErrors();
    for (const auto& sink : sinks_)
        if (sink->wants(unread_->number)) sink->write(image, unread_->number);
    unread_.reset();
}

DrawingThread::DrawingThread(const Gpu& gpu, const Scene& scene, const FrameSinks& sinks, bool timed)
    : snapshots_{FrameSnapshot(scene.world, scene.render), FrameSnapshot(scene.world, scene.render)},
      thread_(SNAPSHOTS, [this] {
          drawing_.reset();
          gpu_.reset();
      })
{
    thread_.push([&, this] {
        gpu_ = Gpu::sharingWith(gpu);
        drawing_ = std::make_unique<DrawingHere>(*gpu_, scene, sinks, timed);
    });
    thread_.drain();
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

RendererState DrawingThread::saveState()
{
    RendererState state;
    thread_.push([&] { state = drawing_->saveState(); });
    thread_.drain();
    return state;
}

void DrawingThread::loadState(const RendererState& state)
{
    thread_.push([&] { drawing_->loadState(state); });
    thread_.drain();
}

}  // namespace knuckle

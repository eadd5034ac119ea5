#include "app/golden/golden_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>

#include "app/compare/compare_run.h"
#include "app/golden/golden_images.h"
#include "app/golden/golden_scene.h"
#include "app/run/shell_command.h"
#include "app/states/file_checksum.h"
#include "render/compare/parallel.h"
#include "render/reader/picture_file.h"
#include "sim/base/cores.h"
#include "sim/base/errors.h"
#include "sim/base/fnv_hash.h"

namespace knuckle {

namespace {

using Status = ReportEntry::Status;
using Kind = GoldenItem::Kind;

/// Of an entry whose pictures were not compared.
void setDifferent(ReportEntry& entry, const std::string& why)
{
    entry.status = Status::Different;
    entry.verdict = {.equal = false, .reasons = {}};
    entry.line = "different: " + why;
}

/// The path of the file of states, if it is the one that golden.json was written with.
std::string openStates(const Golden& golden, const std::string& key)
{
    constexpr const char* REMEDY = "restore it, or accept what is here now by `knuckle golden update`";
    std::string path = golden.statesFile(key);
    if (std::error_code ignored; !std::filesystem::is_regular_file(path, ignored))
        throw InputError(fmt::format("{}: is not there; {}", path, REMEDY));
    const std::string& recorded = golden.recorded.at(key).file;
    if (!recorded.empty() && fileChecksum(path) != recorded)
        throw InputError(
            fmt::format("{}: is damaged, or not the file that {} was written with; {}", path, GOLDEN_FILE, REMEDY));
    return path;
}

/// Checks the frames of a scene's golden.
class SceneCheck {
public:
    SceneCheck(const Golden& golden, const CheckOptions& options, Gpu& gpu, const InterruptGuard& interrupt)
        : golden_(golden), options_(options), device_(gpu.device()), reference_(chooseReference(golden, device_)),
          record_(golden.recorded.at(reference_.key)), stored_(openStates(golden, reference_.key)),
          scene_(golden, options.changes, gpu, interrupt)
    {
        for (const uint64_t frame : golden.frames)
            if (!options.until || frame <= *options.until) frames_.push_back(frame);
    }

    CheckedGolden run()
    {
        if (options_.states) checkStates();
        if (options_.pictures)
            for (const uint64_t frame : frames_)
                add(Kind::Drawing, frame, [&](GoldenItem& item) { checkPicture(item); });
        return {reference_, std::move(items_)};
    }

private:
    /// Adds an item, with what is wrong in place of what `fill` could not do.
    template <typename Fill>
    void add(Kind kind, uint64_t frame, const Fill& fill)
    {
        GoldenItem item{.kind = kind, .golden = golden_.name, .stem = golden_.frameStem(frame), .frame = frame};
        item.entry.name = fmt::format("{}/{} {}", golden_.name, item.stem, kindWord(kind));
        item.entry.referencePath = golden_.reference(item.stem, reference_.key);
        item.entry.allowed = !reference_.own &&
                             (kind == Kind::Physics ? golden_.statesAdvisory : golden_.picturesAdvisory);
        try {
            fill(item);
        } catch (const InputError& error) {
            item.entry.status = Status::Unreadable;
            item.entry.line = error.what();
        }
        item.entry.line = fmt::format("{}: {}", kindWord(kind), item.entry.line);
        addNotes(item.entry);
        items_.push_back(std::move(item));
    }

    void addNotes(ReportEntry& entry) const
    {
        entry.notes.emplace_back("reference of", record_.device + ", " + record_.driver);
        entry.notes.emplace_back("this run's device", device_.name + ", " + device_.version);
        if (!reference_.own) entry.notes.emplace_back("nearest reference", reference_.key);
        noteRemedy(golden_, entry);
    }

    void checkStates()
    {
        size_t reached = 0;
        try {
            scene_.simulate(frames_, false, [&](const GoldenScene::Simulated& at) {
                checkState(at);
                ++reached;
            });
        } catch (const RunError& error) {
            add(Kind::Physics, frames_[reached],
                [&](GoldenItem& item) { setDifferent(item.entry, fmt::format("the run failed: {}", error.what())); });
        }
    }

    void checkState(const GoldenScene::Simulated& at)
    {
        add(Kind::Physics, at.frame, [&](GoldenItem& item) {
            const auto known = record_.states.find(at.frame);
            if (known == record_.states.end())
                throw InputError(fmt::format("{}: has no state of frame {}; `knuckle golden update` adds it",
                                             golden_.path(), at.frame));
            item.state.emplace();
            const StoredFrame stored = stored_.read(at.frame);
            const ViewState now = at.state.readView();
            // The hash is of particles alone.
            const bool sameParticles = hashText(at.state.stateHash()) == known->second;
            if (sameParticles && sameColliders(stored.view, now)) {
                item.entry.line = "the same bits";
                return;
            }
            item.state = compareStates(scene_.scene().world, stored.view, now, golden_.states);
            item.state->sameParticles = sameParticles;
            const std::string words = differenceWords(*item.state, golden_.states);
            if (item.state->isWithin(golden_.states)) {
                item.entry.line = "within limits: " + words;
                return;
            }
            if (!options_.reports.report.empty() && item.state->sameKind) showStates(item, stored, now);
            setDifferent(item.entry, words);
        });
    }

    /// Both states as pictures, for the report.
    void showStates(GoldenItem& item, const StoredFrame& stored, ViewState now)
    {
        compact(now, scene_.scene());
        judgePictures(item.entry, pictureOf(scene_.draw(stored)), pictureOf(scene_.draw(stored, now)),
                      PictureWork{.settings = settings()}, {.report = options_.reports.report, .reportAll = true});
        item.entry.notes.emplace_back("pictures", "of the stored state and of this run's, both drawn now");
    }

    void checkPicture(GoldenItem& item)
    {
        const StoredFrame stored = stored_.read(item.frame);
        if (const std::string other = scene_.otherWorld(stored.view); !other.empty()) {
            setDifferent(item.entry, other);
            return;
        }
        const Picture reference = readPicture(item.entry.referencePath);
        PictureWork work{.settings = settings()};
        golden_.pictures.applyTo(item.stem, work.settings.threshold, work.limits);
        judgePictures(item.entry, reference, pictureOf(scene_.draw(stored)), work, options_.reports);
    }

    CompareSettings settings() const
    {
        CompareSettings settings = golden_.settings;
        settings.threads = 1;
        return settings;
    }

    const Golden& golden_;
    const CheckOptions& options_;
    const DeviceInfo& device_;
    ChosenReference reference_;
    const GoldenRecord& record_;
    StoredFrames stored_;
    GoldenScene scene_;
    std::vector<uint64_t> frames_;
    std::vector<GoldenItem> items_;
};

/// Contexts that threads use in turn, one at a time each.
class ThreadContexts {
public:
    ThreadContexts(const Gpu& gpu, size_t count)
    {
        while (free_.size() < count) free_.push_back(Gpu::sharingWith(gpu));
    }

    /// One of them, current on this thread for as long as this lives.
    class Use {
    public:
        explicit Use(ThreadContexts& all) : all_(all)
        {
            const std::lock_guard lock(all_.mutex_);
            gpu_ = std::move(all_.free_.back());
            all_.free_.pop_back();
            gpu_->enter();
        }
        ~Use()
        {
            gpu_->leave();
            const std::lock_guard lock(all_.mutex_);
            all_.free_.push_back(std::move(gpu_));
        }
        Use(const Use&) = delete;
        Use& operator=(const Use&) = delete;
        Gpu* gpu() const { return gpu_.get(); }

    private:
        ThreadContexts& all_;
        std::unique_ptr<Gpu> gpu_;
    };

private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Gpu>> free_;
};

}  // namespace

bool CheckedGolden::failed() const
{
    return std::ranges::any_of(items, [](const GoldenItem& item) { return item.entry.failed(); });
}

CheckedGolden checkGolden(const Golden& golden, const CheckOptions& options, Gpu* gpu, const InterruptGuard& interrupt)
{
    try {
        if (!golden.problem.empty()) throw InputError(golden.problem);
        if (!golden.ofScene()) return checkImages(golden, options);
        return SceneCheck(golden, options, *gpu, interrupt).run();
    } catch (const InputError& error) {
        CheckedGolden checked;
        GoldenItem item{.golden = golden.name};
        item.entry.name = golden.name;
        item.entry.status = Status::Unreadable;
        item.entry.line = error.what();
        checked.items.push_back(std::move(item));
        return checked;
    }
}

std::unique_ptr<Gpu> openFor(const std::vector<Golden>& goldens, const CommonOptions& common)
{
    if (std::ranges::none_of(goldens, &Golden::ofScene)) return nullptr;
    // No threads of the driver: each core has a golden of its own.
    return openGpu(common, FrameWork{});
}

void forEachGolden(size_t count, const Gpu* gpu, const std::function<void(size_t, Gpu*)>& act)
{
    const auto threads = static_cast<unsigned>(std::min<size_t>(usableCores(), count));
    if (gpu == nullptr) return forEachParallel(count, threads, [&](size_t i) { act(i, nullptr); });
    ThreadContexts contexts(*gpu, threads);
    forEachParallel(count, threads, [&](size_t i) {
        const ThreadContexts::Use own(contexts);
        act(i, own.gpu());
    });
    gpu->enter();
}

void noteRemedy(const Golden& golden, ReportEntry& entry)
{
    if (entry.status == Status::Equal) return;
    entry.notes.emplace_back("accept by", "knuckle golden update " + quotedForShell(golden.folder));
}

const char* kindWord(GoldenItem::Kind kind)
{
    constexpr std::array<const char*, 3> WORDS{"physics", "drawing", "image"};
    return WORDS.at(static_cast<size_t>(kind));
}

}  // namespace knuckle

#include "app/scene/actors/scene_animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/json/fields.h"
#include "app/scene/scene_repeat.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/rig/clips/body_clip.h"
#include "sim/rig/clips/travel.h"

namespace knuckle {

namespace {

/// Makes the clips of an actor entry, each once for all entries of the same actor.
class ClipReader {
public:
    ClipReader(const ObjectEntry& entry, const Actor& actor)
        : entry_(entry), actor_(actor),
          actorKey_(entry.context.files.actorKey(entry.json, entry.context.builder.diameter()))
    {
    }

    /// @param json with `clip` and `file`. @returns the index of the world's clip.
    uint32_t read(const Json& json, const std::string& where)
    {
        const std::string file = json["file"], name = json["clip"];
        const std::string key = Json{actorKey_, file, name}.dump();
        std::map<std::string, uint32_t>& made = entry_.context.clips;
        if (!made.contains(key)) made[key] = make(file, name, where);
        const BodyClip& clip = entry_.context.builder.world().clips[made[key]];
        if (clip.keyCount() < 2 && where != "/pose")
            entry_.fail(where + "/clip",
                        fmt::format("clip \"{}\" has no length; give another, or take it as `pose`", clip.name));
        return made[key];
    }

private:
    uint32_t make(const std::string& file, const std::string& name, const std::string& where)
    {
        const std::shared_ptr<const Model> source = modelOf(file, where);
        const Model& model = *source;
        const Clip& clip = find(model, name, where);
        try {
            ActorClip fitted = file.empty() ? ownClip(actor_, model, clip)
                                            : foreignClip(actor_, readFigure(model), clip);
            if (std::string note = holdWithinLimits(actor_, fitted.clip); !note.empty())
                fitted.notes.push_back(std::move(note));
            for (std::string& note : fitted.notes)
                entry_.context.notes.push_back(fmt::format("{}{}: {}", entry_.pointer, where, note));
            return entry_.context.builder.addClip(std::move(fitted.clip));
        } catch (const InputError& error) {
            entry_.fail(where + "/file", error.what());
        }
    }

    std::shared_ptr<const Model> modelOf(const std::string& file, const std::string& where)
    {
        const bool own = file.empty();
        SceneFiles& files = entry_.context.files;
        const std::string path = own ? files.existing(entry_.json["file"], entry_.pointer + "/file")
                                     : files.existing(file, entry_.pointer + where + "/file");
        if (endingOf(path) == ".json")
            entry_.fail(where + (own ? "/clip" : "/file"),
                        "an actor file has no clips; give the model that has them as its `file`");
        return own ? files.model(entry_.json, path, true) : files.model({path, {}, {ALL_SKELETONS}}, true);
    }

    const Clip& find(const Model& model, const std::string& name, const std::string& where) const
    {
        const auto unusable = std::ranges::find_if(model.unusableClips, [&](const UnusableClip& clip) {
            return name.empty() ? model.clips.empty() : clip.name == name;
        });
        if (unusable != model.unusableClips.end())
            entry_.fail(where + "/clip", fmt::format("clip \"{}\" {}; export another", unusable->name, unusable->why));
        if (model.clips.empty())
            entry_.fail(where, fmt::format("\"{}\" has no clips; give another `file`", model.name));
        if (name.empty()) return model.clips.front();
        const auto found = std::ranges::find(model.clips, name, &Clip::name);
        if (found != model.clips.end()) return *found;
        std::vector<std::string> known;
        for (const Clip& clip : model.clips) known.push_back(clip.name);
        entry_.fail(where + "/clip", fmt::format("there is no clip \"{}\"; {}", name, suggestion(name, known)));
    }

    const ObjectEntry& entry_;
    const Actor& actor_;
    std::string actorKey_;
};

std::vector<Eigen::Vector2f> pathOf(const Json& json)
{
    std::vector<Eigen::Vector2f> path;
    for (const Json& point : json.value("path", Json::array())) path.emplace_back(point[0], point[2]);
    return path;
}

/// Makes it move as the feet of its clip do, by a clip made for this.
void travel(const ObjectEntry& entry, const Actor& actor, const Json& json, const std::string& where, ClipPlay& play)
{
    WorldBuilder& builder = entry.context.builder;
    const BodyClip& clip = builder.world().clips[play.clip];
    const std::vector<Eigen::Vector2f> path = pathOf(json);
    try {
        TravelClip made = travelOnFeet(actor, clip);
        play.speed = json.contains("speed") ? play.speed / made.speed : 1.0f;
        if (!path.empty()) {
            const auto seconds = static_cast<float>(entry.context.duration) * play.speed;
            made = travelAlong(actor, clip, path, play.start, seconds);
            play.start = 0.0f;
            play.loop = false;
        }
        play.clip = builder.addClip(std::move(made.clip));
    } catch (const InputError& error) {
        entry.fail(where + (path.empty() ? "/root" : "/path"), error.what());
    }
}

ClipPlay readPlay(const ObjectEntry& entry, const Actor& actor, ClipReader& clips, const Json& json,
                  const std::string& where)
{
    ClipPlay play;
    play.clip = clips.read(json, where);
    play.start = json["start"];
    play.speed = json.value("speed", 1.0f);
    play.loop = json["loop"];
    play.inPlace = json["root"] == "inPlace";
    play.at = json.value("at", 0.0f);
    play.fade = json.value("fade", 0.0f);
    if (json["root"] == "travel") travel(entry, actor, json, where, play);
    else if (!pathOf(json).empty())
        entry.fail(where + "/path", "is for \"root\": \"travel\"; give that, or take it away");
    return play;
}

std::vector<ClipPlay> readPlays(const ObjectEntry& entry, const Actor& actor, ClipReader& clips)
{
    const Json& json = entry.json["animation"];
    std::vector<ClipPlay> plays{readPlay(entry, actor, clips, json, "/animation")};
    const Json& then = json["then"];
    for (size_t i = 0; i < then.size(); ++i) {
        const std::string where = fmt::format("/animation/then/{}", i);
        plays.push_back(readPlay(entry, actor, clips, then[i], where));
        if (plays.back().at < plays[i].at) entry.fail(where + "/at", "must not be before that of the entry before");
    }
    return plays;
}

/// A limp actor begins in the pose of a clip at a time.
ClipPlay readPose(const ObjectEntry& entry, ClipReader& clips)
{
    const Json& json = entry.json["pose"];
    ClipPlay play;
    play.clip = clips.read(json, "/pose");
    play.start = json["time"];
    play.loop = false;
    return play;
}

/// Adds the clip in which an actor is caught; if none is named, the last one goes on.
void addCaughtPlay(const ObjectEntry& entry, const Actor& actor, ClipReader& clips, std::vector<ClipPlay>& plays)
{
    const Json& json = entry.json["catch"];
    const float time = json["time"];
    if (time == 0.0f) return;
    if (plays.back().at >= time) entry.fail("/catch/time", "must be behind all changes of clip");
    if (!namesClip(json)) return;
    plays.push_back(readPlay(entry, actor, clips, json, "/catch"));
    plays.back().at = time;
}

}  // namespace

bool namesClip(const Json& clip)
{
    return !clip["clip"].get<std::string>().empty() || !clip["file"].get<std::string>().empty();
}

bool isAnimated(const Json& actor)
{
    return namesClip(actor["animation"]) || namesClip(actor["pose"]);
}

PlayedClips readClips(const ObjectEntry& entry, const Actor& actor)
{
    const bool limp = namesClip(entry.json["pose"]);
    if (limp && namesClip(entry.json["animation"]))
        entry.fail("/pose", "is where a limp actor begins; take it or `animation` away");
    if (!entry.velocity.isZero()) entry.fail("/velocity", "is what the clip says; take it away");
    ClipReader clips(entry, actor);
    std::vector<ClipPlay> plays = limp ? std::vector{readPose(entry, clips)} : readPlays(entry, actor, clips);
    addCaughtPlay(entry, actor, clips, plays);
    std::vector<const BodyClip*> played;
    for (const ClipPlay& play : plays) played.push_back(&entry.context.builder.world().clips[play.clip]);
    return {std::move(plays), needsOf(actor, played)};
}

void animateActors(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects,
                   const std::vector<ClipPlay>& plays)
{
    const bool limp = namesClip(entry.json["pose"]);
    WorldBuilder& builder = entry.context.builder;
    for (size_t copy = 0; copy < objects.size(); ++copy) {
        const float delay = limp ? 0.0f : delayOf(entry.json, copy);
        builder.animate({objects[copy], entry.poses[copy], pivotOf(actor), delayed(builder.world(), plays, delay)});
        const Object& object = builder.world().objects[objects[copy]];
        for (uint32_t b = 0; limp && b < object.bodyCount; ++b) builder.releaseBody(object.bodyStart + b, 0.0f);
    }
}

}  // namespace knuckle

#include "app/serve/change.h"

#include <fmt/format.h>

#include <array>
#include <fstream>

#include "app/scene/names/named.h"
#include "sim/base/errors.h"
#include "sim/base/fnv_hash.h"

namespace knuckle {

namespace {

constexpr const char* FORMAT = "knuckle changes 1";

Json listOf(const Eigen::Vector3f& v)
{
    return {v.x(), v.y(), v.z()};
}

Eigen::Vector3f vectorOf(const Json& json)
{
    const auto list = json.get<std::array<float, 3>>();
    return {list[0], list[1], list[2]};
}

Json jsonOf(uint64_t step, const Change& change)
{
    Json json{{"step", step}};
    switch (change.kind) {
        case ChangeKind::Push:
            json["push"] = change.name;
            json["impulse"] = listOf(change.impulse);
            json["at"] = listOf(change.at);
            break;
        case ChangeKind::Release: json["release"] = change.name; break;
        case ChangeKind::Reset: json["reset"] = true; break;
    }
    return json;
}

Change changeOf(const Json& json)
{
    if (json.contains("reset")) return {.kind = ChangeKind::Reset};
    if (json.contains("release")) return {.kind = ChangeKind::Release, .name = json.at("release").get<std::string>()};
    return {.kind = ChangeKind::Push,
            .name = json.at("push").get<std::string>(),
            .impulse = vectorOf(json.at("impulse")),
            .at = vectorOf(json.at("at"))};
}

/// One line of a log after the first. @returns whether it is the last.
bool readLine(const Json& json, LoggedChanges& logged)
{
    const uint64_t step = json.at("step").get<uint64_t>();
    if (!logged.changes.empty() && step < logged.changes.back().step)
        throw InputError("its step is before that of the line above");
    if (json.contains("end")) {
        logged.steps = step;
        logged.hash = json.at("end").get<std::string>();
        return true;
    }
    const Change change = changeOf(json);
    // The state is that of the start then, whatever came before.
    if (change.kind == ChangeKind::Reset) logged.changes.clear();
    else logged.changes.push_back({step, change});
    return false;
}

}  // namespace

void applyChange(Solver& solver, const World& world, const Change& change)
{
    const std::vector<uint32_t> bodies = bodiesNamed(world, change.name);
    solver.edit([&](StateEdit& edit) {
        if (change.kind == ChangeKind::Release) {
            if (!edit.letGo(withHanging(world, bodies)))
                throw InputError(fmt::format("\"{}\" is held for ever; give it a `release` in the scene", change.name));
            return;
        }
        if (bodies.size() > 1) throw InputError(fmt::format("\"{}\" has several bodies; name one", change.name));
        if (!edit.responds(bodies[0]))
            throw InputError(fmt::format("\"{}\" is held or follows a clip; release it first", change.name));
        edit.push(bodies[0], change.impulse, change.at);
    });
}

ChangeLog::ChangeLog(const std::string& path, const std::string& scene, uint64_t world) : file_(path)
{
    file_.write(Json{{"format", FORMAT}, {"scene", scene}, {"world", hashText(world)}}.dump() + "\n");
}

void ChangeLog::add(uint64_t step, const Change& change)
{
    file_.write(jsonOf(step, change).dump() + "\n");
}

void ChangeLog::finish(uint64_t step, uint64_t stateHash)
{
    file_.write(Json{{"step", step}, {"end", hashText(stateHash)}}.dump() + "\n");
    file_.commit();
}

LoggedChanges readChanges(const std::string& path, uint64_t world)
{
    std::ifstream file(path);
    if (!file) throw InputError(fmt::format("{}: cannot be read; name a file that --log has written", path));
    LoggedChanges logged;
    std::string line;
    bool ended = false;
    for (int number = 1; std::getline(file, line); ++number) {
        const auto fail = [&](const std::string& why) {
            throw InputError(fmt::format("{}:{}: {}", path, number, why));
        };
        try {
            const Json json = parseJson(line, "line");
            if (number == 1) {
                if (json.value("format", "") != FORMAT)
                    fail("is no log of changes; name a file that --log has written");
                if (json.at("world").get<std::string>() != hashText(world))
                    fail(fmt::format("is of another world, of the scene {}; give the same scene and --set",
                                     json.at("scene").get<std::string>()));
            } else ended = readLine(json, logged);
        } catch (const Json::exception& error) {
            fail(fmt::format("cannot be read: {}", error.what()));
        } catch (const InputError& error) {
            if (std::string(error.what()).starts_with(path + ":")) throw;
            fail(error.what());
        }
    }
    if (!ended) throw InputError(fmt::format("{}: has no end; name a file that --log has written to its end", path));
    return logged;
}

}  // namespace knuckle

#include "app/serve/changes/change_log.h"

#include <fmt/format.h>

#include <array>
#include <fstream>

#include "app/json/json.h"
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
        case ChangeKind::Stir:
            json[change.kind == ChangeKind::Push ? "push" : "stir"] = change.name;
            json["impulse"] = listOf(change.impulse);
            json["at"] = listOf(change.at);
            if (change.kind == ChangeKind::Stir) json["radius"] = change.radius;
            break;
        case ChangeKind::Throw:
            json["throw"] = change.name;
            json["at"] = listOf(change.at);
            json["velocity"] = listOf(change.velocity);
            break;
        case ChangeKind::Release: json["release"] = change.name; break;
        case ChangeKind::Set:
            json["set"] = change.name;
            json["value"] = change.value;
            break;
        case ChangeKind::Reset: json["reset"] = true; break;
    }
    return json;
}

Change changeOf(const Json& json)
{
    const auto word = [&](const char* key) { return json.at(key).get<std::string>(); };
    if (json.contains("reset")) return {.kind = ChangeKind::Reset};
    if (json.contains("release")) return {.kind = ChangeKind::Release, .name = word("release")};
    if (json.contains("set"))
        return {.kind = ChangeKind::Set, .name = word("set"), .value = json.at("value").get<std::vector<float>>()};
    if (json.contains("throw"))
        return {.kind = ChangeKind::Throw,
                .name = word("throw"),
                .at = vectorOf(json.at("at")),
                .velocity = vectorOf(json.at("velocity"))};
    const bool stirs = json.contains("stir");
    return {.kind = stirs ? ChangeKind::Stir : ChangeKind::Push,
            .name = word(stirs ? "stir" : "push"),
            .impulse = vectorOf(json.at("impulse")),
            .at = vectorOf(json.at("at")),
            .radius = stirs ? json.at("radius").get<float>() : 0.0f};
}

void readHead(const Json& json, LoggedChanges& logged)
{
    if (json.value("format", "") != FORMAT)
        throw InputError("is no log of changes; name a file that --log has written");
    logged.scene = json.at("scene").get<std::string>();
    logged.world = json.at("world").get<std::string>();
}

/// One line after the first.
void readLine(const Json& json, LoggedChanges& logged)
{
    if (!logged.hash.empty()) throw InputError("comes after the end");
    const uint64_t step = json.at("step").get<uint64_t>();
    if (step < logged.steps) throw InputError("its step is before that of the line above");
    logged.steps = step;
    if (json.contains("end")) {
        logged.hash = json.at("end").get<std::string>();
        return;
    }
    if (json.contains("restart")) {
        logged = {logged.scene, json.at("world").get<std::string>(),
                  json.at("restart").get<std::vector<std::string>>()};
        return;
    }
    const Change change = changeOf(json);
    // The state is that of the start then, whatever came before.
    if (change.kind == ChangeKind::Reset) logged = {logged.scene, logged.world, logged.sets};
    else logged.changes.push_back({step, change});
}

}  // namespace

ChangeLog::ChangeLog(const std::string& path, const std::string& scene, uint64_t world) : file_(path)
{
    file_.write(Json{{"format", FORMAT}, {"scene", scene}, {"world", hashText(world)}}.dump() + "\n");
    file_.appear();
}

void ChangeLog::add(uint64_t step, const Change& change)
{
    file_.write(jsonOf(step, change).dump() + "\n");
}

void ChangeLog::restart(uint64_t step, const std::vector<std::string>& sets, uint64_t world)
{
    file_.write(Json{{"step", step}, {"restart", sets}, {"world", hashText(world)}}.dump() + "\n");
}

void ChangeLog::finish(uint64_t step, uint64_t stateHash)
{
    file_.write(Json{{"step", step}, {"end", hashText(stateHash)}}.dump() + "\n");
    file_.commit();
}

LoggedChanges readChanges(const std::string& path)
{
    std::ifstream file(path);
    if (!file) throw InputError(fmt::format("{}: cannot be read; name a file that --log has written", path));
    LoggedChanges logged;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        // What a killed program could not write to its end.
        if (file.eof() && number > 1) break;
        const auto fail = [&](const std::string& why) {
            throw InputError(fmt::format("{}:{}: {}", path, number, why));
        };
        try {
            const Json json = parseJson(line, "line");
            number == 1 ? readHead(json, logged) : readLine(json, logged);
        } catch (const Json::exception& error) {
            fail(fmt::format("cannot be read: {}", error.what()));
        } catch (const InputError& error) {
            fail(error.what());
        }
    }
    if (logged.world.empty()) throw InputError(fmt::format("{}: is empty; name a file that --log has written", path));
    return logged;
}

}  // namespace knuckle

#include "app/checkpoint/frame_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <span>
#include <utility>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

std::string bodiesBlock(uint64_t frame)
{
    return fmt::format("bodies {}", frame);
}

std::string measuresBlock(uint64_t frame)
{
    return fmt::format("measures {}", frame);
}

std::string densitiesBlock(uint64_t frame)
{
    return fmt::format("densities {}", frame);
}

/// A body's position, rotation xyzw, velocity and angular velocity.
constexpr size_t BODY_FLOATS = 13;

std::string packBodies(uint64_t frame, const std::vector<BodyState>& bodies)
{
    std::vector<float> floats;
    floats.reserve(BODY_FLOATS * bodies.size());
    for (const BodyState& body : bodies) {
        const Quaternionf& q = body.rotation;
        for (int k = 0; k < 3; ++k) floats.push_back(body.position[k]);
        floats.insert(floats.end(), {q.x(), q.y(), q.z(), q.w()});
        for (const Vector3f& vector : {body.velocity, body.angularVelocity})
            for (int k = 0; k < 3; ++k) floats.push_back(vector[k]);
    }
    return packArray(bodiesBlock(frame), std::span<const float>(floats));
}

std::vector<BodyState> unpackBodies(const BlockReader& log, uint64_t frame)
{
    const auto floats = log.readArray<std::array<float, BODY_FLOATS>>(bodiesBlock(frame));
    std::vector<BodyState> bodies;
    for (const auto& f : floats)
        bodies.push_back({.position = {f[0], f[1], f[2]},
                          .rotation = Quaternionf(f[6], f[3], f[4], f[5]),
                          .velocity = {f[7], f[8], f[9]},
                          .angularVelocity = {f[10], f[11], f[12]}});
    return bodies;
}

}  // namespace

FrameLog::FrameLog(std::string path, uint64_t bytes)
    : path_(std::move(path)), file_(open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666)), bytes_(bytes)
{
    if (file_.get() < 0) fail();
    cutTo(bytes_);
    if (bytes_ == 0) add({fileStart()});
}

void FrameLog::cutTo(uint64_t bytes)
{
    if (ftruncate(file_.get(), static_cast<off_t>(bytes)) != 0 ||
        lseek(file_.get(), static_cast<off_t>(bytes), SEEK_SET) < 0)
        fail();
}

void FrameLog::add(const std::vector<std::string>& blocks)
{
    uint64_t end = bytes_;
    for (const std::string& block : blocks) {
        if (const int error = writeAll(file_.get(), block); error != 0) {
            cutTo(bytes_);
            errno = error;
            fail();
        }
        end += block.size();
    }
    bytes_ = end;
}

uint64_t FrameLog::sync()
{
    if (fsync(file_.get()) != 0) fail();
    return bytes_;
}

void FrameLog::fail() const
{
    throw RunError(fmt::format("{} cannot be written: {}", path_, std::strerror(errno)));
}

std::vector<std::string> packRecord(const FrameRecord& record, const ViewCoding& coding)
{
    std::vector<std::string> blocks;
    if (record.view) blocks = coding.pack(record.number, *record.view);
    if (record.state)
        for (std::string& block : packState(*record.state)) blocks.push_back(std::move(block));
    if (record.bodies) blocks.push_back(packBodies(record.number, *record.bodies));
    if (record.measures)
        blocks.push_back(
            packBlock(measuresBlock(record.number), std::as_bytes(std::span(&*record.measures, 1)), BlockKind::Words));
    if (record.densities)
        blocks.push_back(packArray(densitiesBlock(record.number), std::span<const float>(*record.densities)));
    return blocks;
}

FrameRecord unpackRecord(const BlockReader& log, uint64_t frame, const ViewCoding& coding)
{
    FrameRecord record{.number = frame};
    if (log.has(frameBlock(frame, "positions"))) record.view = coding.unpack(log, frame);
    if (hasState(log, frame)) record.state = unpackState(log, frame);
    if (log.has(bodiesBlock(frame))) record.bodies = unpackBodies(log, frame);
    if (log.has(densitiesBlock(frame))) record.densities = log.readArray<float>(densitiesBlock(frame));
    if (log.has(measuresBlock(frame))) {
        const auto measures = log.readArray<Measures>(measuresBlock(frame));
        if (measures.size() == 1) record.measures = measures[0];
    }
    return record;
}

}  // namespace knuckle

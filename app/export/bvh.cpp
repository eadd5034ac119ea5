#include "app/export/bvh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "sim/base/angles.h"
#include "sim/base/errors.h"
#include "sim/rig/bodies/bone_bodies.h"

namespace knuckle {

namespace {

using Eigen::Isometry3f;
using Frames = std::vector<std::vector<Isometry3f>>;

constexpr float CENTIMETRES = 100.0f;   // a metre
constexpr float AWAY = 0.001f;          // distance from its place in the parent [m] beyond which a joint needs a
                                        // position
constexpr float STRAIGHT_UP = 0.9999f;  // sine of the turn about x, above which those about z and y are the same

/// Finds bones that do not stay in their places in their parents.
std::vector<bool> movesApart(const Rig& rig, const Frames& frames)
{
    std::vector<bool> apart(rig.model.bones.size(), false);
    for (size_t b = 0; b < rig.model.bones.size(); ++b) {
        const int32_t parent = rig.model.bones[b].parent;
        for (const auto& frame : frames)
            if (parent < 0 || (frame[b] * boneHead(rig.model, static_cast<uint32_t>(b)) -
                               frame[parent] * boneHead(rig.model, static_cast<uint32_t>(b)))
                                      .norm() > AWAY)
                apart[b] = true;
    }
    return apart;
}

/// Turns about Z, X and Y, R = Rz Rx Ry [degrees]; each as near to the last ones as possible.
Vector3f anglesOf(const Eigen::Matrix3f& r, const Vector3f& last)
{
    const float sine = std::clamp(r(2, 1), -1.0f, 1.0f);
    Vector3f angles;
    if (std::abs(sine) > STRAIGHT_UP) angles = {std::atan2(r(1, 0), r(0, 0)), std::asin(sine), 0.0f};
    else angles = {std::atan2(-r(0, 1), r(1, 1)), std::asin(sine), std::atan2(-r(2, 0), r(2, 2))};
    angles *= 180.0f / HALF_TURN;
    // The same rotation, turned the other way about x.
    const Vector3f other(angles[0] + 180.0f, 180.0f - angles[1], angles[2] + 180.0f);
    const auto near = [&](const Vector3f& a) {
        return Vector3f(a.array() - 360.0f * ((a - last).array() / 360.0f).round());
    };
    const Vector3f first = near(angles), second = near(other);
    return (second - last).norm() < (first - last).norm() ? second : first;
}

class BvhText {
public:
    BvhText(const Rig& rig, const Frames& frames) : rig_(rig), frames_(frames), apart_(movesApart(rig, frames)) {}

    std::string text(double framesPerSecond)
    {
        text_ = "HIERARCHY\n";
        // A file has one hierarchy, so bones without a parent hang on the root.
        for (size_t b = 0; b < rig_.model.bones.size(); ++b)
            if (parentOf(b) < 0) writeJoint(b, 0);
        text_ += fmt::format("MOTION\nFrames: {}\nFrame Time: {:.9g}\n", frames_.size(), 1.0 / framesPerSecond);
        std::vector<Vector3f> last(rig_.model.bones.size(), Vector3f::Zero());
        for (const auto& frame : frames_) writeFrame(frame, last);
        return std::move(text_);
    }

private:
    int32_t parentOf(size_t bone) const
    {
        return bone > 0 && rig_.model.bones[bone].parent < 0 ? 0 : rig_.model.bones[bone].parent;
    }

    Vector3f headOf(size_t bone) const { return boneHead(rig_.model, static_cast<uint32_t>(bone)); }

    Vector3f offsetOf(size_t bone) const
    {
        const int32_t parent = parentOf(bone);
        return headOf(bone) - (parent < 0 ? Vector3f(Vector3f::Zero()) : headOf(static_cast<size_t>(parent)));
    }

    void writeLine(int depth, const std::string& line)
    {
        text_ += std::string(static_cast<size_t>(depth), '\t') + line + "\n";
    }

    void writeOffset(int depth, const Vector3f& offset)
    {
        const Vector3f o = CENTIMETRES * offset;
        writeLine(depth, fmt::format("OFFSET {:.5f} {:.5f} {:.5f}", o.x(), o.y(), o.z()));
    }

    void writeJoint(size_t bone, int depth)
    {
        order_.push_back(bone);
        std::string name = rig_.model.bones[bone].name;
        std::ranges::replace_if(
            name, [](unsigned char c) { return c <= ' ' || c == '{' || c == '}'; }, '_');
        writeLine(depth,
                  (parentOf(bone) < 0 ? "ROOT " : "JOINT ") + (name.empty() ? fmt::format("bone{}", bone) : name));
        writeLine(depth, "{");
        writeOffset(depth + 1, offsetOf(bone));
        const std::string turns = "Zrotation Xrotation Yrotation";
        writeLine(depth + 1,
                  hasPosition(bone) ? "CHANNELS 6 Xposition Yposition Zposition " + turns : "CHANNELS 3 " + turns);
        bool isLeaf = true;
        for (size_t child = bone + 1; child < rig_.model.bones.size(); ++child) {
            if (parentOf(child) != static_cast<int32_t>(bone)) continue;
            isLeaf = false;
            writeJoint(child, depth + 1);
        }
        if (isLeaf) writeEnd(bone, depth + 1);
        writeLine(depth, "}");
    }

    /// Writes an end half as long as the last bone.
    void writeEnd(size_t bone, int depth)
    {
        writeLine(depth, "End Site");
        writeLine(depth, "{");
        writeOffset(depth + 1, 0.5f * offsetOf(bone));
        writeLine(depth, "}");
    }

    bool hasPosition(size_t bone) const { return parentOf(bone) < 0 || apart_[bone]; }

    /// @param last angles of each bone [degrees].
    void writeFrame(const std::vector<Isometry3f>& frame, std::vector<Vector3f>& last)
    {
        std::string line;
        for (const size_t bone : order_) {
            const int32_t parent = parentOf(bone);
            const Isometry3f above = parent < 0 ? Isometry3f::Identity() : frame[static_cast<size_t>(parent)];
            const Vector3f from = parent < 0 ? Vector3f(Vector3f::Zero()) : headOf(static_cast<size_t>(parent));
            if (hasPosition(bone)) {
                const Vector3f at = CENTIMETRES * (above.inverse() * (frame[bone] * headOf(bone)) - from);
                line += fmt::format("{:.5f} {:.5f} {:.5f} ", at.x(), at.y(), at.z());
            }
            last[bone] = anglesOf(above.linear().transpose() * frame[bone].linear(), last[bone]);
            line += fmt::format("{:.5f} {:.5f} {:.5f} ", last[bone][0], last[bone][1], last[bone][2]);
        }
        line.back() = '\n';
        text_ += line;
    }

    const Rig& rig_;
    const Frames& frames_;
    std::vector<bool> apart_;
    std::vector<size_t> order_;  // of the channels
    std::string text_;
};

}  // namespace

std::vector<std::string> bvhPaths(const std::string& path, const Scene& scene)
{
    std::vector<uint32_t> objects;
    for (const SceneActor& use : scene.actors) objects.insert(objects.end(), use.objects.begin(), use.objects.end());
    std::ranges::sort(objects);
    if (objects.size() < 2) return {path};
    if (OutputPlace::of(path).kind == OutputPlace::Kind::Stream)
        throw InputError(fmt::format("--export bvh={}: the scene has {} actors with a file each, of which a stream "
                                     "takes one; name a file",
                                     path, objects.size()));
    std::vector<std::string> paths;
    std::set<std::string> used;
    const std::filesystem::path whole(path);
    for (const uint32_t object : objects) {
        std::string plain = scene.world.objects[object].name;
        std::ranges::replace(plain, '/', '_');
        std::string name = plain;
        for (int times = 2; !used.insert(name).second; ++times) name = fmt::format("{}_{}", plain, times);
        paths.push_back(
            (whole.parent_path() / fmt::format("{}_{}{}", whole.stem().string(), name, whole.extension().string()))
                .string());
    }
    return paths;
}

std::string bvhText(const Rig& rig, const Frames& frames, double framesPerSecond)
{
    return BvhText(rig, frames).text(framesPerSecond);
}

void BvhExport::addPaths(const Scene& scene, RunPaths& paths) const
{
    for (const std::string& file : bvhPaths(path(), scene)) paths.writes(file);
}

void BvhExport::begin(const Scene& scene)
{
    framesPerSecond_ = scene.framesPerSecond;
    rigs_ = rigsOf(scene, false);
    motions_.resize(rigs_.size());
    if (rigs_.empty())
        throw InputError(fmt::format("--export bvh={}: the scene has no actor, whose bones could be written", path()));
    for (const std::string& file : bvhPaths(path(), scene)) files_.push_back(std::make_unique<OutputFile>(file));
}

void BvhExport::frame(const ExportFrame& frame)
{
    for (size_t r = 0; r < rigs_.size(); ++r) {
        std::vector<Isometry3f> bones;
        for (const uint32_t body : rigs_[r].bodies)
            bones.push_back(motionOf(frame.world.bodies[body], (*frame.bodies)[body]));
        motions_[r].push_back(std::move(bones));
    }
}

void BvhExport::finish()
{
    for (size_t r = 0; r < rigs_.size(); ++r) {
        files_[r]->write(bvhText(rigs_[r], motions_[r], framesPerSecond_));
        files_[r]->commit();
    }
}

}  // namespace knuckle

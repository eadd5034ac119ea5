#include "tools/shapes/pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knuckle {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// Columns: along, the part of `pole` across it, their cross product.
Matrix3d frame(const Vector3d& along, const Vector3d& pole)
{
    Matrix3d m;
    m.col(0) = along.normalized();
    m.col(1) = (pole - pole.dot(m.col(0)) * m.col(0)).normalized();
    m.col(2) = m.col(0).cross(m.col(1));
    return m;
}

}  // namespace

Matrix3d turn(double degrees, const Vector3d& axis)
{
    return AngleAxisd(degrees * std::numbers::pi / 180.0, axis.normalized()).toRotationMatrix();
}

double smooth(double way)
{
    const double t = std::clamp(way, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

BentLimb bend(const Vector3d& root, const Vector3d& reach, double upper, double lower, const Vector3d& pole)
{
    const double c = std::min(reach.norm(), 0.9995 * (upper + lower));
    const double along = (upper * upper - lower * lower + c * c) / (2.0 * c);
    const Matrix3d f = frame(reach, pole);
    const double across = std::sqrt(std::max(upper * upper - along * along, 0.0));
    return {root + along * f.col(0) + across * f.col(1), root + c * f.col(0), f.col(2)};
}

Matrix3d aim(const Vector3d& restDirection, const Vector3d& restPole, const Vector3d& direction, const Vector3d& normal)
{
    Matrix3d m;
    m.col(0) = direction.normalized();
    m.col(1) = normal.cross(m.col(0)).normalized();
    m.col(2) = m.col(0).cross(m.col(1));
    return m * frame(restDirection, restPole).transpose();
}

void attach(uint32_t bone, uint32_t parent, const Matrix3d& local, const Heads& rest, Heads& heads,
            Rotations& rotations)
{
    heads[bone] = heads[parent] + rotations[parent] * (rest[bone] - rest[parent]);
    rotations[bone] = rotations[parent] * local;
}

Footfall footfallAt(double phase, double stride, double swing)
{
    const double rounds = std::floor(phase), part = phase - rounds;
    const double way = std::max(part - (1.0 - swing), 0.0) / swing;
    const double along = stride * (rounds + smooth(way) + 0.5 * (1.0 - swing));
    return {along, std::min(part / (1.0 - swing), 1.0), way, 4.0 * way * (1.0 - way)};
}

double wave(double phase)
{
    return std::sin(2.0 * std::numbers::pi * phase);
}

Clip makeClip(const std::string& name, double duration, const std::vector<Bone>& bones,
              const std::function<void(int key, const Heads& rest, Heads& heads, Rotations& rotations)>& pose)
{
    Heads rest;
    for (const Bone& bone : bones) rest.push_back(bone.restPose.block<3, 1>(0, 3).cast<double>());
    Clip clip;
    clip.name = name;
    clip.duration = duration;
    const int keys = static_cast<int>(std::lround(duration * KEYS_PER_SECOND));
    for (int k = 0; k <= keys; ++k) {
        Heads heads(rest.size());
        Rotations rotations(rest.size());
        pose(k, rest, heads, rotations);
        std::vector<Eigen::Matrix4f> poses(rest.size(), Eigen::Matrix4f::Identity());
        for (size_t b = 0; b < rest.size(); ++b) {
            poses[b].topLeftCorner<3, 3>() = rotations[b].cast<float>();
            poses[b].block<3, 1>(0, 3) = heads[b].cast<float>();
        }
        clip.keyTimes.push_back(static_cast<double>(k) / KEYS_PER_SECOND);
        clip.poses.push_back(poses);
    }
    return clip;
}

}  // namespace knuckle

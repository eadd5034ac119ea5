#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "sim/rig/actor.h"

namespace knuckle {

/// One turn of a joint about one axis.
struct RobotTurn {
    std::string name;
    Vector3f axis{0, 0, 1};  ///< Unit.
    TurnRange range;         ///< [rad]
};

/// A body with its joint, as articulated simulators have it. All frames are unturned at rest and +Z is up.
struct RobotLink {
    std::string name;
    int32_t parent = -1;           ///< Into Robot::links; -1: free.
    Vector3f origin{0, 0, 0};      ///< Of its frame, where its joint is; of the first link its mass centre [m].
    std::vector<RobotTurn> turns;  ///< From the parent outwards; none: it is fixed to its parent.
    bool isBall = false;           ///< Turns freely about all axes, of which `turns` has three.
    float mass = 0.0f;             ///< [kg]
    Vector3f centre{0, 0, 0};      ///< Of mass [m].
    Eigen::Matrix3f inertia = Eigen::Matrix3f::Zero();  ///< About that [kg m2].
    std::array<Vector3f, 2> ends{};                     ///< Of the capsule that fits its particles best [m].
    float radius = 0.0f;                                ///< Of that [m].
};

/// An actor for simulators that have generalized coordinates: a tree of links, parents before children.
struct Robot {
    std::string name;
    std::vector<RobotLink> links;
    std::vector<std::array<uint32_t, 2>> apart;  ///< Links that never touch, besides parents and children.
};

/// @param density of its particles [kg/m3]. A ball's cone becomes ranges about two axes across it, a universal joint
/// two hinges on either side of its cross.
Robot robotOf(const Actor& actor, float density = 1000.0f);

/// The Unified Robot Description Format of ROS: several turns of one joint have small links between them, since it has
/// no other joints than hinges.
std::string urdfOf(const Robot& robot);
/// MuJoCo's XML.
std::string mjcfOf(const Robot& robot);

/// What a hinge that shares its joint with others has of its own [kg m2]: where a ball's first and last come to lie in
/// a line, nothing would be left against turns about the line across both.
float hingeInertia(const RobotLink& link);

/// As both formats have them.
std::string numbersOf(const Vector3f& v);

}  // namespace knuckle

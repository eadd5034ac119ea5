#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sim/rig/bodies/make_actor.h"
#include "tests/rig/shapes.h"

namespace knuckle {

/// A box from z = 0 to 2 whose lower half follows one bone and whose upper half another.
inline Model twoBoneBox(const std::string& upperName, float thickness = 0.25f)
{
    Model model;
    model.name = "box";
    for (int half = 0; half < 2; ++half) {
        const auto h = static_cast<float>(half);
        const TriangleMesh mesh = boxMesh({0, 0, 0.5f + h}, {thickness, thickness, 0.5f});
        for (const Triangle& t : mesh.triangles) {
            const auto first = static_cast<uint32_t>(8 * half);
            model.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        }
        for (const Vector3f& v : mesh.vertices) {
            SkinWeights skin;
            skin.bones[0] = static_cast<uint32_t>(half);
            skin.weights[0] = 1.0f;
            model.vertices.push_back(v);
            model.skin.push_back(skin);
        }
        Bone bone{half == 0 ? "root" : upperName, half - 1};
        bone.restPose(2, 3) = h;
        model.bones.push_back(bone);
    }
    return model;
}

inline Actor make(const Model& model, float diameter, const ArticulationOptions& articulation = {})
{
    return makeActor(model, {.name = {}, .voxels = {.diameter = diameter}, .articulation = articulation});
}

inline bool contains(const std::vector<uint32_t>& list, uint32_t value)
{
    return std::find(list.begin(), list.end(), value) != list.end();
}

/// Checks properties of every actor: a tree of bodies, joined by particles in both, and every particle in a body.
inline void expectSound(const Actor& actor)
{
    ASSERT_EQ(actor.signedDistances.size(), actor.particles.size());
    ASSERT_EQ(actor.joints.size() + 1, actor.bodies.size());
    std::vector<int> timesChild(actor.bodies.size(), 0), memberships(actor.particles.size(), 0);
    for (const ActorBody& body : actor.bodies) {
        EXPECT_FALSE(body.particles.empty()) << body.name;
        for (uint32_t particle : body.particles) {
            ASSERT_LT(particle, actor.particles.size());
            ++memberships[particle];
        }
    }
    for (const ActorJoint& joint : actor.joints) {
        ++timesChild[joint.child];
        EXPECT_EQ(actor.bodies[joint.child].parent, static_cast<int32_t>(joint.parent));
        for (uint32_t particle : joint.sharedParticles) {
            EXPECT_TRUE(contains(actor.bodies[joint.parent].particles, particle)) << joint.name;
            EXPECT_TRUE(contains(actor.bodies[joint.child].particles, particle)) << joint.name;
        }
    }
    EXPECT_EQ(std::count(timesChild.begin(), timesChild.end(), 1), static_cast<std::ptrdiff_t>(actor.joints.size()));
    EXPECT_EQ(*std::min_element(memberships.begin(), memberships.end()), 1);
    for (size_t b = 0; b < actor.bodies.size(); ++b) {
        std::set<int32_t> above;
        for (int32_t body = static_cast<int32_t>(b); body >= 0; body = actor.bodies[body].parent) {
            ASSERT_TRUE(above.insert(body).second) << "the bodies form a ring";
        }
    }
}

}  // namespace knuckle

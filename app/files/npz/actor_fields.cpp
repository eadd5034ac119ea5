#include "app/files/npz/actor_fields.h"

#include <algorithm>
#include <cstring>

namespace knuckle {

bool ActorField::isList() const
{
    return *group != '\0' && !shape.empty() && shape[0] == ANY;
}

std::string ActorField::list() const
{
    return std::string(name) + "_starts";
}

std::string ActorField::pointer() const
{
    std::string path = *group == '\0' ? std::string("/") + name : name + std::strlen(group);
    std::ranges::replace(path, '_', '/');
    return path;
}

const std::vector<ActorField>& actorFields()
{
    using enum ActorValue;
    static const std::vector<ActorField> FIELDS{
        {"format", Word, {}},
        {"version", Integer, {}},
        {"name", Word, {}},
        {"diameter", Double, {}},
        {"model", Word, {}},
        {"skeleton", Word, {}},
        {"split", Flag, {}},
        {"scale", Double, {}},
        {"height", Double, {}},
        {"up", Word, {}},
        {"centering", Word, {}},
        {"notes", Word, {ANY}},
        {"particles", Float, {ANY, 3}},
        {"signedDistances", Float, {ANY}},
        {"outward", Float, {ANY, 3}},
        {"bodies_name", Word, {}, "bodies"},
        {"bodies_parent", Integer, {}, "bodies"},
        {"bodies_cross", Flag, {}, "bodies"},
        {"bodies_particles", Integer, {ANY}, "bodies"},
        {"bodies_mergedBones", Word, {ANY}, "bodies"},
        {"bodies_mass", Float, {}, "bodies"},
        {"bodies_centre", Float, {3}, "bodies"},
        {"bodies_inertia", Float, {3, 3}, "bodies"},
        {"joints_name", Word, {}, "joints"},
        {"joints_type", Word, {}, "joints"},
        {"joints_parent", Integer, {}, "joints"},
        {"joints_child", Integer, {}, "joints"},
        {"joints_anchor", Float, {3}, "joints"},
        {"joints_axis", Float, {3}, "joints"},
        {"joints_sharedParticles", Integer, {ANY}, "joints"},
        {"joints_limits_swing", Double, {}, "joints"},
        {"joints_limits_cone", Float, {3}, "joints"},
        {"joints_limits_twist", Double, {2}, "joints"},
        {"joints_limits_bend", Double, {2}, "joints"},
        {"joints_limits_stiffness", Float, {}, "joints"},
        {"joints_tearForce", Float, {}, "joints"},
        {"joints_tearTorque", Float, {}, "joints"},
        {"neverTouch", Integer, {ANY, 2}},
        {"skin_vertices", Float, {ANY, 3}},
        {"skin_triangles", Integer, {ANY, 3}},
        {"skin_bodies", Integer, {ANY, 4}},
        {"skin_weights", Float, {ANY, 4}},
        {"skin_particleBodies", Integer, {ANY, 4}},
        {"skin_particleWeights", Float, {ANY, 4}},
    };
    return FIELDS;
}

}  // namespace knuckle

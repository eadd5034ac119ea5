// What joint_factor hands from a joint's body to its parent: the inertia that the parent sees of it.
#include "math/spatial.glsl"
#include "shared/joint_records.h"
#include "sim/joint/short_tree.glsl"

#ifdef SHORT_TREES
Inertia handedInertias[SHORT_TREE];

void storeInertia(uint joint, Inertia m) { handedInertias[treePlace] = m; }

/// With that of what hangs on it.
Inertia withHanded(uint k, Joint joint, Inertia m)
{
    for (int place = treePlace + 1; place < SHORT_TREE; ++place)
        if (hangsOn(place, k, joint)) m = add(m, handedInertias[place]);
    return m;
}
#else
BUFFER(vec4, JointInertias, jointInertias);

Inertia loadInertia(uint joint)
{
    uint first = JOINT_INERTIA_TEXELS * joint;
    vec4 t[JOINT_INERTIA_TEXELS];
    for (int k = 0; k < JOINT_INERTIA_TEXELS; ++k) t[k] = jointInertias[first + uint(k)];
    return Inertia(symmetricMatrix(t[0].xyz, t[1].xyz), mat3(t[4].xyz, t[5].xyz, vec3(t[0].w, t[1].w, t[2].w)),
                   symmetricMatrix(t[2].xyz, t[3].xyz));
}

void storeInertia(uint joint, Inertia m)
{
    uint first = JOINT_INERTIA_TEXELS * joint;
    jointInertias[first] = vec4(diagonalOf(m.a), m.b[2].x);
    jointInertias[first + 1u] = vec4(offDiagonalOf(m.a), m.b[2].y);
    jointInertias[first + 2u] = vec4(diagonalOf(m.d), m.b[2].z);
    jointInertias[first + 3u].xyz = offDiagonalOf(m.d);
    jointInertias[first + 4u].xyz = m.b[0];
    jointInertias[first + 5u].xyz = m.b[1];
}

/// With that of what hangs on it.
Inertia withHanded(uint k, Joint joint, Inertia m)
{
    for (uint child = joint.firstChild; child < joint.childEnd; ++child) m = add(m, loadInertia(child));
    return m;
}
#endif

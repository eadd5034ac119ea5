// The values of joint_sweep_records.glsl for the joints of a short tree.
#include "math/spatial.glsl"
#include "sim/joint/short_tree.glsl"

struct Asked {
    Force force;    // on the body with all that hangs on it, at its joint
    Motion error;   // of its joint
};

#ifdef SHORT_TREES
Force handedForces[SHORT_TREE];
Asked askedForces[SHORT_TREE];
Motion sweptMotions[SHORT_TREE];

void storeHandedForce(uint joint, Force f) { handedForces[treePlace] = f; }
void storeAsked(uint joint, Asked asked) { askedForces[treePlace] = asked; }
Asked loadAsked(uint joint) { return askedForces[treePlace]; }
void storeSwept(uint joint, Motion m) { sweptMotions[treePlace] = m; }

/// With the forces of what hangs on it.
Force withHanded(uint k, Joint joint, Force own)
{
    for (int place = treePlace + 1; place < SHORT_TREE; ++place)
        if (hangsOn(place, k, joint)) own = add(own, handedForces[place]);
    return own;
}

Motion motionOfParent(uint k, Joint joint)
{
    int parent = parentPlace(k, joint);
    Motion m = sweptMotions[0];
    for (int place = 1; place < treePlace; ++place)
        if (parent == place) m = sweptMotions[place];
    return m;
}
#endif

// SHORT_TREES: of a world whose trees have few joints each. What sweeps pass from joint to joint stays in registers: a
// loop over all of a tree is unrolled, so that the places of arrays are constants.
#include "sim/joint/joint_info.glsl"

#ifdef SHORT_TREES

/// The most joints of a tree.
const int SHORT_TREE = 3;

/// The place in its tree of the joint that is dealt with, from the root, 0.
int treePlace = 0;

/// From the leaves to the root, and back: `call` for each joint k of a tree.
#define UP_TREE(tree, call) \
    for (int place = SHORT_TREE - 1; place >= 0; --place) { \
        uint k = tree.first + uint(place); \
        treePlace = place; \
        if (k < tree.end) call; \
    }
#define DOWN_TREE(tree, call) \
    for (int place = 0; place < SHORT_TREE; ++place) { \
        uint k = tree.first + uint(place); \
        treePlace = place; \
        if (k < tree.end) call; \
    }

/// Whether the joint at a place of the tree hangs on joint k, which is dealt with.
bool hangsOn(int place, uint k, Joint joint)
{
    uint other = k - uint(treePlace) + uint(place);
    return other >= joint.firstChild && other < joint.childEnd;
}

/// The place of the joint on which joint k hangs.
int parentPlace(uint k, Joint joint)
{
    return int(joint.parentJoint - (k - uint(treePlace)));
}

#else
#define UP_TREE(tree, call) for (uint k = tree.end; k-- > tree.first;) call;
#define DOWN_TREE(tree, call) for (uint k = tree.first; k < tree.end; ++k) call;
#endif

// What contacts with colliders are for a rope's node, in `nodeContacts`: a stiffness [kg], in w of its columns a push
// [kg m], and by how much the rope has then moved the node in this iteration, and before it [m].
#define NODE_CONTACT_TEXELS 5u

uint contactColumn(uint node, uint column) { return NODE_CONTACT_TEXELS * node + column; }
uint moveOf(uint node) { return NODE_CONTACT_TEXELS * node + 3u; }
uint moveBefore(uint node) { return NODE_CONTACT_TEXELS * node + 4u; }

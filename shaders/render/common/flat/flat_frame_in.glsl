// For fragments of few, large triangles, whose vertices include flat_frame_out.glsl. Stands before all other includes.
#include "render/common/flat/flat_frame.glsl"

#ifdef FLAT_FRAME
#define READS_FLAT_FRAME
in FlatFrame { FLAT_FRAME_MEMBERS } frame;
in FlatView { FLAT_VIEW_MEMBERS } view;
#endif

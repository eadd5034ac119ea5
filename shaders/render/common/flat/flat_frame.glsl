// FLAT_FRAME: fragments read the frame and the view as inputs that are the same for all of them. llvmpipe reads each
// number of a uniform block once for every pixel. Linkers leave out what is not asked for.
#include "shared/draw_types.h"
#include "shared/frame_types.h"

// What fragments ask of FrameInput and of FrameView.
#define FLAT_FRAME_MEMBERS \
    flat vec4 keyDirection, keyColor, skyColor, groundColor, groundAlbedo, backdrop, bounce, fog, develop; \
    flat uint width, height, resolveFactor; \
    flat float radius, tanHalfFov, farDepth, shadowSize, occlusionRadius, patternScale, groundFade, fluidRadius;
#define FLAT_VIEW_MEMBERS \
    flat vec4 cameraRight, cameraUp, cameraBack, cameraPosition, lightRight, lightUp, lightCentre, lightDepth; \
    flat vec4 viewToLightX, viewToLightY, viewToLightZ, keyInView, upInView, shadedInLight; \
    flat vec4 particleLow, particleHigh;

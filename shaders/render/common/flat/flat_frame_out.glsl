// Gives fragments what flat_frame_in.glsl reads.
#include "render/common/flat/flat_frame.glsl"
#include "render/common/frame_blocks.glsl"

#ifdef FLAT_FRAME
out FlatFrame { FLAT_FRAME_MEMBERS } flatFrame;
out FlatView { FLAT_VIEW_MEMBERS } flatView;

#define GIVE_FRAME(member) flatFrame.member = frame.member
#define GIVE_VIEW(member) flatView.member = view.member

void giveFrame()
{
    GIVE_FRAME(keyDirection), GIVE_FRAME(keyColor), GIVE_FRAME(skyColor), GIVE_FRAME(groundColor);
    GIVE_FRAME(groundAlbedo), GIVE_FRAME(backdrop), GIVE_FRAME(bounce), GIVE_FRAME(fog), GIVE_FRAME(develop);
    GIVE_FRAME(width), GIVE_FRAME(height), GIVE_FRAME(resolveFactor);
    GIVE_FRAME(radius), GIVE_FRAME(tanHalfFov), GIVE_FRAME(farDepth), GIVE_FRAME(shadowSize);
    GIVE_FRAME(occlusionRadius), GIVE_FRAME(patternScale), GIVE_FRAME(groundFade), GIVE_FRAME(fluidRadius);
    GIVE_VIEW(cameraRight), GIVE_VIEW(cameraUp), GIVE_VIEW(cameraBack), GIVE_VIEW(cameraPosition);
    GIVE_VIEW(lightRight), GIVE_VIEW(lightUp), GIVE_VIEW(lightCentre), GIVE_VIEW(lightDepth);
    GIVE_VIEW(viewToLightX), GIVE_VIEW(viewToLightY), GIVE_VIEW(viewToLightZ), GIVE_VIEW(keyInView);
    GIVE_VIEW(upInView), GIVE_VIEW(shadedInLight), GIVE_VIEW(particleLow), GIVE_VIEW(particleHigh);
}
#else
void giveFrame() {}
#endif

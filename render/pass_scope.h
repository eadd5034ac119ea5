#pragma once

#include "sim/gpu/kernel.h"

namespace knuckle {

/// One pass of a frame while it lives: its time, and a debug group for traces.
class PassScope {
public:
    PassScope(KernelTimer& timer, const char* name) : timer_(timer)
    {
        glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
        timer_.begin(name);
    }
    ~PassScope()
    {
        timer_.end();
        glPopDebugGroup();
    }
    PassScope(const PassScope&) = delete;
    PassScope& operator=(const PassScope&) = delete;

private:
    KernelTimer& timer_;
};

}  // namespace knuckle

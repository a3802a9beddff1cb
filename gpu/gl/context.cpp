#include "gpu/gl/context.hpp"

#include "gpu/gl/debug_output.hpp"
#include "gpu/gl/error.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <string>

namespace autostereo::gpu::gl {

namespace {

EGLDisplay surfacelessDisplay() {
    const auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    EGLDisplay display = EGL_NO_DISPLAY;
    if (getDisplay != nullptr)
        display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    // Drivers without Mesa's platform offer surfaceless contexts on their default display.
    if (display == EGL_NO_DISPLAY) display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
        throw GlError("egl: cannot open a display without a window system: is a GL driver "
                      "(libegl-mesa0) installed?");
    return display;
}

} // namespace

SurfacelessContext::SurfacelessContext(bool debug) {
    EGLDisplay display = surfacelessDisplay();
    eglBindAPI(EGL_OPENGL_API);
    const std::array<EGLint, 3> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0)
        config = EGL_NO_CONFIG_KHR;
    // Asked to tell of resets; a driver that cannot makes no such context. Those that cannot are of
    // EGL 1.4, which knows debugging as a flag.
    for (const bool telling : {true, false}) {
        const std::array<EGLint, 11> attributes{
            EGL_CONTEXT_MAJOR_VERSION,
            4,
            EGL_CONTEXT_MINOR_VERSION,
            5,
            EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
            telling ? EGL_CONTEXT_OPENGL_DEBUG : EGL_CONTEXT_FLAGS_KHR,
            debug ? EGL_TRUE : EGL_FALSE, // the flag, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR, is 1, too
            telling ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY : EGL_NONE,
            EGL_LOSE_CONTEXT_ON_RESET,
            EGL_NONE};
        context_ = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
        if (context_ != EGL_NO_CONTEXT) break;
    }
    if (context_ == EGL_NO_CONTEXT)
        throw GlError("egl: cannot create an OpenGL 4.5 core context (error " +
                      std::to_string(eglGetError()) + "): does the driver offer it?");
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
        throw GlError("egl: cannot make a context current without a surface");
    if (debug) logDebugOutput();
}

SurfacelessContext::~SurfacelessContext() {
    EGLDisplay display = eglGetCurrentDisplay();
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context_);
}

} // namespace autostereo::gpu::gl

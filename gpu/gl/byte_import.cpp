#include "gpu/gl/byte_import.hpp"

#include "gpu/gl/error.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <bit>
#include <cstring>
#include <string_view>

namespace autostereo::gpu::gl {

namespace {

// GL_OES_EGL_image, which desktop drivers offer too.
using ImageTarget = void (*)(GLenum target, void* image);

template<class Function>
Function entry(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

bool offers(EGLDisplay display, std::string_view extension) {
    const char* all = eglQueryString(display, EGL_EXTENSIONS);
    return all != nullptr && std::string_view(all).find(extension) != std::string_view::npos;
}

/// R8, as DRM writes it.
constexpr EGLint kR8 = 'R' | '8' << 8 | ' ' << 16 | ' ' << 24;

} // namespace

std::optional<std::string> importProblem() {
    EGLDisplay display = eglGetCurrentDisplay();
    if (display == EGL_NO_DISPLAY) return "the context is not EGL's";
    if (!offers(display, "EGL_EXT_image_dma_buf_import") ||
        entry<PFNEGLCREATEIMAGEKHRPROC>("eglCreateImageKHR") == nullptr ||
        entry<ImageTarget>("glEGLImageTargetTexture2DOES") == nullptr)
        return "the GL driver cannot import memory (EGL_EXT_image_dma_buf_import)";
    return std::nullopt;
}

std::string cardNode() {
    const auto queryDisplay = entry<PFNEGLQUERYDISPLAYATTRIBEXTPROC>("eglQueryDisplayAttribEXT");
    const auto queryDevice = entry<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    EGLAttrib device = 0;
    if (queryDisplay == nullptr || queryDevice == nullptr ||
        queryDisplay(eglGetCurrentDisplay(), EGL_DEVICE_EXT, &device) == EGL_FALSE)
        return {};
    const char* node = queryDevice(std::bit_cast<EGLDeviceEXT>(device), EGL_DRM_DEVICE_FILE_EXT);
    return node == nullptr ? std::string() : node;
}

ByteImport::ByteImport(int fd, int rowBytes, int rows) {
    if (const auto problem = importProblem()) throw GlError("egl: " + *problem);
    EGLDisplay display = eglGetCurrentDisplay();
    const std::array<EGLint, 13> attributes{EGL_WIDTH,
                                            rowBytes,
                                            EGL_HEIGHT,
                                            rows,
                                            EGL_LINUX_DRM_FOURCC_EXT,
                                            kR8,
                                            EGL_DMA_BUF_PLANE0_FD_EXT,
                                            fd,
                                            EGL_DMA_BUF_PLANE0_OFFSET_EXT,
                                            0,
                                            EGL_DMA_BUF_PLANE0_PITCH_EXT,
                                            rowBytes,
                                            EGL_NONE};
    void* image = entry<PFNEGLCREATEIMAGEKHRPROC>("eglCreateImageKHR")(
        display, EGL_NO_CONTEXT, EGL_LINUX_DMA_BUF_EXT, nullptr, attributes.data());
    if (image == EGL_NO_IMAGE_KHR)
        throw GlError("egl: the GL driver does not take the memory (error " +
                      std::to_string(eglGetError()) + ")");
    GLuint name = 0;
    glGenTextures(1, &name); // made by being bound: an image is no storage that glCreate* knows
    texture_ = Handle<deleteTexture>(name);
    glBindTexture(GL_TEXTURE_2D, name);
    entry<ImageTarget>("glEGLImageTargetTexture2DOES")(GL_TEXTURE_2D, image);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    GLint width = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    glBindTexture(GL_TEXTURE_2D, 0);
    // The texture keeps what it shows.
    entry<PFNEGLDESTROYIMAGEKHRPROC>("eglDestroyImageKHR")(display, image);
    if (width != rowBytes) throw GlError("egl: the GL driver makes no texture of the memory");
}

} // namespace autostereo::gpu::gl

#pragma once

namespace autostereo::gpu::gl {

/// A surfaceless OpenGL 4.5 core context (EGL), current on the constructing thread while it lives.
/// The EGL display is shared by the process and never terminated (Mesa would leak its module).
class SurfacelessContext {
  public:
    /// `debug` asks for a debug context, as all tests do. Throws GlError.
    explicit SurfacelessContext(bool debug);
    ~SurfacelessContext();
    SurfacelessContext(const SurfacelessContext&) = delete;
    SurfacelessContext& operator=(const SurfacelessContext&) = delete;

  private:
    void* context_ = nullptr; // EGLContext; EGL's headers stay in the .cpp
};

} // namespace autostereo::gpu::gl

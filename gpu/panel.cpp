#include "gpu/panel.hpp"

namespace autostereo::gpu {

std::string rendererName() {
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return name != nullptr ? name : "unknown";
}

} // namespace autostereo::gpu

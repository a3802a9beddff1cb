#include "daemon/commands/view_files.hpp"

#include "daemon/picture_files.hpp"

#include <cstdio>

namespace autostereo::daemon {

gpu::RgbImage readAtlas(const gpu::Atlas& atlas) {
    return gpu::readFramebuffer(atlas.framebuffer(), atlas.layout().width(),
                                atlas.layout().height());
}

void writeViews(const gpu::Atlas& atlas, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const gpu::AtlasLayout& layout = atlas.layout();
    const gpu::RgbImage all = readAtlas(atlas);
    for (int view = 0; view < layout.views; ++view) {
        char name[32];
        std::snprintf(name, sizeof name, "view_%02d.png", view);
        const int top = layout.height() - layout.bottom(view) - layout.quilt.tileHeight;
        writePicturePng(folder / name, gpu::crop(all, layout.left(view), top,
                                                 layout.quilt.tileWidth, layout.quilt.tileHeight));
    }
}

} // namespace autostereo::daemon

#pragma once

#include "calib/display_profile.hpp"
#include "devices/input.hpp"
#include "devices/sim/simulation.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/readback.hpp"
#include "gpu/views/layer_mesher.hpp"
#include "tests/oracle/panel_oracle.hpp"

#include <string>
#include <vector>

namespace autostereo::test {

/// A pair of frames and its cameras.
struct CapturedPair {
    calib::SensorRig rig;
    devices::RgbdFrame frame;
    std::unique_ptr<devices::Source> depth, color; ///< own the frames' memory
};

inline CapturedPair takePair(devices::Input input, int skip) {
    CapturedPair pair{*input.rig, {}, std::move(input.depth), std::move(input.color)};
    for (int i = 0; i <= skip; ++i) {
        pair.frame.depth = std::get<devices::Frame>(pair.depth->read(devices::TimePoint::max()));
        pair.frame.color = std::get<devices::Frame>(pair.color->read(devices::TimePoint::max()));
    }
    return pair;
}

/// The pair after `skip` others of a simulation.
inline CapturedPair simulate(const std::string& uri, int skip = 0) {
    return takePair(devices::sim::openSimulation(uri), skip);
}

/// Lens sheet like the Portrait's, small enough to draw in a test.
inline calib::DisplayProfile smallLensDisplay(int columns, int rows, int tileWidth,
                                              int tileHeight) {
    calib::DisplayProfile display;
    display.name = "small";
    display.width = 384;
    display.height = 512;
    display.widthM = 0.12;
    display.viewingDistanceM = 0.5;
    display.coneRad = 0.698;
    display.views = columns * rows;
    calib::LookingGlassCalibration unit;
    unit.pitch = 52.56;
    unit.slope = -7.1423;
    unit.center = 0.4735;
    unit.dpi = 324;
    unit.screenWidth = 384;
    unit.screenHeight = 512;
    display.law = unit;
    display.quilt = {columns, rows, tileWidth, tileHeight};
    display.disparityFar = -0.06;
    display.disparityNear = 0.06;
    return display;
}

/// The mesh's input, as the depth conditioner left it.
inline oracle::MeshInput oracleInput(const CapturedPair& pair, const gpu::Pipeline& pipeline,
                                     const gpu::PipelineParams& params) {
    const devices::FrameMetadata& form = pair.frame.depth.metadata();
    std::vector<std::uint16_t> counts(pair.frame.depth.pixelCount());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(pipeline.conditioner().depth().name(), 0, GL_RED_INTEGER, GL_UNSIGNED_SHORT,
                      static_cast<GLsizei>(2 * counts.size()), counts.data());
    return {{form.width, form.height, form.depthUnitM, std::move(counts)},
            pair.rig,
            pipeline.geometry(),
            params.mesh};
}

inline oracle::Picture colorPicture(const devices::Frame& frame) {
    oracle::Picture picture{frame.metadata().width, frame.metadata().height, {}};
    const auto bytes = frame.pixels();
    for (std::size_t i = 0; i < frame.pixelCount(); ++i)
        picture.pixels.push_back({static_cast<double>(bytes[4 * i]),
                                  static_cast<double>(bytes[4 * i + 1]),
                                  static_cast<double>(bytes[4 * i + 2])});
    return picture;
}

/// A layer as the GPU holds it, for drawing it in double precision.
inline oracle::Layer readLayer(const gpu::MeshLayer& layer) {
    const auto nodes = static_cast<std::size_t>(layer.points.width()) *
                       static_cast<std::size_t>(layer.points.height());
    std::vector<glm::vec4> points(nodes);
    std::vector<glm::vec2> sources(nodes);
    std::vector<GLuint> indices(static_cast<std::size_t>(layer.indexCount));
    glGetTextureImage(layer.points.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(nodes * sizeof(glm::vec4)), points.data());
    glGetTextureImage(layer.sources.name(), 0, GL_RG, GL_FLOAT,
                      static_cast<GLsizei>(nodes * sizeof(glm::vec2)), sources.data());
    glGetNamedBufferSubData(layer.indices.name(), 0,
                            static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)),
                            indices.data());
    oracle::Layer read{layer.points.width(), layer.points.height(), {}, {}};
    for (std::size_t i = 0; i < nodes; ++i) {
        const glm::dvec4 point(points[i]);
        const glm::dvec2 source(sources[i]);
        read.nodes.push_back(oracle::Node{point.x, point.y, point.z, point.w, source.x, source.y});
    }
    for (std::size_t i = 0; i < indices.size(); i += 3)
        if (indices[i] != indices[i + 1])
            read.triangles.push_back({static_cast<int>(indices[i]),
                                      static_cast<int>(indices[i + 1]),
                                      static_cast<int>(indices[i + 2])});
    return read;
}

inline oracle::Picture readPicture(const gpu::gl::Texture& texture) {
    oracle::Picture picture{texture.width(), texture.height(), {}};
    std::vector<std::array<std::uint8_t, 4>> texels(static_cast<std::size_t>(picture.width) *
                                                    static_cast<std::size_t>(picture.height));
    glGetTextureImage(texture.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(4 * texels.size()), texels.data());
    for (const auto& [red, green, blue, alpha] : texels)
        picture.pixels.push_back(
            {static_cast<double>(red), static_cast<double>(green), static_cast<double>(blue)});
    return picture;
}

/// All views' tiles, in double precision, from the layers that the pipeline fused last.
inline std::vector<oracle::Picture> oracleTiles(const gpu::Pipeline& pipeline,
                                                const oracle::Picture& color,
                                                const calib::DisplayProfile& display) {
    gpu::LayerMesher mesher;
    const gpu::MeshLayers& layers = mesher.build(pipeline.scene());
    const oracle::Layer scene = readLayer(layers.scene), behind = readLayer(layers.background);
    const oracle::Picture behindColor = readPicture(*layers.backgroundColor);
    std::vector<oracle::Picture> tiles;
    for (int view = 0; view < display.views; ++view) {
        const double b = (2.0 * view + 1) / display.views - 1;
        oracle::ViewDrawing drawing(display.quilt.tileWidth, display.quilt.tileHeight, {});
        drawing.draw(scene, b, color);
        drawing.draw(behind, b, behindColor);
        tiles.push_back(drawing.picture());
    }
    return tiles;
}

} // namespace autostereo::test

#include "gpu/views/method_choice.hpp"

#include "gpu/gl/objects.hpp"
#include "gpu/readback.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

namespace autostereo::gpu {

namespace {

constexpr double kExactDb = 56; // what rounding to 8 bits leaves of an exact panel

double psnrDb(const RgbImage& a, const RgbImage& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double off = static_cast<double>(a.pixels[i]) - b.pixels[i];
        squares += off * off;
    }
    if (squares == 0) return kExactDb;
    const double mean = squares / static_cast<double>(a.pixels.size());
    return std::min(kExactDb, 10 * std::log10(255 * 255 / mean));
}

/// A method on a panel of its own.
class Candidate {
  public:
    Candidate(PipelineParams params, Method method, const calib::DisplayProfile& display, int width,
              int height)
        : target_(GL_RGBA8, width, height), panel_(gl::makeFramebuffer(target_)) {
        params.synthesis.method = method;
        params.synthesis.positions = ViewPositions::OfViews; // which all methods can show
        params.synthesis.keepRoots = false;                  // the second drawing would find all
        views_ = makeViewSynthesis(params, display, width, height);
    }
    double drawMs(const CyclopeanScene& scene) {
        glFinish();
        const auto began = std::chrono::steady_clock::now();
        views_->prepare(scene);
        views_->show(scene, panel_.name());
        glFinish();
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began)
            .count();
    }
    [[nodiscard]] RgbImage picture() const {
        return readFramebuffer(panel_.name(), target_.width(), target_.height());
    }

  private:
    gl::Texture target_;
    gl::Framebuffer panel_;
    std::unique_ptr<ViewSynthesis> views_;
};

} // namespace

MethodChoice chooseMethod(const PipelineParams& params, const calib::DisplayProfile& display,
                          int panelWidth, int panelHeight, const CyclopeanScene& scene) {
    constexpr std::array kTried{Method::Direct,    Method::Hybrid,   Method::Instanced,
                                Method::Multipass, Method::Geometry, Method::Layered};
    constexpr double kPatienceMs = 1000; // a first drawing may compile shaders
    MethodChoice choice;
    RgbImage exact;
    double fastest = std::numeric_limits<double>::infinity();
    for (const Method method : kTried) {
        Candidate candidate(params, method, display, panelWidth, panelHeight);
        const double first = candidate.drawMs(scene);
        const bool hopeless = first > fastest + kPatienceMs;
        const double ms =
            hopeless ? first : std::min(candidate.drawMs(scene), candidate.drawMs(scene));
        const RgbImage picture = candidate.picture();
        if (method == Method::Direct) exact = picture;
        choice.trials.push_back({method, ms, psnrDb(picture, exact)});
        if (choice.trials.back().psnrDb < params.synthesis.leastDb || ms >= fastest) continue;
        fastest = ms;
        choice.method = method;
    }
    return choice;
}

} // namespace autostereo::gpu

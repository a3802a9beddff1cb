#include "gpu/depth_conditioner.hpp"

#include "gpu/gl/dispatch.hpp"
#include "gpu/scene_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace autostereo::gpu {

namespace {

constexpr int kSigmaBins = 208;  // of 16-bit numbers, binOf() in condition_measure.comp
constexpr int kLargestHole = 8;  // pixels; bounds the shader's loop too
constexpr int kFlyingRounds = 2; // short rows of flying pixels go from their ends
constexpr double kParts = 16;    // sigmas, and factors of them, are in sixteenths
constexpr double kSlopeParts = 4096;
/// A held value that is right has a mean residual of its own error, 0.30 sigma after 16 frames of
/// which each shares a fifth of its noise with the next, and of the mean's, 0.22 sigma: 0.37 in
/// all.
constexpr double kDriftSigmas = 1.75;

/// Of kTallies: missing, rejected, flying, settling, passed, mixed, corrected.
constexpr std::array<std::size_t, 7> kNotHeld{0, 1, 3, 4, 5, 6, 7};

unsigned parts(double number, double perOne, double most) {
    return static_cast<unsigned>(std::lround(std::clamp(number * perOne, 0.0, most)));
}

/// The middle of the numbers that fall into a bin.
double middleOf(int bin) {
    if (bin < 16) return bin;
    const int octave = bin / 16 + 3;
    const double width = std::ldexp(1, octave - 4);
    return (16 + bin % 16 + 0.5) * width - 0.5;
}

/// Sigma in 1/16 counts by count (row 0) and by amplitude (row 1).
gl::Texture makeSigmas(const calib::DepthNoise& noise, double depthUnitM) {
    constexpr double kLargest = 32767; // the sixteenth bit marks flying pixels
    std::vector<std::uint16_t> sigmas;
    const auto add = [&](double sigmaM) {
        const double sixteenths = std::round(kParts * sigmaM / depthUnitM);
        sigmas.push_back(static_cast<std::uint16_t>(std::clamp(sixteenths, 1.0, kLargest)));
    };
    for (int bin = 0; bin < kSigmaBins; ++bin)
        add(noise.sigmaAtRangeM(middleOf(bin) * depthUnitM));
    for (int bin = 0; bin < kSigmaBins; ++bin)
        add(noise.sigmaAtAmplitudeM(middleOf(bin)));
    gl::Texture texture(GL_R16UI, kSigmaBins, 2);
    glTextureSubImage2D(texture.name(), 0, 0, 0, kSigmaBins, 2, GL_RED_INTEGER, GL_UNSIGNED_SHORT,
                        sigmas.data());
    return texture;
}

void clear(const gl::Texture& texture, GLenum format) {
    glClearTexImage(texture.name(), 0, format, GL_UNSIGNED_INT, nullptr);
}

} // namespace

DepthConditioner::DepthConditioner(const ConditionParams& params, const DepthMeshParams& range,
                                   const calib::CameraModel& depthCamera)
    : params_(params), range_(range), camera_(depthCamera), measure_({"condition_measure.comp"}),
      flying_({"condition_flying.comp"}), hold_({"condition_hold.comp"}),
      holes_({"condition_holes.comp"}), resetFills_({"condition_fills.comp"}, {"RESET"}),
      sumFills_({"condition_fills.comp"}), noAmplitude_(GL_R16UI, 1, 1) {}

void DepthConditioner::condition(const gl::Texture& depth, const gl::Texture* amplitude,
                                 double depthUnitM) {
    if (!clean_.isSized(depth.width(), depth.height()) || depthUnitM != depthUnitM_)
        restart(depth, depthUnitM);
    takeTally();
    setBlock(amplitude);
    uniforms_.bind(5, block_);
    counters_.begin(1);
    measure(depth, amplitude);
    for (int round = 0; params_.flyingPixels && round < kFlyingRounds; ++round)
        markFlying(round > 0);
    if (params_.hold) hold();
    // What is not held is another measurement every time.
    fillHoles(params_.hold ? calm_ : pixels_, restarted_ || !params_.hold);
    counters_.end();
}

void DepthConditioner::restart(const gl::Texture& depth, double depthUnitM) {
    const int width = depth.width(), height = depth.height();
    counters_.forget(); // they counted other pixels
    depthUnitM_ = depthUnitM;
    sigmas_ = makeSigmas(params_.noise, depthUnitM);
    pixels_ = gl::Texture(GL_R32UI, width, height);
    nextPixels_ = gl::Texture(GL_R32UI, width, height);
    state_ = gl::Texture(GL_RGBA32UI, width, height);
    nextState_ = gl::Texture(GL_RGBA32UI, width, height);
    waited_ = gl::Texture(GL_R8UI, width, height);
    clean_ = gl::Texture(GL_R16UI, width, height);
    calm_ = gl::Texture(GL_R32UI, width, height);
    for (BlockMarks* marks : {&changed_, &flyingMarks_, &calmMarks_})
        marks->resize(width, height);
    list_.resize(width, height);
    fills_ = gl::makeBuffer(
        2 * sizeof(GLuint) * static_cast<std::size_t>(list_.across() * list_.down()), nullptr, 0);
    restarted_ = true;
    clear(state_, GL_RGBA_INTEGER);
    clear(waited_, GL_RED_INTEGER);
}

void DepthConditioner::setBlock(const gl::Texture* amplitude) {
    const CountRange range =
        params_.validity ? countRange(range_, depthUnitM_) : CountRange{1, 65534};
    const bool judged = params_.validity && amplitude != nullptr;
    block_.valid = glm::uvec4(range.nearest, range.farthest, judged ? params_.weakestAmplitude : 0,
                              judged ? params_.saturatedAmplitude : 65536);
    const double pixelRad = 1 / camera_.resized(clean_.width(), clean_.height()).intrinsics.fx;
    const int hole = params_.fillHoles ? std::clamp(params_.holeWidth, 0, kLargestHole) : 0;
    block_.surface =
        glm::uvec4(parts(std::tan(params_.grazingRad) * pixelRad, kSlopeParts, kSlopeParts),
                   parts(params_.edgeSigmas, kParts, 1600), hole,
                   params_.confidence && amplitude != nullptr ? 1 : 0);
    block_.hold =
        glm::uvec4(parts(params_.gateSigmas, kParts, 1600), std::clamp(params_.settleFrames, 1, 64),
                   std::clamp(params_.keepFrames, 0, 254), parts(kDriftSigmas, kParts, 1600));
}

void DepthConditioner::measure(const gl::Texture& depth, const gl::Texture* amplitude) {
    glBindTextureUnit(0, depth.name());
    glBindTextureUnit(1, (amplitude != nullptr ? *amplitude : noAmplitude_).name());
    glBindTextureUnit(2, sigmas_.name());
    glBindImageTexture(0, pixels_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32UI);
    gl::dispatch(measure_, clean_.width(), clean_.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

/// Again: only where one flies; elsewhere both textures are alike.
void DepthConditioner::markFlying(bool again) {
    if (again)
        lister_.list(list_, {{flyingMarks_, 1, 1}});
    else
        list_.listAll();
    flyingMarks_.clear();
    glBindTextureUnit(0, pixels_.name());
    glBindImageTexture(0, nextPixels_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32UI);
    flyingMarks_.bind(1);
    list_.dispatch(flying_);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    std::swap(pixels_, nextPixels_);
}

void DepthConditioner::hold() {
    glBindTextureUnit(0, pixels_.name());
    glBindTextureUnit(1, state_.name());
    glBindImageTexture(0, calm_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
    glBindImageTexture(1, nextState_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32UI);
    glBindImageTexture(2, waited_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R8UI);
    calmMarks_.clear();
    calmMarks_.bind(3);
    gl::dispatch(hold_, clean_.width(), clean_.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    std::swap(state_, nextState_);
}

void DepthConditioner::fillHoles(const gl::Texture& measured, bool everything) {
    if (everything)
        list_.listAll();
    else
        lister_.list(list_, {{calmMarks_, kLargestHole, kLargestHole}});
    changed_.clear();
    if (std::exchange(restarted_, false)) changed_.markAll(); // there was nothing before
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, fills_.name());
    list_.dispatch(resetFills_);
    glBindTextureUnit(0, measured.name());
    glBindImageTexture(0, clean_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R16UI);
    changed_.bind(1);
    list_.dispatch(holes_);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    sumFills_.use();
    glDispatchCompute(1, 1, 1);
}

std::uint64_t DepthConditioner::restsAfter() const {
    // A mean residual of 16 bits that forgets in 16 frames (condition_hold) is nothing then.
    constexpr std::uint64_t kResidualFrames = 192;
    if (!params_.hold) return 1;
    return static_cast<std::uint64_t>(params_.keepFrames) +
           2 * static_cast<std::uint64_t>(params_.settleFrames) + kResidualFrames;
}

void DepthConditioner::takeTally() {
    while (const auto counts = counters_.take()) {
        ++tally_.frames;
        for (std::size_t i = 0; i < counts->size(); ++i)
            tally_.pixels[i] += (*counts)[i];
        if (!params_.hold) continue;
        tally_.pixels.back() += static_cast<std::uint64_t>(clean_.width()) *
                                static_cast<std::uint64_t>(clean_.height());
        for (const std::size_t other : kNotHeld)
            tally_.pixels.back() -= (*counts)[other];
    }
}

} // namespace autostereo::gpu

#include "gpu/gl/counter_ring.hpp"

#include <utility>

namespace autostereo::gpu::gl {

CounterRing::CounterRing(std::size_t counters)
    : counters_(counters), uncounted_(makeBuffer(counters * sizeof(GLuint), nullptr, 0)) {
    for (Buffer& buffer : buffers_)
        buffer = makeBuffer(counters * sizeof(GLuint), nullptr, 0);
}

CounterRing::~CounterRing() { forget(); }

void CounterRing::forget() {
    for (GLsync& fence : fences_)
        if (fence != nullptr) glDeleteSync(std::exchange(fence, nullptr));
    pending_ = 0;
}

void CounterRing::begin(GLuint binding) {
    counting_ = pending_ < kInFlight;
    const GLuint buffer = counting_ ? buffers_[next_].name() : uncounted_.name();
    glClearNamedBufferData(buffer, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer);
}

void CounterRing::end() {
    if (!counting_) return;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    fences_[next_] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    next_ = (next_ + 1) % kInFlight;
    ++pending_;
}

std::optional<std::vector<std::uint32_t>> CounterRing::take() {
    if (pending_ == 0 || glClientWaitSync(fences_[oldest()], 0, 0) == GL_TIMEOUT_EXPIRED)
        return std::nullopt;
    return readOldest();
}

std::vector<std::uint32_t> CounterRing::waitForOldest() {
    constexpr GLuint64 kForever = 1'000'000'000; // a GPU that takes a second has other trouble
    glClientWaitSync(fences_[oldest()], GL_SYNC_FLUSH_COMMANDS_BIT, kForever);
    return readOldest();
}

std::vector<std::uint32_t> CounterRing::readOldest() {
    const std::size_t slot = oldest();
    glDeleteSync(std::exchange(fences_[slot], nullptr));
    --pending_;
    std::vector<std::uint32_t> counts(counters_);
    glGetNamedBufferSubData(buffers_[slot].name(), 0,
                            static_cast<GLsizeiptr>(counters_ * sizeof(GLuint)), counts.data());
    return counts;
}

} // namespace autostereo::gpu::gl

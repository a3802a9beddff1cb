#include "gpu/gl/timer.hpp"

namespace autostereo::gpu::gl {

Timer::Timer() {
    for (Query& query : queries_) {
        GLuint name = 0;
        glCreateQueries(GL_TIME_ELAPSED, 1, &name);
        query = Query(name);
    }
}

void Timer::begin() {
    measuring_ = pending_ < kInFlight;
    if (measuring_) glBeginQuery(GL_TIME_ELAPSED, queries_[next_].name());
}

std::optional<double> Timer::end() {
    if (measuring_) {
        glEndQuery(GL_TIME_ELAPSED);
        next_ = (next_ + 1) % kInFlight;
        ++pending_;
    }
    if (pending_ == 0) return std::nullopt;
    const GLuint oldest = queries_[(next_ + kInFlight - pending_) % kInFlight].name();
    GLuint ready = 0;
    glGetQueryObjectuiv(oldest, GL_QUERY_RESULT_AVAILABLE, &ready);
    if (ready == GL_FALSE) return std::nullopt;
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(oldest, GL_QUERY_RESULT, &nanoseconds);
    --pending_;
    if (first_) {
        first_ = false;
        return std::nullopt;
    }
    return static_cast<double>(nanoseconds) * 1e-6;
}

} // namespace autostereo::gpu::gl

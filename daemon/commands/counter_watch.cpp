#include "daemon/commands/counter_watch.hpp"

#include "devices/replay/grey_image.hpp"

#include <chrono>
#include <utility>

namespace autostereo::daemon {

CounterWatch::CounterWatch(std::unique_ptr<devices::Source> camera, devices::Reopen reopen,
                           devices::Clock& clock)
    : source_("color", std::move(camera), std::move(reopen), queue_, bell_, clock, {}),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void CounterWatch::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        const std::uint64_t rings = bell_.count();
        if (const auto frame = queue_.take())
            look(*frame);
        else
            bell_.wait(rings, std::chrono::milliseconds(50));
    }
}

void CounterWatch::look(const devices::Frame& frame) {
    const devices::GreyPixels grey = devices::greyOf(frame);
    const calibrate::GreyImage image{grey.width, grey.height, grey.values, false};
    if (!found()) { // only this thread finds it
        auto reader = calibrate::CounterReader::find(image);
        const std::scoped_lock lock(mutex_);
        reader_ = std::move(reader);
        return;
    }
    const auto read = reader_->read(image);
    const std::scoped_lock lock(mutex_);
    if (const auto* number = std::get_if<unsigned>(&read))
        result_.seen.push_back({*number, frame.metadata().capturedAt, frame.metadata().arrivedAt});
    else if (std::get<calibrate::CounterReader::Doubt>(read) ==
             calibrate::CounterReader::Doubt::Changing)
        ++result_.changing;
    else
        ++result_.unseen;
}

bool CounterWatch::found() const {
    const std::scoped_lock lock(mutex_);
    return reader_.has_value();
}

CounterWatch::Result CounterWatch::result() const {
    const std::scoped_lock lock(mutex_);
    return result_;
}

} // namespace autostereo::daemon

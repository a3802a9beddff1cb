#include "daemon/http/question_box.hpp"

#include <algorithm>

namespace autostereo::daemon {

std::optional<ControlReply> QuestionBox::ask(Question question, std::chrono::milliseconds limit) {
    const auto asked = std::make_shared<Asked>(Asked{std::move(question), std::nullopt});
    std::unique_lock lock(mutex_);
    if (closed_) return std::nullopt;
    waiting_.push_back(asked);
    answered_.wait_for(lock, limit, [&] { return closed_ || asked->reply; });
    std::erase(waiting_, asked);
    return std::move(asked->reply);
}

void QuestionBox::close() {
    {
        const std::scoped_lock lock(mutex_);
        closed_ = true;
    }
    answered_.notify_all();
}

std::optional<Question> QuestionBox::take() {
    const std::scoped_lock lock(mutex_);
    if (waiting_.empty()) return std::nullopt;
    taken_ = std::move(waiting_.front());
    waiting_.pop_front();
    return taken_->question;
}

void QuestionBox::answer(ControlReply reply) {
    {
        const std::scoped_lock lock(mutex_);
        if (taken_) taken_->reply = std::move(reply);
        taken_.reset();
    }
    answered_.notify_all();
}

} // namespace autostereo::daemon

#include "daemon/http/question_box.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace autostereo::daemon {
namespace {

using std::chrono::milliseconds;
constexpr milliseconds kLong{60'000};

TEST(QuestionBox, EveryoneGetsTheirOwnAnswer) {
    QuestionBox box;
    std::atomic<int> right{0}, left{0};
    std::vector<std::jthread> askers;
    for (int i = 0; i < 8; ++i)
        askers.emplace_back([&, i] {
            for (int k = 0; k < 100; ++k) {
                const std::string word = std::to_string(i) + '/' + std::to_string(k);
                const auto reply = box.ask(ControlRequest(ShowRequest{word}), kLong);
                right += static_cast<int>(reply && reply->line == word);
            }
            ++left;
        });
    while (left < 8)
        if (const auto question = box.take())
            box.answer({std::get<ShowRequest>(std::get<ControlRequest>(*question)).what});
    EXPECT_EQ(right, 800);
}

TEST(QuestionBox, WhoWaitsTooLongIsForgotten) {
    QuestionBox box;
    EXPECT_FALSE(box.ask(MetricsRequest{}, milliseconds(1)));
    EXPECT_FALSE(box.take());
    box.answer({"nobody's"});
}

TEST(QuestionBox, ClosingSendsEverybodyHome) {
    QuestionBox box;
    std::jthread asker([&] { EXPECT_FALSE(box.ask(MetricsRequest{}, kLong)); });
    while (!box.take())
        std::this_thread::yield();
    box.close();
    asker.join();
    box.answer({"too late"});
    EXPECT_FALSE(box.ask(MetricsRequest{}, kLong));
}

} // namespace
} // namespace autostereo::daemon

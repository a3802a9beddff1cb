// One writer and one reader at full speed. Every element carries its number and a checksum, so a
// torn, repeated or overtaken one is seen; the accounts must balance at the end.
#include "devices/frame_queue.hpp"
#include "tests/stress/campaign.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <iostream>
#include <memory>
#include <random>
#include <thread>

using autostereo::devices::FrameQueue;

namespace {

/// Small, but of several words: a copy while it is written would show.
struct Element {
    explicit Element(std::uint64_t n) : number(n) {
        for (std::size_t i = 0; i < words.size(); ++i)
            words[i] = mixed(n + i);
    }
    static std::uint64_t mixed(std::uint64_t x) { return (x ^ x >> 31) * 0x9e3779b97f4a7c15U; }
    [[nodiscard]] bool whole() const {
        for (std::size_t i = 0; i < words.size(); ++i)
            if (words[i] != mixed(number + i)) return false;
        return true;
    }

    std::uint64_t number;
    std::array<std::uint64_t, 4> words{};
};

/// How often a thread gives way, by chance, so that all fillings of the queue occur. 0: never.
struct Pace {
    unsigned restOneIn;
    void rest(std::mt19937& random) const {
        if (restOneIn != 0 && random() % restOneIn == 0) std::this_thread::yield();
    }
};

/// A busy machine may keep the reader waiting for long; the writer lets it take something at
/// least once in so many elements, else nothing would be tried.
constexpr std::uint64_t kLongestLead = 8192;

struct Seen {
    std::uint64_t taken = 0;
    std::uint64_t torn = 0;
    std::uint64_t disordered = 0;
    std::uint64_t last = 0;

    void look(const Element& element) {
        ++taken;
        torn += element.whole() ? 0 : 1;
        disordered += element.number > last ? 0 : 1;
        last = element.number;
    }
};

template<std::size_t Capacity>
void stress(std::uint64_t elements, Pace writerPace, Pace readerPace) {
    FrameQueue<Element, Capacity> queue;
    std::atomic<bool> done{false};
    std::atomic<std::uint64_t> reached{0};
    std::jthread writer([&] {
        std::mt19937 random(1);
        for (std::uint64_t i = 1; i <= elements; ++i) {
            queue.push(Element(i));
            writerPace.rest(random);
            while (i - reached.load(std::memory_order_relaxed) > kLongestLead)
                std::this_thread::yield();
        }
        done = true;
    });
    std::mt19937 random(2);
    Seen seen;
    while (!done) {
        if (const auto element = queue.take())
            seen.look(*element);
        else
            std::this_thread::yield();
        reached.store(seen.last, std::memory_order_relaxed);
        readerPace.rest(random);
    }
    const std::uint64_t left = queue.size();
    std::uint64_t leftTaken = 0;
    for (; const auto element = queue.take(); ++leftTaken)
        seen.look(*element);

    EXPECT_EQ(seen.torn, 0U);
    EXPECT_EQ(seen.disordered, 0U);
    EXPECT_EQ(seen.last, elements); // the newest always gets through
    EXPECT_EQ(left, leftTaken);
    EXPECT_EQ(queue.pushed(), elements);
    EXPECT_EQ(queue.taken(), seen.taken);
    EXPECT_EQ(queue.pushed(), queue.taken() + queue.dropped());
    EXPECT_GE(queue.taken(), elements / (kLongestLead + Capacity));
    std::cout << "capacity " << Capacity << ": " << queue.pushed() << " pushed, " << queue.taken()
              << " taken, " << queue.dropped() << " dropped\n";
}

using autostereo::test::campaign;

TEST(FrameQueueStress, BothAtFullSpeed) { stress<4>(campaign(10'000'000, 200'000'000), {0}, {0}); }

TEST(FrameQueueStress, OfTheSmallestCapacity) {
    stress<1>(campaign(1'000'000, 50'000'000), {256}, {256});
}

TEST(FrameQueueStress, WriterRests) { stress<3>(campaign(200'000, 10'000'000), {32}, {0}); }

TEST(FrameQueueStress, ReaderRests) { stress<8>(campaign(1'000'000, 50'000'000), {0}, {16}); }

} // namespace

#include "config/opening_hours.hpp"

#include <gtest/gtest.h>

namespace autostereo::config {
namespace {

constexpr int kMon = 0, kThu = 3, kFri = 4, kSat = 5, kSun = 6;

bool opens(const std::string& text, int weekday, int hour, int minute = 0) {
    const auto span = openingSpan(text);
    EXPECT_TRUE(span) << text;
    return span && isOpen({*span}, weekday, 60 * hour + minute);
}

TEST(OpeningHours, BeginWithTheirMinuteAndEndBeforeTheirs) {
    EXPECT_FALSE(opens("mon-fri 09:00-18:00", kMon, 8, 59));
    EXPECT_TRUE(opens("mon-fri 09:00-18:00", kMon, 9));
    EXPECT_TRUE(opens("mon-fri 09:00-18:00", kFri, 17, 59));
    EXPECT_FALSE(opens("mon-fri 09:00-18:00", kFri, 18));
    EXPECT_FALSE(opens("mon-fri 09:00-18:00", kSat, 12));
    EXPECT_TRUE(opens("sat,sun 10:00-16:30", kSun, 16, 29));
    EXPECT_TRUE(opens("daily 00:00-24:00", kThu, 23, 59));
}

TEST(OpeningHours, PassMidnightAndSunday) {
    EXPECT_TRUE(opens("fri 20:00-02:00", kFri, 23));
    EXPECT_TRUE(opens("fri 20:00-02:00", kSat, 1, 59));
    EXPECT_FALSE(opens("fri 20:00-02:00", kSat, 2));
    EXPECT_FALSE(opens("fri 20:00-02:00", kFri, 1)) << "that would be Thursday's night";
    EXPECT_TRUE(opens("sun 22:00-01:00", kMon, 0));
    EXPECT_TRUE(opens("sat-mon 10:00-11:00", kSun, 10));
    EXPECT_FALSE(opens("sat-mon 10:00-11:00", kThu, 10));
}

TEST(OpeningHours, AreAllDayWithoutAnyAndAnyOfSeveral) {
    EXPECT_TRUE(isOpen({}, kThu, 0));
    const std::vector spans{*openingSpan("thu 09:00-12:00"), *openingSpan("thu 13:00-18:00")};
    EXPECT_TRUE(isOpen(spans, kThu, 60 * 11));
    EXPECT_FALSE(isOpen(spans, kThu, 60 * 12 + 30));
    EXPECT_TRUE(isOpen(spans, kThu, 60 * 13));
}

TEST(OpeningHours, OtherTextsAreNone) {
    for (const char* text :
         {"", "mon", "mon 9-18", "mon 09:00", "mon 09:00-18:00 ", "mon 09:00-18:00x",
          "mo 09:00-18:00", "mon- 09:00-18:00", ", 09:00-18:00", "mon, 09:00-18:00",
          "mon 24:00-25:00", "mon 09:60-18:00", "mon 09:00-24:01", "mon 09:00-09:00",
          "mon -9:00-18:00", "mon 09:00--8:00", "mondaymondaymondaymondaymondaymonday 09:00-18:00"})
        EXPECT_FALSE(openingSpan(text)) << text;
}

} // namespace
} // namespace autostereo::config

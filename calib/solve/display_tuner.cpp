#include "calib/solve/display_tuner.hpp"

#include "calib/solve/refusal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace autostereo::calibrate {

namespace {

constexpr int kCoarsest = 0, kFinest = 4; // 10 spans, a thousandth of one

} // namespace

DisplayTuner::DisplayTuner(calib::DisplayProfile display) : display_(std::move(display)) {
    start_ = measuredNumbers(display_);
    if (start_.empty())
        throw Refusal(display_.name + " has no numbers that can be set by eye (type " +
                      display_.type + ")");
    for (DisplayNumber& number : start_) {
        startValues_.push_back(*number.value);
        number.value = nullptr; // of a profile that may move
    }
}

double DisplayTuner::step() const { return start_[number_].span * std::pow(10, 1 - fineness_); }

void DisplayTuner::change(int steps) {
    constexpr std::size_t kRemembered = 10'000;
    if (changes_.size() == kRemembered) changes_.erase(changes_.begin());
    double& value = *measuredNumbers(display_)[number_].value;
    changes_.push_back({number_, value});
    value += steps * step();
}

void DisplayTuner::chooseNext(int by) {
    const int count = static_cast<int>(start_.size());
    number_ = static_cast<std::size_t>(((static_cast<int>(number_) + by) % count + count) % count);
}

void DisplayTuner::refine(int by) { fineness_ = std::clamp(fineness_ + by, kCoarsest, kFinest); }

void DisplayTuner::undo() {
    if (changes_.empty()) return;
    const Change last = changes_.back();
    changes_.pop_back();
    *measuredNumbers(display_)[last.number].value = last.before;
    number_ = last.number;
}

std::vector<MeasuredNumber> DisplayTuner::changed() const {
    calib::DisplayProfile display = display_;
    std::vector<MeasuredNumber> found;
    const auto now = measuredNumbers(display);
    for (std::size_t i = 0; i < now.size(); ++i)
        if (*now[i].value != startValues_[i])
            found.push_back({now[i].table, now[i].key, *now[i].value / now[i].unit, 0});
    return found;
}

std::string DisplayTuner::atHand() const {
    calib::DisplayProfile display = display_;
    const DisplayNumber number = measuredNumbers(display)[number_];
    char text[160];
    std::snprintf(text, sizeof text, "%s.%s %.10g step %.2g", number.table.c_str(),
                  number.key.c_str(), *number.value / number.unit, step() / number.unit);
    return text;
}

} // namespace autostereo::calibrate

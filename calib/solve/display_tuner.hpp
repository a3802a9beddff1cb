#pragma once

#include "calib/solve/display_numbers.hpp"
#include "calib/solve/display_solver.hpp"

#include <string>
#include <vector>

namespace autostereo::calibrate {

/// A display's pitch, slant, offset and fan, set by eye: one number at a time goes up and down in
/// steps of 10 to 0.001 times the change by which a test picture clearly moves
/// (`DisplayNumber::span`): the finest is a thousandth of a lens anywhere on the panel.
class DisplayTuner {
  public:
    /// Throws Refusal: a display without such numbers.
    explicit DisplayTuner(calib::DisplayProfile display);

    /// So many steps up, or down where negative.
    void change(int steps);
    void chooseNext(int by); ///< another number, round and round
    void refine(int by);     ///< steps a tenth as large; negative: larger. Stops at either end
    void undo();             ///< the last change that is left; none: nothing

    [[nodiscard]] const calib::DisplayProfile& display() const { return display_; }
    /// Those that differ from where it began, in their file's unit; by eye no interval is known.
    [[nodiscard]] std::vector<MeasuredNumber> changed() const;
    /// The number at hand: "lens.pitch 52.5 step 0.01".
    [[nodiscard]] std::string atHand() const;

  private:
    struct Change {
        std::size_t number;
        double before; ///< SI
    };
    [[nodiscard]] double step() const; ///< of the number at hand, SI

    calib::DisplayProfile display_;
    std::vector<DisplayNumber> start_; ///< spans and names
    std::vector<double> startValues_;
    std::vector<Change> changes_;
    std::size_t number_ = 0;
    int fineness_ = 1; ///< each is a tenth of the one before
};

} // namespace autostereo::calibrate

#pragma once

#include "gpu/readback.hpp"
#include "tests/oracle/searched_panel.hpp"

namespace autostereo::bench {

/// How far a panel is from the search in double precision, in bands of rows spread over it.
struct Judgement {
    double psnrDb = 0;
    double ssim = 0; ///< mean over 8 x 8 blocks of each channel (Wang 2004, its constants)
    double errMax = 0;
    double badPct = 0;
};

/// What should be seen in some bands of 8 rows; costly, made once for all contenders.
class Judge {
  public:
    Judge(const oracle::SearchInput& in, const oracle::SearchedPanel& panel, int width, int height,
          int bands);
    [[nodiscard]] Judgement judge(const gpu::RgbImage& image) const;

  private:
    static constexpr int kBandRows = 8;
    [[nodiscard]] int firstRow(int band) const;

    int width_, height_, bands_;
    std::vector<double> levels_; ///< band after band, row after row, RGB
};

} // namespace autostereo::bench

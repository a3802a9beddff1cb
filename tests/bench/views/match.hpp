#pragma once

#include "tests/bench/views/contender.hpp"
#include "tests/bench/views/judge.hpp"
#include "tests/bench/views/row.hpp"
#include "tests/support/gl_search_input.hpp"

#include <memory>
#include <string>
#include <vector>

namespace autostereo::bench {

/// One scene on one display.
struct Case {
    std::string scene;   ///< input URI
    std::string display; ///< profile
    int views = 0;       ///< 0: the display's own
    int tileWidth = 512; ///< of each view, unless the display's own
    int tileHeight = 512;
};

/// Every method on one case. Contenders take turns, so that whatever else the machine does meets
/// them all. Needs a context. Throws GlError, DeviceError.
class Match {
  public:
    explicit Match(const Case& wanted);
    /// Rows of every contender, then of what Method::Auto takes for three bounds on the error.
    /// `bands`: of 8 panel rows each that are judged.
    [[nodiscard]] std::vector<Row> run(int rounds, int bands, const std::string& suite);

  private:
    void add(const std::string& name, const FusedInput& input,
             const gpu::SynthesisParams& synthesis, Contender::Part part = Contender::Part::All);
    [[nodiscard]] Judge judge(const oracle::SearchInput& in, int bands,
                              gpu::ViewPositions positions) const;
    [[nodiscard]] Row row(const Contender& contender, const Judge& judge,
                          const std::string& suite) const;
    [[nodiscard]] Row chosen(const std::vector<Row>& rows, double leastDb) const;

    Case case_;
    calib::DisplayProfile display_;
    test::CapturedPair pair_;
    FusedInput full_, half_, quarter_;
    std::vector<std::unique_ptr<Contender>> contenders_;
};

} // namespace autostereo::bench

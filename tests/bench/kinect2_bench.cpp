// What decoding one Kinect v2 frame costs on one core, stage by stage, against the quarter of a
// frame period (8.3 ms) that it may take, and against the straightforward double-precision
// arithmetic on the same frame. Medians. usage: bench_kinect2 [rounds]

#include "devices/kinect2/phase_decoder.hpp"
#include "tests/oracle/kinect2_oracle.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>

namespace {

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own file
using namespace devices::kinect2;

double medianMs(int rounds, const std::function<void()>& work) {
    // The thread's own time: other programs on the machine only disturb its caches.
    const auto nowMs = [] {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
    };
    std::vector<double> times;
    for (int i = 0; i < rounds; ++i) {
        const double start = nowMs();
        work();
        times.push_back(nowMs() - start);
    }
    std::ranges::nth_element(times, times.begin() + rounds / 2);
    return times[static_cast<std::size_t>(rounds / 2)];
}

/// Pixel by pixel with the C library's functions; a 16th of the rows, times 16.
double slowMs(const test::Kinect2Unit& unit, const RawDepthFrame& frame) {
    constexpr int kShare = 16;
    double sum = 0;
    const double ms = medianMs(1, [&] {
        for (int y = 0; y < kHeight; y += kShare)
            for (int x = 1; x + 1 < kWidth; ++x)
                if (const auto phases = oracle::phasesAt(frame, unit, x, y))
                    sum += oracle::bestFit(*phases, unit).path;
    });
    return sum > 0 ? ms * kShare : 0;
}

void print(const char* what, double ms) { std::printf("%-44s %8.2f ms\n", what, ms); }

} // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 100;
    const auto unit = test::inventedUnit();
    std::mt19937_64 random(1);
    const auto scene = [](int x, int y) {
        const double depth = 900 + 300 * ((x / 64 + y / 53) % 8);
        return test::LitPoint{depth, 1.6e9 / (depth * depth)};
    };
    const auto frame = test::expose(unit, scene, 8, random);
    const auto calibration = parsePhasePage(test::phasePage(unit));
    const PhaseDecoder decoder(calibration, parseDepthCameraPage(test::depthCameraPage(unit)));
    const WrapFinder finder(calibration.amplitudeFactors, {}, 0, 30);

    DepthPicture picture;
    PhaseRow phases;
    std::array<WrapRow, 3> wraps;
    ChosenRow chosen;
    std::array<std::int16_t, kWidth> samples{};
    const auto rows = [&](const auto& work) {
        return medianMs(rounds, [&] {
            for (int row = 0; row < kHeight; ++row)
                work(row);
        });
    };
    print("unpacking", rows([&](int row) {
              for (std::size_t i = 0; i < kUsedSubImages; ++i)
                  unpackRow(frame.subImage(i), row, samples);
          }));
    print("unpacking and phases",
          rows([&](int row) { measurePhases(frame, calibration, row, phases); }));
    print("hypotheses", rows([&](int) { finder.find(phases, wraps[0]); }));
    wraps[1] = wraps[2] = wraps[0];
    print("neighbours' support",
          rows([&](int) { chooseWraps(wraps[0], wraps[1], wraps[2], chosen); }));
    const double all = medianMs(rounds, [&] { decoder.decode(frame, picture); });
    print("whole frame, one core", all);
    std::printf("%-44s %8.2f of a frame period (allowed 0.25)\n", "", all / (1000.0 / 30));
    print("straightforward, wraps of each pixel alone", slowMs(unit, frame));
    return 0;
}

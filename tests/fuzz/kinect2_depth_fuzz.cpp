#include "devices/kinect2/depth_packets.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <cstring>
#include <memory>

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

// Each 12 bytes of input are one thing that the wire does: a packet of any size, a good sub-image's
// end with any footer, a loss.

namespace {

using devices::kinect2::DepthPackets;

struct Step {
    std::uint8_t kind;
    std::uint8_t count;
    std::uint16_t size;
    std::uint32_t sequence;
    std::uint32_t subsequence;
};

class Wire {
  public:
    void play(const Step& step) {
        switch (step.kind % 4) {
        case 0:
            return send(std::span(zeros_).first(step.size % (zeros_.size() + 1)), true);
        case 1:
            return send({}, true);
        case 2:
            return send(std::span(zeros_).first(step.size % 2048), false);
        default:
            return sendSubImage(step);
        }
    }

  private:
    void send(std::span<const std::byte> packet, bool intact) {
        if (!packets_.append(packet, intact)) return;
        packets_.swapFrame(frame_);
        fuzz::require(frame_.sequence == lastSequence_, "a frame of another sequence");
    }
    void sendSubImage(const Step& step) {
        constexpr std::size_t kWhole = DepthPackets::kTransferBytes;
        lastSequence_ = step.sequence % 4;
        std::array<std::uint32_t, 6> footer{
            9,
            0,
            1,
            lastSequence_,
            step.subsequence,
            step.count == 7 ? 1U : static_cast<std::uint32_t>(devices::kinect2::kSubImageBytes)};
        std::vector<std::byte> end(DepthPackets::kFooterBytes);
        std::memcpy(end.data(), footer.data(), sizeof footer);
        for (std::size_t left = kWhole - end.size(); left > 0;) {
            const std::size_t part = std::min(left, zeros_.size());
            send(std::span(zeros_).first(part), true);
            left -= part;
        }
        send(end, true);
        if (step.count % 2 == 0) send({}, true);
    }

    std::vector<std::byte> zeros_ = std::vector<std::byte>(33792);
    DepthPackets packets_;
    devices::kinect2::RawDepthFrame frame_;
    std::uint32_t lastSequence_ = 0;
};

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t kMostSteps = 60;
    const auto wire = std::make_unique<Wire>();
    for (std::size_t i = 0; i < std::min(size / sizeof(Step), kMostSteps); ++i) {
        Step step{};
        std::memcpy(&step, data + i * sizeof step, sizeof step);
        wire->play(step);
    }
    return 0;
}

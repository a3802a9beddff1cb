#pragma once

#include "devices/frame_pool.hpp"
#include "devices/replay/jpeg_decoder.hpp"
#include "devices/sequence_counter.hpp"
#include "devices/silence_watch.hpp"
#include "devices/source.hpp"
#include "devices/v4l2/camera_controls.hpp"
#include "devices/v4l2/capture_stream.hpp"

#include <memory>
#include <optional>

namespace autostereo::devices::v4l2 {

/// What outlives a camera that goes away and comes back.
struct Continuity {
    SilenceWatch silence;
    std::uint64_t nextSequence = 0;
    /// How its pictures come to the GPU; none: they are copied.
    std::shared_ptr<PixelSharing> sharing;
};

/// A camera on V4L2 as a source. Frames with the driver's error flag, JPEGs that do not decode and
/// buffers that are too short are dropped and counted as damaged. A camera that is gone, broken or
/// silent is Disconnected: it has to be opened anew. Colour whose bytes are pixels, row after row,
/// is not copied where `sharing` says so, but lent as it lies in the driver's buffer; while too few
/// buffers are left it is copied all the same. Thread-bound.
class V4l2Source final : public Source {
  public:
    V4l2Source(CaptureStream stream, double depthUnitM, const ControlParams& controls,
               std::shared_ptr<Continuity> continuity);

    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override { return false; }
    [[nodiscard]] SourceCounters counters() const noexcept override { return counters_; }
    [[nodiscard]] const CaptureStream& stream() const { return stream_; }

  private:
    [[nodiscard]] ReadResult silent();
    [[nodiscard]] std::optional<Frame> convert(const Captured& captured);
    [[nodiscard]] std::optional<Frame> slot(std::size_t encodedBytes = 0);
    [[nodiscard]] std::optional<Frame> decode(const Captured& captured);
    [[nodiscard]] std::optional<Frame> copy(const Captured& captured);
    [[nodiscard]] std::optional<Frame> lend(const Captured& captured);
    [[nodiscard]] FrameMetadata form() const;
    void begin();
    /// Other buffers, where `sharing` wants them. Throws what using the driver's own again throws.
    void followSharing();
    void lookAtExposure(TimePoint now);

    CaptureStream stream_;
    const KnownFormat& format_;
    double depthUnitM_;
    ControlParams controls_;
    std::shared_ptr<Continuity> continuity_;
    FramePool pool_{kFramesOnTheWay};
    JpegDecoder jpeg_;
    FrameClock clock_;
    SequenceCounter sequence_;
    SourceCounters counters_;
    std::shared_ptr<PixelSharing> sharing_;       ///< none: always copied
    std::shared_ptr<const SharedPixels> invites_; ///< what copied frames carry
    Duration exposure_{0};
    TimePoint askExposureAt_{};
};

} // namespace autostereo::devices::v4l2

#include "daemon/commands/live_boards.hpp"

#include "calib/solve/view_gate.hpp"
#include "daemon/commands/board_gatherer.hpp"
#include "daemon/commands/panel_picture.hpp"
#include "daemon/stop_signal.hpp"
#include "daemon/wiring.hpp"
#include "devices/clock.hpp"

#include <cstdio>

namespace autostereo::daemon {

namespace {

using Verdict = calibrate::ViewGate::Verdict;

/// The colour picture with the corners that were found.
calib::Picture pictureOf(const devices::GreyPixels& grey,
                         const std::optional<calibrate::BoardView>& view) {
    calib::Picture picture{grey.width, grey.height, {}};
    picture.pixels.reserve(4 * grey.values.size());
    for (const std::uint16_t value : grey.values) {
        const auto level = static_cast<std::uint8_t>(value);
        picture.pixels.insert(picture.pixels.end(), {level, level, level, 255});
    }
    if (!view) return picture;
    const int reach = std::max(2, grey.width / 200);
    for (const glm::dvec2& pixel : view->pixels)
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const int u = static_cast<int>(pixel.x) + x, v = static_cast<int>(pixel.y) + y;
                if (u < 0 || v < 0 || u >= grey.width || v >= grey.height) continue;
                constexpr std::array<std::uint8_t, 3> kFound{60, 220, 90};
                std::ranges::copy(kFound, picture.pixels.begin() +
                                              static_cast<std::ptrdiff_t>(picture.offset(u, v)));
            }
    return picture;
}

/// What whoever holds the board sees: the picture, how far it is, what is wanted.
class Guide {
  public:
    Guide(const config::Config& config, std::FILE* terminal) : terminal_(terminal) {
        if (chooseOutput(config) != config::Output::Window) return;
        calib::DisplayProfile display = config::loadDisplay("preview"); // any monitor, flat
        panel_ = openPanel(display, config::Output::Window, false);
    }
    void say(const std::string& text, const devices::GreyPixels& grey,
             const std::optional<calibrate::BoardView>& view) {
        if (text != said_) std::fprintf(terminal_, "%s\n", text.c_str());
        std::fflush(terminal_);
        said_ = text;
        if (!panel_) return;
        drawPicture(*panel_, pictureOf(grey, view));
        drawStrip(*panel_, text);
        panel_->present();
        panel_->pollEvents();
    }
    [[nodiscard]] bool left() const { return panel_ && panel_->closed(); }

  private:
    std::FILE* terminal_;
    std::unique_ptr<gpu::Panel> panel_;
    std::string said_;
};

const char* wordsFor(Verdict verdict) {
    switch (verdict) {
    case Verdict::Take:
        return "taken";
    case Verdict::Moving:
        return "hold still";
    case Verdict::Blurred:
        return "blurred: farther from the camera, more light";
    case Verdict::SeenBefore:
        return "another place or tilt";
    }
    return "";
}

/// Pairs one after the other, until there are enough.
class Watch {
  public:
    Watch(const BoardOptions& options, const calibrate::Board& board, FoundBoards& found)
        : options_(options), board_(board), found_(found), depth_(board, found, true),
          color_(board, found, false) {}

    [[nodiscard]] bool enough() const {
        const std::size_t taken = found_.views.color.size();
        return taken >= 2 * options_.views ||
               (taken >= options_.views && gate_ && !gate_->wanted());
    }

    void look(const devices::RgbdFrame& pair, Guide& guide) {
        const devices::GreyPixels grey = devices::greyOf(pair.color);
        if (!gate_) gate_.emplace(board_, grey.width, grey.height);
        const std::string name = "view " + std::to_string(found_.views.color.size() + 1);
        const auto view = color_.find(grey, name + " (colour)");
        std::string words = "no board";
        if (view) {
            const calibrate::GreyImage image{grey.width, grey.height, grey.values, false};
            const Verdict verdict =
                gate_->judge(*view, stampOf(pair.color), edgeWidth(image, *view, board_));
            if (verdict == Verdict::Take) take(pair, *view, name);
            words = wordsFor(verdict);
        }
        found_.withoutBoard.clear(); // most pictures are taken while nobody holds it
        const auto wanted = gate_->wanted();
        guide.say(std::to_string(found_.views.color.size()) + " of " +
                      std::to_string(options_.views) + ": " + words +
                      (wanted ? "; next: " + *wanted : ""),
                  grey, view);
    }

  private:
    void take(const devices::RgbdFrame& pair, const calibrate::BoardView& view,
              const std::string& name) {
        const auto depthPlace = depth_.lookAtDepth(pair.depth, name);
        const std::size_t colorPlace = color_.take(view, pair.color);
        if (depthPlace) found_.views.pairs.emplace_back(*depthPlace, colorPlace);
    }

    const BoardOptions& options_;
    const calibrate::Board& board_;
    FoundBoards& found_;
    BoardGatherer depth_, color_;
    std::optional<calibrate::ViewGate> gate_;
};

} // namespace

void watchBoards(const BoardOptions& options, const calibrate::Board& board, FoundBoards& found) {
    SceneOptions scene;
    scene.input = options.input;
    const config::Config config = configuration(scene);
    const StopSignal stop;
    devices::SteadyClock clock;
    devices::Input input = openScene(config);
    const bool isLive =
        input.depthIsLive || input.colorIsLive; // of a recording nothing is left out
    const auto speed = isLive ? config::Speed::Realtime : config::Speed::Max;
    const auto feed = openFeed(std::move(input), config, speed, false, clock);
    Guide guide(config, options.json ? stderr : stdout); // figures for machines stay alone
    Watch watch(options, board, found);
    while (!stop.requested() && !guide.left() && !watch.enough() && !feed->ended())
        if (const auto pair = feed->next(std::chrono::milliseconds(100))) watch.look(*pair, guide);
}

} // namespace autostereo::daemon

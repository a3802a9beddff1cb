#pragma once

#include "calib/display_profile.hpp"
#include "calib/sensor_rig.hpp"
#include "config/listen_address.hpp"
#include "config/opening_hours.hpp"
#include "devices/params.hpp"
#include "devices/tracking/params.hpp"
#include "gpu/params.hpp"
#include "gpu/scene/params.hpp"

#include <optional>
#include <string>
#include <vector>

namespace autostereo::config {

enum class Output { Window, Offscreen };
enum class Speed { Realtime, Max };

/// When what the depth budget leaves open follows the scene.
enum class Following { Live, Always, Never };

struct LogParams {
    std::string level = "info"; ///< error, warn, info, debug, trace
};

/// The socket on which a running program is asked and told.
struct ControlParams {
    std::optional<std::string> socket; ///< none: where such sockets lie; "": none is opened
    std::string group;                 ///< its members may, too; "": only root and our own user
};

/// The operator's page.
struct HttpParams {
    std::optional<ListenAddress> listen; ///< none: there is no page
    std::string tokenFile;               ///< empty: nothing that needs the token is allowed

    [[nodiscard]] bool operator==(const HttpParams&) const = default;
};

/// What is shown when the sensors give nothing.
struct IdleParams {
    devices::Duration freeze = std::chrono::seconds(1); ///< so long the last picture stays
    std::string content; ///< file for where there is nothing to say; empty: a plain picture
    std::string startingText = "One moment, please";
    std::string noInputText = "No camera found";
    std::string depthLostText = "The depth camera does not answer";
    std::string colorLostText = "The colour camera does not answer";
    std::string bothLostText = "The cameras do not answer";
    std::string noPairsText = "The cameras do not fit together";
};

/// When nothing is shown though the sensors work.
struct RestParams {
    std::vector<OpeningSpan> hours; ///< none: always open
    double presenceM = 0;           ///< somebody is there who is nearer; 0: nobody is looked for
    double presenceShare = 0.005;   ///< of the depth picture that has to be
    devices::Duration leave = std::chrono::seconds(60); ///< after the last one went
    std::optional<devices::Duration> monitorOff;        ///< after rest began; none: it stays on
};

/// Everything a configuration file can say: all rooms' params together.
struct Config {
    std::string input = "sim:person";
    std::optional<std::string> color; ///< another input's colour; none: the input's own
    std::string display;              ///< profile name or file; empty: preview
    std::optional<std::string> rig;   ///< rig file; none: the input's own calibration
    std::optional<bool> wait;         ///< for an input that is not there; none: in a window
    std::optional<Output> output;     ///< none: window if there is a display, else off-screen
    double refreshHz = 0;             ///< at which an off-screen panel takes pictures; 0: any time
    devices::SyncParams sync;
    devices::ReconnectParams reconnect;
    gpu::PipelineParams pipeline;
    gpu::SceneParams scene;                   ///< of mesh content
    Following depthFollows = Following::Live; ///< decides pipeline.budget.follow, by command
    double brightness = 1;                    ///< of the live panel and its idle picture, 0 to 1
    bool flat = false;                        ///< everything in the panel's plane
    devices::ViewerParams viewer;
    IdleParams idle;
    RestParams rest;
    devices::RingParams ring;
    ControlParams control;
    HttpParams http;
    LogParams log;
};

} // namespace autostereo::config

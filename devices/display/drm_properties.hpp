#pragma once

#include "devices/display/connectors.hpp"
#include "devices/display/link_state.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace autostereo::devices {

/// One property of a kernel display object, with what its value stands for.
struct DrmProperty {
    std::string name;            ///< the kernel's, "Broadcast RGB"
    std::uint64_t value = 0;     ///< number, or bits of a bit mask by the kernel's public numbers
    std::string word;            ///< name of the value where the property is an enumeration
    std::vector<std::byte> blob; ///< contents where it is a blob and one is set
};

/// The way of a picture through a graphics card. Empty lists are fine: then nothing is known.
struct DrmPipe {
    std::string card;      ///< "card0"
    std::string connector; ///< "HDMI-A-1"
    std::vector<DrmProperty> connectorProperties;
    std::vector<DrmProperty> crtcProperties;
    std::vector<DrmProperty> planeProperties; ///< of the primary plane
};

/// What the properties mean; an unknown name or word leaves its field empty. Blobs may hold any
/// bytes: those of a wrong size are taken as unknown. Pure.
[[nodiscard]] LinkState linkStateOf(const DrmPipe& pipe);

/// What cards and the monitor itself tell about the way to a monitor. Pure.
[[nodiscard]] LinkState linkOf(const Connector& monitor, std::span<const DrmPipe> pipes);

} // namespace autostereo::devices

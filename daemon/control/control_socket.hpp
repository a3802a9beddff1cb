#pragma once

#include "devices/unique_fd.hpp"

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/types.h>

namespace autostereo::daemon {

/// One line: what could not be done with which socket, and why.
class ControlError : public std::runtime_error {
  public:
    explicit ControlError(const std::string& what, bool nobodyThere = false)
        : std::runtime_error(what), nobodyThere_(nobodyThere) {}
    [[nodiscard]] bool nobodyThere() const noexcept { return nobodyThere_; }

  private:
    bool nobodyThere_;
};

/// Where a program opens its socket that was told none: control.sock in systemd's runtime folder,
/// else autostereo.sock in XDG_RUNTIME_DIR, else control.sock in /run/autostereo; none where there
/// is no such folder.
[[nodiscard]] std::optional<std::filesystem::path> ownControlSocket();
/// Where one is looked for, the user's own first.
[[nodiscard]] std::vector<std::filesystem::path> knownControlSockets();

/// A socket that listens, mode 0660, non-blocking. One that nobody answers on any more is replaced.
/// `group`: none, or who owns it beside us. Throws ControlError, also where somebody answers.
[[nodiscard]] devices::UniqueFd listenAt(const std::filesystem::path& path,
                                         std::optional<gid_t> group);
/// A connection. Throws ControlError.
[[nodiscard]] devices::UniqueFd connectTo(const std::filesystem::path& path);

/// The number of a group by its name. Throws ControlError.
[[nodiscard]] gid_t groupNamed(const std::string& name);

/// Who is at the other end.
struct Peer {
    uid_t user = 0;
    std::vector<gid_t> groups;
};
/// None where the kernel does not say.
[[nodiscard]] std::optional<Peer> peerOf(int socket);
/// Root, our own user `self`, and members of the group.
[[nodiscard]] bool isAllowed(const Peer& peer, uid_t self, std::optional<gid_t> group);

} // namespace autostereo::daemon

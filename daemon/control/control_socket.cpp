#include "daemon/control/control_socket.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <grp.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

namespace autostereo::daemon {

namespace {

constexpr const char* kServiceFolder = "/run/autostereo";
constexpr mode_t kMode = 0660;
constexpr int kBacklog = 128;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& tried, int cause) {
    throw ControlError("control: cannot " + tried + ' ' + path.string() + ": " +
                           std::strerror(cause),
                       cause == ENOENT || cause == ECONNREFUSED);
}

std::filesystem::path folderIn(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr ? value : "";
}

sockaddr_un addressOf(const std::filesystem::path& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string& name = path.native();
    if (name.empty() || name.size() >= sizeof address.sun_path) fail(path, "use", ENAMETOOLONG);
    std::memcpy(address.sun_path, name.data(), name.size());
    return address;
}

devices::UniqueFd newSocket(const std::filesystem::path& path, int flags) {
    devices::UniqueFd socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | flags, 0));
    if (!socket) fail(path, "make", errno);
    return socket;
}

int bindOnce(const devices::UniqueFd& socket, const sockaddr_un& address) {
    const auto* any = reinterpret_cast<const sockaddr*>(&address);
    return ::bind(socket.get(), any, sizeof address) == 0 ? 0 : errno;
}

/// Nobody may be listening, and it has to be a socket.
void removeStale(const std::filesystem::path& path) {
    struct stat found {};
    if (lstat(path.c_str(), &found) != 0 || !S_ISSOCK(found.st_mode)) fail(path, "open", EEXIST);
    try {
        static_cast<void>(connectTo(path));
    } catch (const ControlError& error) {
        if (!error.nobodyThere()) throw;
        ::unlink(path.c_str());
        return;
    }
    throw ControlError("control: cannot open " + path.string() + ": another program answers there");
}

} // namespace

std::optional<std::filesystem::path> ownControlSocket() {
    if (const auto folder = folderIn("RUNTIME_DIRECTORY"); !folder.empty())
        return folder / "control.sock";
    if (const auto folder = folderIn("XDG_RUNTIME_DIR"); !folder.empty())
        return folder / "autostereo.sock";
    if (::access(kServiceFolder, W_OK) == 0)
        return std::filesystem::path(kServiceFolder) / "control.sock";
    return std::nullopt;
}

std::vector<std::filesystem::path> knownControlSockets() {
    std::vector<std::filesystem::path> places;
    if (const auto folder = folderIn("XDG_RUNTIME_DIR"); !folder.empty())
        places.push_back(folder / "autostereo.sock");
    places.push_back(std::filesystem::path(kServiceFolder) / "control.sock");
    return places;
}

devices::UniqueFd listenAt(const std::filesystem::path& path, std::optional<gid_t> group) {
    const sockaddr_un address = addressOf(path);
    devices::UniqueFd socket = newSocket(path, SOCK_NONBLOCK);
    // Before the name exists: it is never open to more than it will be.
    if (fchmod(socket.get(), kMode) != 0) fail(path, "open", errno);
    int problem = bindOnce(socket, address);
    if (problem == EADDRINUSE) {
        removeStale(path);
        problem = bindOnce(socket, address);
    }
    if (problem != 0) fail(path, "open", problem);
    if (group && ::chown(path.c_str(), static_cast<uid_t>(-1), *group) != 0)
        fail(path, "give to its group", errno);
    if (::chmod(path.c_str(), kMode) != 0) fail(path, "open", errno); // whatever the umask is
    if (::listen(socket.get(), kBacklog) != 0) fail(path, "open", errno);
    return socket;
}

devices::UniqueFd connectTo(const std::filesystem::path& path) {
    const sockaddr_un address = addressOf(path);
    devices::UniqueFd socket = newSocket(path, 0);
    constexpr timeval kPatience{10, 0}; // s; a program that hangs answers nobody
    for (const int way : {SO_SNDTIMEO, SO_RCVTIMEO})
        setsockopt(socket.get(), SOL_SOCKET, way, &kPatience, sizeof kPatience);
    const auto* any = reinterpret_cast<const sockaddr*>(&address);
    if (::connect(socket.get(), any, sizeof address) != 0) fail(path, "reach", errno);
    return socket;
}

gid_t groupNamed(const std::string& name) {
    const struct group* found = ::getgrnam(name.c_str());
    if (found == nullptr) throw ControlError("control.group: there is no group " + name);
    return found->gr_gid;
}

std::optional<Peer> peerOf(int socket) {
    ucred credentials{};
    socklen_t size = sizeof credentials;
    if (getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &credentials, &size) != 0) return std::nullopt;
    Peer peer{credentials.uid, {}};
    size = 0; // asks how many there are
    if (getsockopt(socket, SOL_SOCKET, SO_PEERGROUPS, nullptr, &size) != 0 && errno == ERANGE) {
        peer.groups.resize(size / sizeof(gid_t));
        if (getsockopt(socket, SOL_SOCKET, SO_PEERGROUPS, peer.groups.data(), &size) != 0)
            peer.groups.clear();
    }
    peer.groups.push_back(credentials.gid);
    return peer;
}

bool isAllowed(const Peer& peer, uid_t self, std::optional<gid_t> group) {
    if (peer.user == 0 || peer.user == self) return true;
    return group && std::ranges::find(peer.groups, *group) != peer.groups.end();
}

} // namespace autostereo::daemon

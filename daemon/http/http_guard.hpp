#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace autostereo::daemon {

/// Whether a request's Host is this server by an address in digits or as localhost: a name that a
/// stranger's name server answers for (DNS rebinding) is not. `loopback`: only this machine's own
/// addresses count. Reentrant.
[[nodiscard]] bool isOwnHost(const std::string& host, bool loopback);
/// Whether a page of ours, served under that Host, sent it. Reentrant.
[[nodiscard]] bool isOwnOrigin(const std::string& origin, const std::string& host);

/// The word that opens pictures and controls. Immutable; reentrant.
class HttpToken {
  public:
    /// None is right.
    HttpToken() = default;
    /// The token in a file; where there is none a new one is drawn and written, for its owner only.
    /// Throws ControlError where it cannot be read, is no token, or others may read it.
    explicit HttpToken(const std::filesystem::path& file);

    [[nodiscard]] bool exists() const { return !token_.empty(); }
    /// "Bearer TOKEN"; takes as long for a wrong one as for the right one.
    [[nodiscard]] bool opens(std::string_view authorization) const;

  private:
    std::string token_;
};

/// So many random bytes, as twice as many hexadecimal digits. Throws ControlError.
[[nodiscard]] std::string randomWord(std::size_t bytes);

} // namespace autostereo::daemon

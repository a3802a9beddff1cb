#include "daemon/http/http_guard.hpp"

#include "config/listen_address.hpp"
#include "daemon/control/control_socket.hpp"
#include "devices/unique_fd.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

namespace autostereo::daemon {

namespace {

constexpr std::size_t kShortestToken = 16, kLongestToken = 256, kNewTokenBytes = 32;

std::string lowered(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
    });
    return text;
}

bool isTokenLetter(char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-' || letter == '_';
}

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& why) {
    throw ControlError("http.token_file: cannot use " + file.string() + ": " + why);
}

std::string newToken(const std::filesystem::path& file) {
    std::string token = randomWord(kNewTokenBytes);
    const devices::UniqueFd out(
        ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (!out) fail(file, std::strerror(errno));
    const std::string line = token + '\n';
    if (::write(out.get(), line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
        ::unlink(file.c_str());
        fail(file, "it cannot be written");
    }
    return token;
}

std::string tokenIn(const std::filesystem::path& file, const devices::UniqueFd& in) {
    struct stat found {};
    if (::fstat(in.get(), &found) != 0 || !S_ISREG(found.st_mode)) fail(file, "it is no file");
    if ((found.st_mode & S_IRWXO) != 0)
        fail(file, "everybody may read it (mend with chmod o= " + file.string() + ')');
    std::array<char, kLongestToken + 2> text{}; // one more than fits, and a line's end
    const ssize_t count = ::read(in.get(), text.data(), text.size());
    std::string token(text.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count)));
    while (!token.empty() && std::isspace(static_cast<unsigned char>(token.back())) != 0)
        token.pop_back();
    if (token.size() < kShortestToken || token.size() > kLongestToken ||
        !std::ranges::all_of(token, isTokenLetter))
        fail(file, "it holds no token (allowed 16 to 256 letters, digits, - and _)");
    return token;
}

} // namespace

bool isOwnHost(const std::string& host, bool loopback) {
    const std::string name = lowered(host);
    const bool bracketed = name.starts_with('[');
    const std::size_t colon = name.find(':', bracketed ? name.find(']') : 0);
    const std::string bare = name.substr(0, colon);
    const std::string port = colon == std::string::npos ? ":80" : name.substr(colon);
    const auto address = config::listenAddress((bare == "localhost" ? "127.0.0.1" : bare) + port);
    return address && (address->loopback || !loopback);
}

bool isOwnOrigin(const std::string& origin, const std::string& host) {
    return lowered(origin) == "http://" + lowered(host);
}

HttpToken::HttpToken(const std::filesystem::path& file) {
    const devices::UniqueFd in(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!in && errno != ENOENT) fail(file, std::strerror(errno));
    token_ = in ? tokenIn(file, in) : newToken(file);
}

bool HttpToken::opens(std::string_view authorization) const {
    constexpr std::string_view kScheme = "Bearer ";
    if (token_.empty() || !authorization.starts_with(kScheme)) return false;
    const std::string_view given = authorization.substr(kScheme.size());
    std::size_t differs = given.size() ^ token_.size();
    for (std::size_t i = 0; i < given.size(); ++i)
        differs |= static_cast<std::size_t>(
            static_cast<unsigned char>(given[i] ^ token_[i % token_.size()]));
    return differs == 0;
}

std::string randomWord(std::size_t bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string raw(bytes, '\0'), word;
    if (::getrandom(raw.data(), raw.size(), 0) != static_cast<ssize_t>(bytes))
        throw ControlError("http: the kernel gives no random numbers");
    for (const char byte : raw) {
        word += kDigits[static_cast<unsigned char>(byte) >> 4U];
        word += kDigits[static_cast<unsigned char>(byte) & 15U];
    }
    return word;
}

} // namespace autostereo::daemon

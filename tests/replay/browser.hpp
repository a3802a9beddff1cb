#pragma once

#include "tests/replay/program.hpp"

#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>

namespace autostereo::test {

/// Why there is no browser to drive; none: there is one (Debian: chromium, chromium-driver).
[[nodiscard]] std::optional<std::string> missingBrowser();

/// Chromium without a screen, driven through chromedriver over loopback; it reaches nothing but
/// this machine. Throws std::runtime_error where the driver refuses. Thread-bound.
class Browser {
  public:
    Browser();
    ~Browser();
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;

    /// A screen of so many CSS pixels.
    void resize(int width, int height, bool phone);
    void open(const std::string& address);
    /// What a function body returns.
    nlohmann::json run(const std::string& script,
                       const nlohmann::json& arguments = nlohmann::json::array());
    /// Of the whole page, as a PNG file.
    void screenshot(const std::string& file);
    /// What the page wrote to the console as errors.
    [[nodiscard]] nlohmann::json errors();

  private:
    nlohmann::json post(const std::string& path, const nlohmann::json& body);

    TempFolder folder_;
    std::unique_ptr<RunningProgram> driver_;
    int port_ = 0;
    std::string session_;
};

} // namespace autostereo::test

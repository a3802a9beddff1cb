#pragma once

#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace autostereo::test {

/// The program as on a kiosk: simulated cameras on cables, a configuration, a control socket.
/// Thread-bound.
class Kiosk {
  public:
    /// `config`: more lines of the configuration, tables included; `display`: a display file's text
    /// in place of the small one's.
    explicit Kiosk(const std::string& config = "", const std::string& display = "");

    void plug(const std::string& sensor) const { (void)folder_.file(sensor, ""); }
    void plugBoth() const {
        plug("depth");
        plug("color");
    }
    void unplug(const std::string& sensor) const { std::filesystem::remove(folder_ / sensor); }
    /// It stays, but gives no frame.
    void silence(const std::string& sensor) const { (void)folder_.file(sensor, "silent"); }

    void configure(const std::string& config) const;
    /// Starts it, off-screen on its display; waits until its socket answers.
    void start(std::vector<std::string> more = {}, std::vector<std::string> environment = {});
    /// One command to it: "status", "set" ...
    [[nodiscard]] ProgramResult command(std::vector<std::string> words) const;
    [[nodiscard]] nlohmann::json status() const;
    /// Whether it says so within the time.
    [[nodiscard]] bool shows(const std::string& what, std::chrono::milliseconds limit) const;
    [[nodiscard]] ColorPicture snapshot() const;
    [[nodiscard]] std::string socket() const { return folder_ / "control.sock"; }
    [[nodiscard]] const TempFolder& folder() const { return folder_; }
    [[nodiscard]] RunningProgram& program() { return *program_; }
    /// Asks it to end; what it said.
    [[nodiscard]] ProgramResult stop();

  private:
    TempFolder folder_;
    std::string display_;
    std::unique_ptr<RunningProgram> program_;
};

/// The plain idle picture with these words, of the small panel's size.
[[nodiscard]] ColorPicture plainMessage(const std::string& text);

/// Whether it comes true within the time.
[[nodiscard]] bool eventually(const std::function<bool()>& what, std::chrono::milliseconds limit);

} // namespace autostereo::test

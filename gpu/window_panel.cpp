#include "gpu/window_panel.hpp"

#include "gpu/gl/debug_output.hpp"
#include "gpu/gl/error.hpp"
#include "gpu/gl/lost_context.hpp"

#include <GLFW/glfw3.h>
#include <spdlog/spdlog.h>

#include <cctype>
#include <optional>
#include <span>
#include <utility>

namespace autostereo::gpu {

namespace {

/// Once per process and never undone: GLFW would terminate EGL with it, and Mesa then leaks what
/// its unloaded modules own.
bool startGlfw() { return glfwInit() == GLFW_TRUE; }

std::span<GLFWmonitor*> monitors() {
    int count = 0;
    GLFWmonitor** first = glfwGetMonitors(&count);
    return {first, static_cast<std::size_t>(count)};
}

std::string sizeText(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

/// What GLFW says went wrong.
std::string lastError() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    return reason != nullptr ? reason : "unknown reason";
}

std::optional<KeyPress> keyPressOf(int key, int scancode) {
    using Key = KeyPress::Key;
    switch (key) {
    case GLFW_KEY_LEFT:
        return KeyPress{Key::Left};
    case GLFW_KEY_RIGHT:
        return KeyPress{Key::Right};
    case GLFW_KEY_UP:
        return KeyPress{Key::Up};
    case GLFW_KEY_DOWN:
        return KeyPress{Key::Down};
    case GLFW_KEY_PAGE_UP:
        return KeyPress{Key::PageUp};
    case GLFW_KEY_PAGE_DOWN:
        return KeyPress{Key::PageDown};
    default:
        break;
    }
    const char* name = glfwGetKeyName(key, scancode);
    if (name == nullptr || std::isalpha(static_cast<unsigned char>(name[0])) == 0) return {};
    return KeyPress{Key::Letter,
                    static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])))};
}

void noteKey(GLFWwindow* window, int key, int scancode, int action, int /*modifiers*/) {
    constexpr std::size_t kMost = 256; // nobody takes them
    auto& keys = *static_cast<std::vector<KeyPress>*>(glfwGetWindowUserPointer(window));
    if (action == GLFW_RELEASE) return;
    if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(window, GLFW_TRUE);
    if (keys.size() >= kMost) return;
    if (const auto press = keyPressOf(key, scancode)) keys.push_back(*press);
}

void setHints(const GLFWvidmode& mode, bool debugContext) {
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, debugContext ? GLFW_TRUE : GLFW_FALSE);
    // The current mode exactly: asking for any other would let the monitor scale the sub-pixels.
    glfwWindowHint(GLFW_RED_BITS, mode.redBits);
    glfwWindowHint(GLFW_GREEN_BITS, mode.greenBits);
    glfwWindowHint(GLFW_BLUE_BITS, mode.blueBits);
    glfwWindowHint(GLFW_REFRESH_RATE, mode.refreshRate);
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
}

MonitorInfo infoOf(GLFWmonitor* monitor) {
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    return {glfwGetMonitorName(monitor), mode->width, mode->height, mode->refreshRate};
}

/// Asked to tell when the GPU is reset; a driver that cannot opens no such window.
GLFWwindow* openWindow(const GLFWvidmode& mode, GLFWmonitor* monitor) {
    GLFWwindow* window = nullptr;
    for (const int telling : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {
        glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, telling);
        if (window == nullptr)
            window = glfwCreateWindow(mode.width, mode.height, "autostereo", monitor, nullptr);
    }
    return window;
}

} // namespace

std::vector<MonitorInfo> listMonitors() {
    std::vector<MonitorInfo> found;
    if (!startGlfw()) return found;
    for (GLFWmonitor* monitor : monitors())
        found.push_back(infoOf(monitor));
    return found;
}

WindowPanel::WindowPanel(const MonitorRequest& request, bool debugContext) {
    if (!startGlfw())
        throw DisplayNotFound(
            "window: cannot reach a display server: is DISPLAY or WAYLAND_DISPLAY set?");
    const MonitorChoice choice = chooseMonitor(listMonitors(), request);
    if (!choice.warning.empty()) spdlog::warn("{}", choice.warning);
    GLFWmonitor* monitor = monitors()[choice.index];
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    setHints(*mode, debugContext);
    monitor_ = infoOf(monitor);
    window_ = openWindow(*mode, monitor);
    if (window_ == nullptr) {
        throw GlError("window: cannot open a full-screen OpenGL 4.5 window: " + lastError());
    }
    glfwMakeContextCurrent(window_);
    if (debugContext) gl::logDebugOutput();
    glfwSwapInterval(1);
    glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_HIDDEN);
    glfwSetWindowUserPointer(window_, &keys_);
    glfwSetKeyCallback(window_, noteKey);
    glfwGetFramebufferSize(window_, &width_, &height_);
    if (width_ != mode->width || height_ != mode->height)
        spdlog::warn("window: framebuffer {} on a monitor of {}: the picture is scaled and the "
                     "views will mix; turn off display scaling",
                     sizeText(width_, height_), sizeText(mode->width, mode->height));
    description_ = std::string("window on ") + glfwGetMonitorName(monitor);
}

WindowPanel::~WindowPanel() {
    if (window_ != nullptr) glfwDestroyWindow(window_);
}

// A driver may queue swaps; then the next picture would be chosen while this one still waits for
// its vertical sync, and be that much older when its turn comes.
void WindowPanel::present() {
    glfwSwapBuffers(window_);
    glFinish();
    gl::throwIfReset();
}

void WindowPanel::pollEvents() {
    constexpr auto kBetweenChecks = std::chrono::seconds(1); // each asks the display server
    glfwPollEvents();
    const auto now = std::chrono::steady_clock::now();
    if (now - checkedAt_ < kBetweenChecks) return;
    checkedAt_ = now;
    checkMonitor();
}

void WindowPanel::checkMonitor() const {
    GLFWmonitor* monitor = glfwGetWindowMonitor(window_);
    std::optional<MonitorInfo> is;
    if (monitor != nullptr && glfwGetVideoMode(monitor) != nullptr) is = infoOf(monitor);
    if (const auto change = monitorChange(monitor_, is)) throw PanelLost("window: " + *change);
}

std::vector<KeyPress> WindowPanel::takeKeys() { return std::exchange(keys_, {}); }

bool WindowPanel::closed() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }

void WindowPanel::turnMonitor(bool on) {
    if (!on && !power_.canTurnOff() && !saidCannot_) {
        spdlog::warn("window: the monitor stays on: this display server has no DPMS");
        saidCannot_ = true;
    }
    power_.turn(on);
}

std::optional<GammaRamp> WindowPanel::gammaRamp() const {
    const GLFWgammaramp* ramp = glfwGetGammaRamp(glfwGetWindowMonitor(window_));
    if (ramp == nullptr || ramp->size == 0) return std::nullopt;
    if (ramp->green[ramp->size - 1] == 0) return std::nullopt; // Xwayland's: nobody has set one
    return GammaRamp{{ramp->red, ramp->red + ramp->size},
                     {ramp->green, ramp->green + ramp->size},
                     {ramp->blue, ramp->blue + ramp->size}};
}

} // namespace autostereo::gpu

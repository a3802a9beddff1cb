#include "tests/device/v4l2/vivid.hpp"

#include "devices/v4l2/video_node.hpp"

#include <linux/videodev2.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace autostereo::test {

namespace {

void write(const std::string& file, const std::string& text) {
    std::ofstream stream(file);
    stream << text << std::flush;
    if (!stream) throw std::runtime_error("cannot write to " + file);
}

} // namespace

bool Vivid::there() { return std::filesystem::exists(kDriver); }

void Vivid::set(const std::string& control, std::int64_t value) {
    const devices::v4l2::VideoNode node(kNode);
    constexpr std::uint32_t kNext = V4L2_CTRL_FLAG_NEXT_CTRL | V4L2_CTRL_FLAG_NEXT_COMPOUND;
    v4l2_query_ext_ctrl about{};
    for (about.id = kNext; node.control(VIDIOC_QUERY_EXT_CTRL, about) == 0; about.id |= kNext) {
        if (control != about.name) continue;
        v4l2_ext_control one{};
        one.id = about.id;
        if (about.type == V4L2_CTRL_TYPE_INTEGER64)
            one.value64 = value;
        else
            one.value = static_cast<std::int32_t>(value);
        v4l2_ext_controls all{};
        all.which = V4L2_CTRL_WHICH_CUR_VAL;
        all.count = 1;
        all.controls = &one;
        if (const int error = node.control(VIDIOC_S_EXT_CTRLS, all); error != 0)
            throw std::runtime_error("vivid: cannot set " + control + ": " + std::to_string(error));
        return;
    }
    throw std::runtime_error("vivid: no control " + control);
}

void Vivid::reset() {
    if (!std::filesystem::exists(kNode)) { // somebody held it when it came back: another number
        unbind();
        bind();
    }
    set("Test Pattern", 0);  // 75 % colour bars
    set("OSD Text Mode", 2); // none
    set("Percentage of Dropped Buffers", 0);
    set("Wrap Sequence Number", 0);
    set("Wrap Timestamp", 0);
}

void Vivid::unbind() { write(std::string(kDriver) + "unbind", "vivid.0"); }
void Vivid::bind() { write(std::string(kDriver) + "bind", "vivid.0"); }

} // namespace autostereo::test

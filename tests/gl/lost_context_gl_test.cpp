// A GPU that is reset on purpose takes every other program's pictures with it, and the software
// renderer has none: the driver's answer is replaced here.

#include "gpu/gl/error.hpp"
#include "gpu/offscreen_panel.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {
GLenum answer = GL_NO_ERROR;
} // namespace

extern "C" GLenum APIENTRY glGetGraphicsResetStatus() { return answer; }

namespace autostereo::gpu {
namespace {

std::string messageOf(Panel& panel, GLenum status) {
    answer = status;
    try {
        panel.present();
    } catch (const PanelLost& lost) {
        answer = GL_NO_ERROR;
        return lost.what();
    }
    answer = GL_NO_ERROR;
    return "";
}

TEST(LostContext, EndsWhereThePictureIsPresented) {
    OffscreenPanel panel(16, 16, true);
    EXPECT_EQ(messageOf(panel, GL_NO_ERROR), "");
    EXPECT_EQ(messageOf(panel, GL_GUILTY_CONTEXT_RESET),
              "gl: the GPU was reset over what this program gave it to do");
    EXPECT_EQ(messageOf(panel, GL_INNOCENT_CONTEXT_RESET),
              "gl: the GPU was reset over another program");
    EXPECT_EQ(messageOf(panel, GL_UNKNOWN_CONTEXT_RESET), "gl: the GPU was reset");
    EXPECT_EQ(messageOf(panel, GL_NO_ERROR), "");
}

} // namespace
} // namespace autostereo::gpu

#pragma once

#include "gpu/gl/context.hpp"
#include "gpu/gl/debug_output.hpp"
#include "gpu/gl/error.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace autostereo::test {

/// A test with an OpenGL context of its own; any GL error or undefined behaviour that the driver
/// reports fails it. Without a driver it is skipped, in CI (AUTOSTEREO_REQUIRE=gl) it fails.
class GlTest : public testing::Test {
  protected:
    void SetUp() override {
        try {
            context_ = std::make_unique<gpu::gl::SurfacelessContext>(true);
        } catch (const gpu::GlError& error) {
            if (required("gl")) FAIL() << error.what();
            GTEST_SKIP() << error.what();
        }
        errorsBefore_ = gpu::gl::debugErrorCount();
    }
    void TearDown() override {
        EXPECT_EQ(gpu::gl::debugErrorCount(), errorsBefore_) << "the GL driver complained";
    }

    /// For tests that provoke an error on purpose.
    void forgiveErrors() { errorsBefore_ = gpu::gl::debugErrorCount(); }

  private:
    std::unique_ptr<gpu::gl::SurfacelessContext> context_;
    std::uint64_t errorsBefore_ = 0;
};

} // namespace autostereo::test

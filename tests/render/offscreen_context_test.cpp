// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/offscreen_context.h"

#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

/// Ends the process with 5 and the message when the renderer is refused, as the program does.
[[noreturn]] void try_renderer_with(const char* variable, const char* value) {
  setenv("HYDROSCOPE_RENDERER", "osmesa", 1);
  setenv(variable, value, 1);
  try {
    std::fprintf(stderr, "accepted: %s\n", describe_renderer().c_str());
    std::exit(0);
  } catch (const EnvironmentError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::exit(5);
  }
}

// A process of its own each: the library is opened once a process.
class RendererAtStart : public testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};
using RendererAtStartDeathTest = RendererAtStart;

TEST_F(RendererAtStartDeathTest, AMissingLibraryIsAReadableError) {
  EXPECT_EXIT(try_renderer_with("HYDROSCOPE_OSMESA", "/nowhere/libOSMesa.so.8"), testing::ExitedWithCode(5),
              "cannot use the software renderer /nowhere/libOSMesa.so.8.*libosmesa6");
}

TEST_F(RendererAtStartDeathTest, ABrokenLibraryIsAReadableError) {
  EXPECT_EXIT(try_renderer_with("HYDROSCOPE_OSMESA", "/etc/passwd"), testing::ExitedWithCode(5),
              "invalid ELF header");
}

TEST_F(RendererAtStartDeathTest, ALibraryThatIsNoOSMesaIsAReadableError) {
  EXPECT_EXIT(try_renderer_with("HYDROSCOPE_OSMESA", "libz.so.1"), testing::ExitedWithCode(5),
              "no function OSMesaCreateContextAttribs");
}

TEST_F(RendererAtStartDeathTest, AnUnknownWayIsAReadableError) {
  EXPECT_EXIT(try_renderer_with("HYDROSCOPE_RENDERER", "vulkan"), testing::ExitedWithCode(5),
              "HYDROSCOPE_RENDERER is 'vulkan'; there are osmesa and egl");
}

TEST_F(RendererAtStartDeathTest, SoftpipeIsRefused) {
  EXPECT_EXIT(try_renderer_with("GALLIUM_DRIVER", "softpipe"), testing::ExitedWithCode(5), "softpipe");
}

TEST(Renderer, NamesItselfAfterItsSelfTest) {
  EXPECT_THAT(describe_renderer(), testing::HasSubstr("llvmpipe"));
  EXPECT_THAT(describe_renderer(), testing::HasSubstr("OpenGL"));
}

TEST(Renderer, OnlyKnownOnesAreTrusted) {
  EXPECT_TRUE(is_trusted_renderer("llvmpipe (LLVM 15.0.6, 256 bits)"));
  EXPECT_FALSE(is_trusted_renderer("softpipe"));
  EXPECT_FALSE(is_trusted_renderer("Mesa Intel(R) Graphics"));
  EXPECT_FALSE(is_trusted_renderer(""));
}

}  // namespace
}  // namespace hydroscope

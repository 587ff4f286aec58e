#include "platform/egl_headless/reset_status.hpp"

#include <gtest/gtest.h>

#include <EGL/egl.h>
#include <string>

#include "platform/egl_headless/egl_headless_surface.hpp"

namespace tedavis::platform::test_reset_status {
namespace {

/// A driver as a test says it is.
std::string extensions;
unsigned answer = 0;
int asked = 0;

const unsigned char* get_string(unsigned name) {
    return name == 0x1F03 ? reinterpret_cast<const unsigned char*>(extensions.c_str()) : nullptr;
}
unsigned khr_status() {
    ++asked;
    return answer;
}
unsigned ext_status() {
    asked += 100;
    return answer;
}

using Procedure = void (*)();
Procedure proc_address(const char* name) {
    const std::string asked_for = name;
    if (asked_for == "glGetString") return reinterpret_cast<Procedure>(&get_string);
    if (asked_for == "glGetGraphicsResetStatusKHR") return reinterpret_cast<Procedure>(&khr_status);
    return asked_for == "glGetGraphicsResetStatusEXT" ? reinterpret_cast<Procedure>(&ext_status) : nullptr;
}

ResetStatus status_of(const std::string& driver_extensions) {
    extensions = driver_extensions;
    answer = 0;
    asked = 0;
    ResetStatus status;
    status.find(&proc_address);
    return status;
}

TEST(ResetStatus, TellsThatTheContextIsLost) {
    const ResetStatus status = status_of("GL_OES_depth24 GL_KHR_robustness GL_EXT_robustness");
    EXPECT_TRUE(status.can_tell());
    EXPECT_FALSE(status.is_lost());
    for (const unsigned reset : {0x8253u, 0x8254u, 0x8255u}) {  // guilty, innocent, unknown
        answer = reset;
        EXPECT_TRUE(status.is_lost()) << reset;
    }
    EXPECT_EQ(asked, 4) << "by the newer of both extensions";
}

TEST(ResetStatus, AsksByTheExtensionThatTheDriverHas) {
    const ResetStatus older = status_of("GL_EXT_robustness");
    EXPECT_FALSE(older.is_lost());
    EXPECT_EQ(asked, 100);
    const ResetStatus without = status_of("GL_KHR_robustness_of_others GL_OES_depth24");
    answer = 0x8253;
    EXPECT_FALSE(without.can_tell()) << "Mesa hands out a function for any name: only the extension proves it";
    EXPECT_FALSE(without.is_lost());
    EXPECT_EQ(asked, 0);
}

/// The driver of this machine, whose context nothing has reset.
TEST(ResetStatus, AContextThatWorksIsNotLost) {
    SurfaceSettings settings;
    settings.width_px = settings.height_px = 16;
    auto surface = make_egl_headless_surface(settings);
    ASSERT_TRUE(surface.ok());
    ASSERT_TRUE(surface.value()->make_current());
    ResetStatus status;
    status.find(&eglGetProcAddress);
    EXPECT_FALSE(status.is_lost());
    EXPECT_EQ(surface.value()->present(), base::SurfaceState::ready);
}

}  // namespace
}  // namespace tedavis::platform::test_reset_status

#include "platform/egl_headless/reset_status.hpp"

#include "platform/egl_headless/egl_display.hpp"

namespace tedavis::platform {
namespace {

constexpr unsigned kExtensions = 0x1F03;  // GL_EXTENSIONS, of glGetString()
constexpr unsigned kNoError = 0;

}  // namespace

void ResetStatus::find(ProcAddress proc_address) {
    using GetString = const unsigned char* (*)(unsigned);
    status_ = nullptr;
    const auto get_string = reinterpret_cast<GetString>(proc_address("glGetString"));
    if (get_string == nullptr) return;
    const char* const extensions = reinterpret_cast<const char*>(get_string(kExtensions));
    const char* name = nullptr;
    if (has_egl_extension(extensions, "GL_KHR_robustness"))
        name = "glGetGraphicsResetStatusKHR";
    else if (has_egl_extension(extensions, "GL_EXT_robustness"))
        name = "glGetGraphicsResetStatusEXT";
    if (name != nullptr) status_ = reinterpret_cast<unsigned (*)()>(proc_address(name));
}

bool ResetStatus::is_lost() const { return status_ != nullptr && status_() != kNoError; }

}  // namespace tedavis::platform

/// Asks the driver whether the graphics processor was reset, which loses everything that a context holds: what is drawn then is
/// undefined, and EGL need not say so where nothing is swapped.
///
/// Source  GL_KHR_robustness and GL_EXT_robustness, GetGraphicsResetStatus. Thread  the context's.
#pragma once

namespace tedavis::platform {

class ResetStatus {
public:
    using ProcAddress = void (*(*)(const char*))();  ///< as eglGetProcAddress

    /// Looks the question up in the current context; a driver without it is never asked.
    void find(ProcAddress proc_address);
    /// The context was lost since it was made. Where it was, a new one is needed.
    [[nodiscard]] bool is_lost() const;
    [[nodiscard]] bool can_tell() const { return status_ != nullptr; }

private:
    unsigned (*status_)() = nullptr;
};

}  // namespace tedavis::platform

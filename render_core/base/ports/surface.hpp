/// What the core needs to draw into: a current GL ES context with a default framebuffer. Implemented in platform/.
///
/// One surface is current per thread; release it before another is made current.
#pragma once

#include <cstdint>

namespace tedavis::base {

enum class SurfaceState : std::uint8_t { ready, context_lost, failed };

class Surface {
public:
    virtual ~Surface() = default;
    [[nodiscard]] virtual std::uint32_t width() const = 0;
    [[nodiscard]] virtual std::uint32_t height() const = 0;
    [[nodiscard]] virtual bool make_current() = 0;
    virtual void release_current() = 0;
    /// Address of a GL entry point of the current context; null for none. Non-null proves nothing (Mesa hands out
    /// stubs for unknown names): decide by version and extension string.
    [[nodiscard]] virtual void* proc_address(const char* name) = 0;
    /// Shows or completes what was drawn.
    [[nodiscard]] virtual SurfaceState present() = 0;
    /// The framebuffer object to draw into; 0 is the default one.
    [[nodiscard]] virtual std::uint32_t framebuffer() const { return 0; }
    /// "osmesa", "egl", "window", "kms": recorded with every run.
    [[nodiscard]] virtual const char* backend_name() const = 0;
};

}  // namespace tedavis::base

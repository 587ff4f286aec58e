/// Port: the surface that the core draws into, a current GL ES context with a default framebuffer. Implemented in platform/.
///
/// At most one surface is current per thread; release it before making another current.
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
    /// Returns the address of a GL entry point of the current context, or null. A non-null address does not prove that the
    /// function exists (Mesa returns stubs for unknown names): check version and extension string.
    [[nodiscard]] virtual void* proc_address(const char* name) = 0;
    /// Presents the frame on a screen, or completes it off-screen.
    [[nodiscard]] virtual SurfaceState present() = 0;
    /// The framebuffer object to draw into; 0 is the default one.
    [[nodiscard]] virtual std::uint32_t framebuffer() const { return 0; }
    /// Returns "osmesa", "egl", "window" or "kms"; recorded with every run.
    [[nodiscard]] virtual const char* backend_name() const = 0;
};

}  // namespace tedavis::base

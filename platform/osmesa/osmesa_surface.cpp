#include "platform/osmesa/osmesa_surface.hpp"

#if defined(TEDAVIS_HAVE_OSMESA)

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <new>

#include "platform/current_surface.hpp"
#include "render_core/base/driver_scope.hpp"

namespace tedavis::platform {
namespace {

struct OsmesaLibrary {
    decltype(&OSMesaCreateContextAttribs) create = nullptr;
    decltype(&OSMesaDestroyContext) destroy = nullptr;
    decltype(&OSMesaMakeCurrent) make_current = nullptr;
    decltype(&OSMesaGetProcAddress) proc_address = nullptr;

    [[nodiscard]] bool complete() const {
        return create != nullptr && destroy != nullptr && make_current != nullptr && proc_address != nullptr;
    }
};

template <class Function>
void find(void* library, const char* name, Function& out) {
    out = reinterpret_cast<Function>(dlsym(library, name));
}

/// Loaded once and kept: Mesa does not survive being unloaded.
OsmesaLibrary load_library() {
    const base::DriverScope driver;
    OsmesaLibrary found;
    void* library = nullptr;
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"})
        if (library == nullptr) library = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (library == nullptr) return found;
    find(library, "OSMesaCreateContextAttribs", found.create);
    find(library, "OSMesaDestroyContext", found.destroy);
    find(library, "OSMesaMakeCurrent", found.make_current);
    find(library, "OSMesaGetProcAddress", found.proc_address);
    return found;
}

class OsmesaSurface final : public base::Surface {
public:
    OsmesaSurface(const OsmesaLibrary& library, const SurfaceSettings& settings) : library_(library), settings_(settings) {}
    ~OsmesaSurface() override {
        release_current();
        const base::DriverScope driver;
        if (context_ != nullptr) library_.destroy(context_);
    }
    OsmesaSurface(const OsmesaSurface&) = delete;
    OsmesaSurface& operator=(const OsmesaSurface&) = delete;

    [[nodiscard]] bool create() {
        const base::DriverScope driver;
        pixels_.reset(new (std::nothrow) unsigned char[std::size_t{4} * settings_.width_px * settings_.height_px]());
        constexpr int kAttributes[] = {OSMESA_FORMAT,
                                       OSMESA_RGBA,
                                       OSMESA_DEPTH_BITS,
                                       24,
                                       OSMESA_STENCIL_BITS,
                                       8,
                                       OSMESA_PROFILE,
                                       OSMESA_COMPAT_PROFILE,
                                       OSMESA_CONTEXT_MAJOR_VERSION,
                                       2,
                                       OSMESA_CONTEXT_MINOR_VERSION,
                                       1,
                                       0};
        context_ = library_.create(kAttributes, nullptr);
        return pixels_ != nullptr && context_ != nullptr;
    }

    std::uint32_t width() const override { return settings_.width_px; }
    std::uint32_t height() const override { return settings_.height_px; }

    bool make_current() override {
        if (!claim_current(this)) return false;
        const base::DriverScope driver;
        const auto columns = static_cast<GLsizei>(settings_.width_px);
        const auto rows = static_cast<GLsizei>(settings_.height_px);
        if (library_.make_current(context_, pixels_.get(), GL_UNSIGNED_BYTE, columns, rows) == GL_TRUE) return true;
        drop_current(this);
        return false;
    }

    void release_current() override {
        if (!is_current(this)) return;
        const base::DriverScope driver;
        library_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        drop_current(this);
    }

    void* proc_address(const char* name) override {
        const base::DriverScope driver;
        return reinterpret_cast<void*>(library_.proc_address(name));
    }

    base::SurfaceState present() override {
        if (!is_current(this)) return base::SurfaceState::failed;
        if (finish_ == nullptr) finish_ = reinterpret_cast<Finish>(proc_address("glFinish"));
        if (finish_ == nullptr) return base::SurfaceState::failed;
        const base::DriverScope driver;
        finish_();
        return base::SurfaceState::ready;
    }

    const char* backend_name() const override { return "osmesa"; }

private:
    using Finish = void (*)();
    OsmesaLibrary library_;
    SurfaceSettings settings_;
    std::unique_ptr<unsigned char[]> pixels_;
    OSMesaContext context_ = nullptr;
    Finish finish_ = nullptr;
};

}  // namespace

base::Result<std::unique_ptr<base::Surface>, base::Error> make_osmesa_surface(const SurfaceSettings& settings) {
    static const OsmesaLibrary library = load_library();
    if (!library.complete())
        return base::fail(base::make_error("libOSMesa is not on this machine; install libosmesa6 or use --gl egl"));
    std::unique_ptr<OsmesaSurface> surface(new (std::nothrow) OsmesaSurface(library, settings));
    if (surface == nullptr || !surface->create())
        return base::fail(base::make_error("libOSMesa gives no context with 24-bit depth; use --gl egl"));
    return std::unique_ptr<base::Surface>(std::move(surface));
}

}  // namespace tedavis::platform

#else

namespace tedavis::platform {

base::Result<std::unique_ptr<base::Surface>, base::Error> make_osmesa_surface(const SurfaceSettings&) {
    return base::fail(base::make_error("this build has no OSMesa; install libosmesa6-dev and build again, or use --gl egl"));
}

}  // namespace tedavis::platform

#endif

#include "platform/surface_factory.hpp"

#include "platform/egl_headless/egl_headless_surface.hpp"
#include "platform/osmesa/osmesa_surface.hpp"

namespace tedavis::platform {

base::Result<std::unique_ptr<base::Surface>, base::Error> make_surface(std::string_view backend,
                                                                       const SurfaceSettings& settings) {
    if (!size_is_possible(settings))
        return base::fail(base::make_error("the picture's edges must be 16 to 16384 pixels; give such a --size"));
    if (backend == "egl") return make_egl_headless_surface(settings);
    if (backend == "osmesa") return make_osmesa_surface(settings);
    return base::fail(base::make_error("the surface '", backend, "' is not known; use egl or osmesa"));
}

}  // namespace tedavis::platform

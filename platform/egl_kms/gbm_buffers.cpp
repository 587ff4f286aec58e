#include "platform/egl_kms/gbm_buffers.hpp"

#if defined(TEDAVIS_HAVE_KMS)

#include <drm_fourcc.h>

#include "render_core/base/driver_scope.hpp"

namespace tedavis::platform {
namespace {

ScanoutBuffer description(gbm_bo* buffer) {
    ScanoutBuffer described;
    described.token = buffer;
    described.width_px = gbm_bo_get_width(buffer);
    described.height_px = gbm_bo_get_height(buffer);
    described.format = gbm_bo_get_format(buffer);
    described.modifier = gbm_bo_get_modifier(buffer);
    described.has_modifier = described.modifier != DRM_FORMAT_MOD_INVALID;
    const int planes = gbm_bo_get_plane_count(buffer);
    described.planes = static_cast<std::uint32_t>(planes < 0 ? 0 : planes > 4 ? 4 : planes);
    for (int n = 0; n < static_cast<int>(described.planes); ++n) {
        described.handles[n] = gbm_bo_get_handle_for_plane(buffer, n).u32;
        described.strides[n] = gbm_bo_get_stride_for_plane(buffer, n);
        described.offsets[n] = gbm_bo_get_offset(buffer, n);
    }
    return described;
}

}  // namespace

GbmBuffers::~GbmBuffers() { close(); }

void GbmBuffers::close() {
    const base::DriverScope driver;
    if (surface_ != nullptr) gbm_surface_destroy(surface_);
    if (device_ != nullptr) gbm_device_destroy(device_);
    surface_ = nullptr;
    device_ = nullptr;
}

base::Error GbmBuffers::open(DrmCard& card, std::uint32_t width_px, std::uint32_t height_px) {
    const base::DriverScope driver;
    device_ = gbm_create_device(card.descriptor());
    if (device_ == nullptr)
        return base::make_error("GBM does not know this graphics card; install its GL driver (libgl1-mesa-dri)");
    const FormatModifiers& modifiers = card.modifiers();
    if (can_show(card, width_px, height_px))
        surface_ = gbm_surface_create_with_modifiers(device_, width_px, height_px, GBM_FORMAT_XRGB8888, modifiers.data(),
                                                     static_cast<unsigned>(modifiers.size()));
    if (surface_ == nullptr)
        surface_ =
            gbm_surface_create(device_, width_px, height_px, GBM_FORMAT_XRGB8888, GBM_BO_USE_SCANOUT | GBM_BO_USE_RENDERING);
    if (surface_ == nullptr) return base::make_error("GBM gives no buffers of this size; use a smaller mode of [screen]");
    return {};
}

/// Whether a buffer with the card's layouts can be made and shown: some kernels name layouts that they then refuse.
bool GbmBuffers::can_show(DrmCard& card, std::uint32_t width_px, std::uint32_t height_px) const {
    const FormatModifiers& modifiers = card.modifiers();
    if (modifiers.empty()) return false;
    gbm_bo* const buffer = gbm_bo_create_with_modifiers(device_, width_px, height_px, GBM_FORMAT_XRGB8888, modifiers.data(),
                                                        static_cast<unsigned>(modifiers.size()));
    if (buffer == nullptr) return false;
    std::uint32_t framebuffer = 0;
    const bool accepted = card.add_framebuffer(description(buffer), framebuffer);
    if (accepted) card.remove_framebuffer(framebuffer);
    gbm_bo_destroy(buffer);
    return accepted;
}

bool GbmBuffers::lock_front(ScanoutBuffer& buffer) {
    const base::DriverScope driver;
    gbm_bo* const front = gbm_surface_lock_front_buffer(surface_);
    if (front == nullptr) return false;
    buffer = description(front);
    if (gbm_bo_get_user_data(front) == nullptr) gbm_bo_set_user_data(front, this, &GbmBuffers::buffer_ends);
    return true;
}

void GbmBuffers::release(void* token) {
    const base::DriverScope driver;
    gbm_surface_release_buffer(surface_, static_cast<gbm_bo*>(token));
}

void GbmBuffers::on_end_of_buffer(void (*forget)(void* self, void* token), void* self) {
    forget_ = forget;
    owner_ = self;
}

void GbmBuffers::buffer_ends(gbm_bo* buffer, void* self) {
    const auto* const buffers = static_cast<const GbmBuffers*>(self);
    if (buffers->forget_ != nullptr) buffers->forget_(buffers->owner_, buffer);
}

}  // namespace tedavis::platform

#endif

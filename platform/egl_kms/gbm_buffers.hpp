/// The buffers that EGL draws into and a screen shows (GBM), in XRGB8888.
///
/// Thread  one. Memory  the driver's. Failure  one sentence at open().
#pragma once

#if defined(TEDAVIS_HAVE_KMS)

#include <gbm.h>

#include "platform/egl_kms/drm_card.hpp"
#include "render_core/base/error.hpp"

namespace tedavis::platform {

class GbmBuffers final : public BufferQueue {
public:
    GbmBuffers() = default;
    ~GbmBuffers() override;
    GbmBuffers(const GbmBuffers&) = delete;
    GbmBuffers& operator=(const GbmBuffers&) = delete;

    /// With the layouts that the card names where a buffer of these can be made and shown, else as the driver likes. The card
    /// must outlive the buffers.
    [[nodiscard]] base::Error open(DrmCard& card, std::uint32_t width_px, std::uint32_t height_px);
    [[nodiscard]] gbm_device* device() const { return device_; }
    [[nodiscard]] gbm_surface* surface() const { return surface_; }
    /// Ends the buffers, none of which may be locked; what drew into them must have ended before.
    void close();

    bool lock_front(ScanoutBuffer& buffer) override;
    void release(void* token) override;
    void on_end_of_buffer(void (*forget)(void* self, void* token), void* self) override;

private:
    [[nodiscard]] bool can_show(DrmCard& card, std::uint32_t width_px, std::uint32_t height_px) const;
    static void buffer_ends(gbm_bo* buffer, void* self);

    gbm_device* device_ = nullptr;
    gbm_surface* surface_ = nullptr;
    void (*forget_)(void* self, void* token) = nullptr;
    void* owner_ = nullptr;
};

}  // namespace tedavis::platform

#endif

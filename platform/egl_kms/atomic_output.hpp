/// One connector of a card, driven by atomic commits: each either happens whole or not at all.
///
/// Thread  one. Memory  libdrm's. Failure  false, with the reason in errno.
#pragma once

#if defined(TEDAVIS_HAVE_KMS)

#include <xf86drmMode.h>

#include <cstdint>

#include "render_core/base/fixed_vector.hpp"

namespace tedavis::platform {

using FormatModifiers = base::FixedVector<std::uint64_t, 64>;

class AtomicOutput {
public:
    AtomicOutput() = default;
    ~AtomicOutput() { close(); }
    /// To be called before the card is closed.
    void close();
    AtomicOutput(const AtomicOutput&) = delete;
    AtomicOutput& operator=(const AtomicOutput&) = delete;

    /// False where the card knows no atomic commits, or lacks what they need. `card` is an open file, and stays the caller's.
    [[nodiscard]] bool open(int card, std::uint32_t connector, std::uint32_t crtc, std::uint32_t crtc_index,
                            const drmModeModeInfo& mode);
    /// How the card's buffers of XRGB8888 may lie in memory; empty where it does not say.
    [[nodiscard]] const FormatModifiers& modifiers() const { return modifiers_; }

    [[nodiscard]] bool set_mode(std::uint32_t framebuffer);
    [[nodiscard]] bool flip(std::uint32_t framebuffer, std::uint32_t cookie);
    [[nodiscard]] bool turn_off();

private:
    /// Properties by which a commit says what it wants.
    struct Ids {
        std::uint32_t connector_crtc = 0, crtc_mode = 0, crtc_active = 0;
        std::uint32_t plane_framebuffer = 0, plane_crtc = 0;
        std::uint32_t source_x = 0, source_y = 0, source_width = 0, source_height = 0;
        std::uint32_t x = 0, y = 0, width = 0, height = 0;
    };

    [[nodiscard]] bool find_plane(std::uint32_t crtc_index);
    [[nodiscard]] bool is_primary(std::uint32_t plane) const;
    [[nodiscard]] bool find_properties();
    void read_modifiers();
    void add(std::uint32_t object, std::uint32_t property, std::uint64_t value);
    void add_plane(std::uint32_t framebuffer);
    [[nodiscard]] bool commit(std::uint32_t flags, std::uint32_t cookie);

    int card_ = -1;
    std::uint32_t connector_ = 0, crtc_ = 0, plane_ = 0, mode_blob_ = 0;
    std::uint32_t width_px_ = 0, height_px_ = 0;
    Ids ids_;
    FormatModifiers modifiers_;
    drmModeAtomicReq* request_ = nullptr;
};

}  // namespace tedavis::platform

#endif

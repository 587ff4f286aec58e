#include "platform/egl_kms/atomic_output.hpp"

#if defined(TEDAVIS_HAVE_KMS)

#include <drm_fourcc.h>
#include <xf86drm.h>

#include <cstring>

namespace tedavis::platform {
namespace {

/// Calls `visit(name, id, value)` for each property of an object.
template <class Visit>
void for_each_property(int card, std::uint32_t object, std::uint32_t type, Visit visit) {
    drmModeObjectProperties* const all = drmModeObjectGetProperties(card, object, type);
    if (all == nullptr) return;
    for (std::uint32_t n = 0; n < all->count_props; ++n) {
        drmModePropertyRes* const property = drmModeGetProperty(card, all->props[n]);
        if (property == nullptr) continue;
        visit(static_cast<const char*>(property->name), property->prop_id, all->prop_values[n]);
        drmModeFreeProperty(property);
    }
    drmModeFreeObjectProperties(all);
}

struct WantedProperty {
    const char* name;
    std::uint32_t* id;
};

template <std::size_t N>
bool find_ids(int card, std::uint32_t object, std::uint32_t type, const WantedProperty (&wanted)[N]) {
    for_each_property(card, object, type, [&wanted](const char* name, std::uint32_t id, std::uint64_t) {
        for (const WantedProperty& one : wanted)
            if (std::strcmp(one.name, name) == 0) *one.id = id;
    });
    for (const WantedProperty& one : wanted)
        if (*one.id == 0) return false;
    return true;
}

}  // namespace

void AtomicOutput::close() {
    if (request_ != nullptr) drmModeAtomicFree(request_);
    if (mode_blob_ != 0) drmModeDestroyPropertyBlob(card_, mode_blob_);
    request_ = nullptr;
    mode_blob_ = 0;
}

bool AtomicOutput::open(int card, std::uint32_t connector, std::uint32_t crtc, std::uint32_t crtc_index,
                        const drmModeModeInfo& mode) {
    card_ = card;
    connector_ = connector;
    crtc_ = crtc;
    width_px_ = mode.hdisplay;
    height_px_ = mode.vdisplay;
    if (drmSetClientCap(card, DRM_CLIENT_CAP_UNIVERSAL_PLANES, 1) != 0 || drmSetClientCap(card, DRM_CLIENT_CAP_ATOMIC, 1) != 0)
        return false;
    if (!find_plane(crtc_index) || !find_properties()) return false;
    read_modifiers();
    request_ = drmModeAtomicAlloc();
    return request_ != nullptr && drmModeCreatePropertyBlob(card, &mode, sizeof mode, &mode_blob_) == 0;
}

bool AtomicOutput::is_primary(std::uint32_t plane) const {
    bool primary = false;
    for_each_property(card_, plane, DRM_MODE_OBJECT_PLANE, [&primary](const char* name, std::uint32_t, std::uint64_t value) {
        if (std::strcmp(name, "type") == 0) primary = value == DRM_PLANE_TYPE_PRIMARY;
    });
    return primary;
}

/// A plane that the CRTC shows already is taken before one that it only could show.
bool AtomicOutput::find_plane(std::uint32_t crtc_index) {
    drmModePlaneRes* const planes = drmModeGetPlaneResources(card_);
    if (planes == nullptr) return false;
    bool is_in_use = false;
    for (std::uint32_t n = 0; n < planes->count_planes && !is_in_use; ++n) {
        drmModePlane* const plane = drmModeGetPlane(card_, planes->planes[n]);
        if (plane == nullptr) continue;
        const bool serves = (plane->possible_crtcs >> crtc_index & 1u) != 0 && (plane->crtc_id == 0 || plane->crtc_id == crtc_) &&
                            is_primary(plane->plane_id);
        is_in_use = serves && plane->crtc_id == crtc_;
        if (serves && (plane_ == 0 || is_in_use)) plane_ = plane->plane_id;
        drmModeFreePlane(plane);
    }
    drmModeFreePlaneResources(planes);
    return plane_ != 0;
}

bool AtomicOutput::find_properties() {
    const WantedProperty of_connector[] = {{"CRTC_ID", &ids_.connector_crtc}};
    const WantedProperty of_crtc[] = {{"MODE_ID", &ids_.crtc_mode}, {"ACTIVE", &ids_.crtc_active}};
    const WantedProperty of_plane[] = {{"FB_ID", &ids_.plane_framebuffer},
                                       {"CRTC_ID", &ids_.plane_crtc},
                                       {"SRC_X", &ids_.source_x},
                                       {"SRC_Y", &ids_.source_y},
                                       {"SRC_W", &ids_.source_width},
                                       {"SRC_H", &ids_.source_height},
                                       {"CRTC_X", &ids_.x},
                                       {"CRTC_Y", &ids_.y},
                                       {"CRTC_W", &ids_.width},
                                       {"CRTC_H", &ids_.height}};
    return find_ids(card_, connector_, DRM_MODE_OBJECT_CONNECTOR, of_connector) &&
           find_ids(card_, crtc_, DRM_MODE_OBJECT_CRTC, of_crtc) && find_ids(card_, plane_, DRM_MODE_OBJECT_PLANE, of_plane);
}

void AtomicOutput::read_modifiers() {
    std::uint64_t blob_id = 0;
    for_each_property(card_, plane_, DRM_MODE_OBJECT_PLANE, [&blob_id](const char* name, std::uint32_t, std::uint64_t value) {
        if (std::strcmp(name, "IN_FORMATS") == 0) blob_id = value;
    });
    drmModePropertyBlobRes* const blob = drmModeGetPropertyBlob(card_, static_cast<std::uint32_t>(blob_id));
    if (blob == nullptr) return;
    drmModeFormatModifierIterator at{};
    while (drmModeFormatModifierBlobIterNext(blob, &at))
        if (at.fmt == DRM_FORMAT_XRGB8888 && at.mod != DRM_FORMAT_MOD_INVALID)
            static_cast<void>(modifiers_.try_push_back(at.mod));
    drmModeFreePropertyBlob(blob);
}

void AtomicOutput::add(std::uint32_t object, std::uint32_t property, std::uint64_t value) {
    drmModeAtomicAddProperty(request_, object, property, value);
}

void AtomicOutput::add_plane(std::uint32_t framebuffer) {
    const std::uint64_t fraction = 16;  // the source's edges are numbers of 16.16 bits
    add(plane_, ids_.plane_framebuffer, framebuffer);
    add(plane_, ids_.plane_crtc, crtc_);
    add(plane_, ids_.source_x, 0);
    add(plane_, ids_.source_y, 0);
    add(plane_, ids_.source_width, std::uint64_t{width_px_} << fraction);
    add(plane_, ids_.source_height, std::uint64_t{height_px_} << fraction);
    add(plane_, ids_.x, 0);
    add(plane_, ids_.y, 0);
    add(plane_, ids_.width, width_px_);
    add(plane_, ids_.height, height_px_);
}

bool AtomicOutput::set_mode(std::uint32_t framebuffer) {
    add(connector_, ids_.connector_crtc, crtc_);
    add(crtc_, ids_.crtc_mode, mode_blob_);
    add(crtc_, ids_.crtc_active, 1);
    add_plane(framebuffer);
    return commit(DRM_MODE_ATOMIC_ALLOW_MODESET, 0);
}

bool AtomicOutput::flip(std::uint32_t framebuffer, std::uint32_t cookie) {
    add(plane_, ids_.plane_framebuffer, framebuffer);
    return commit(DRM_MODE_ATOMIC_NONBLOCK | DRM_MODE_PAGE_FLIP_EVENT, cookie);
}

bool AtomicOutput::turn_off() {
    add(connector_, ids_.connector_crtc, 0);
    add(crtc_, ids_.crtc_mode, 0);
    add(crtc_, ids_.crtc_active, 0);
    add(plane_, ids_.plane_framebuffer, 0);
    add(plane_, ids_.plane_crtc, 0);
    return commit(DRM_MODE_ATOMIC_ALLOW_MODESET, 0);
}

bool AtomicOutput::commit(std::uint32_t flags, std::uint32_t cookie) {
    const int result = drmModeAtomicCommit(card_, request_, flags, reinterpret_cast<void*>(std::uintptr_t{cookie}));
    drmModeAtomicSetCursor(request_, 0);
    return result == 0;
}

}  // namespace tedavis::platform

#endif

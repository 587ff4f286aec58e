#include "platform/egl_kms/drm_inventory.hpp"

#if defined(TEDAVIS_HAVE_KMS)

#include <dirent.h>
#include <fcntl.h>
#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>

#include "render_core/base/driver_scope.hpp"
#include "render_core/base/error.hpp"

namespace tedavis::platform {
namespace {

CardAccess access_by_errno(int reason) {
    if (reason == ENOENT || reason == ENOTDIR || reason == ENODEV || reason == ENXIO) return CardAccess::missing;
    return reason == EACCES || reason == EPERM ? CardAccess::no_permission : CardAccess::failed;
}

std::uint32_t refresh_of(const drmModeModeInfo& mode) {
    std::uint64_t dots = std::uint64_t{mode.htotal} * mode.vtotal;
    if (dots == 0) return 0;
    if ((mode.flags & DRM_MODE_FLAG_DBLSCAN) != 0) dots *= 2;
    if (mode.vscan > 1) dots *= mode.vscan;
    const std::uint64_t fields = (mode.flags & DRM_MODE_FLAG_INTERLACE) != 0 ? 2 : 1;
    return static_cast<std::uint32_t>((std::uint64_t{mode.clock} * 1'000'000 * fields + dots / 2) / dots);
}

ScreenMode mode_of(const drmModeModeInfo& info, int index) {
    ScreenMode mode;
    mode.width_px = info.hdisplay;
    mode.height_px = info.vdisplay;
    mode.refresh_mhz = refresh_of(info);
    mode.index = static_cast<std::uint16_t>(index);
    mode.is_preferred = (info.type & DRM_MODE_TYPE_PREFERRED) != 0;
    mode.is_interlaced = (info.flags & DRM_MODE_FLAG_INTERLACE) != 0;
    return mode;
}

void read_encoders(int card, const drmModeConnector& from, ScreenConnector& connector) {
    for (int n = 0; n < from.count_encoders; ++n) {
        drmModeEncoder* const encoder = drmModeGetEncoder(card, from.encoders[n]);
        if (encoder == nullptr) continue;
        connector.possible_crtcs |= encoder->possible_crtcs;
        if (encoder->encoder_id == from.encoder_id) connector.crtc_id = encoder->crtc_id;
        drmModeFreeEncoder(encoder);
    }
}

void add_connector(int card, std::uint32_t id, ScreenCard& into) {
    drmModeConnector* const from = drmModeGetConnector(card, id);
    if (from == nullptr) return;
    ScreenConnector connector;
    const char* const type = drmModeGetConnectorTypeName(from->connector_type);
    char name[32];
    std::snprintf(name, sizeof name, "%s-%u", type != nullptr ? type : "Unknown", from->connector_type_id);
    connector.name = name;
    connector.id = id;
    // Some panels cannot say whether they are there; one with modes is taken to be.
    connector.is_connected =
        from->connection == DRM_MODE_CONNECTED || (from->connection == DRM_MODE_UNKNOWNCONNECTION && from->count_modes > 0);
    read_encoders(card, *from, connector);
    // A mode that does not fit is left out: lists of modes begin with those that the screen likes best.
    for (int n = 0; n < from->count_modes; ++n)
        if (!connector.modes.try_push_back(mode_of(from->modes[n], n))) break;
    drmModeFreeConnector(from);
    static_cast<void>(into.connectors.try_push_back(connector));
}

/// A writeback connector is no screen; the kernel lists it only to those who ask for it.
void read_screens(int card, ScreenCard& into) {
    drmModeRes* const resources = drmModeGetResources(card);
    if (resources == nullptr || resources->count_crtcs == 0 || resources->count_connectors == 0) {
        into.access = CardAccess::no_screens;
    } else {
        into.access = CardAccess::open;
        for (int n = 0; n < resources->count_crtcs; ++n) static_cast<void>(into.crtcs.try_push_back(resources->crtcs[n]));
        for (int n = 0; n < resources->count_connectors; ++n) add_connector(card, resources->connectors[n], into);
    }
    if (resources != nullptr) drmModeFreeResources(resources);
}

base::FixedString<31> group_of(const char* path) {
    struct stat file {};
    if (::stat(path, &file) != 0) return {};
    const group* const owner = ::getgrgid(file.st_gid);
    return owner != nullptr ? base::FixedString<31>(owner->gr_name) : base::FixedString<31>(base::digits(file.st_gid).view());
}

void read_card(const char* path, ScreenCard& into) {
    into.path = path;
    const int card = ::open(path, O_RDWR | O_CLOEXEC | O_NONBLOCK);
    if (card < 0) {
        into.access = access_by_errno(errno);
        if (into.access == CardAccess::no_permission) into.group = group_of(path);
        return;
    }
    if (drmVersion* const version = drmGetVersion(card)) {
        into.driver = std::string_view(version->name, static_cast<std::size_t>(version->name_len));
        drmFreeVersion(version);
        read_screens(card, into);
    } else {
        into.access = CardAccess::no_screens;
    }
    ::close(card);
}

using CardNumbers = base::FixedVector<int, 64>;

CardNumbers card_numbers(const char* folder) {
    CardNumbers numbers;
    DIR* const listing = ::opendir(folder);
    if (listing == nullptr) return numbers;
    while (const dirent* const entry = ::readdir(listing)) {
        const std::string_view name = entry->d_name;
        int number = 0;
        if (name.substr(0, 4) != "card") continue;
        const auto [end, fault] = std::from_chars(name.data() + 4, name.data() + name.size(), number);
        if (fault == std::errc() && end == name.data() + name.size()) static_cast<void>(numbers.try_push_back(number));
    }
    ::closedir(listing);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

}  // namespace

void list_screens(std::string_view path, ScreenInventory& inventory, const char* folder) {
    const base::DriverScope driver;
    inventory.cards.clear();
    ScreenCard card;
    if (!path.empty()) {
        read_card(base::FixedString<255>(path).c_str(), card);
        static_cast<void>(inventory.cards.try_push_back(card));
        return;
    }
    for (const int number : card_numbers(folder)) {
        char name[256];
        std::snprintf(name, sizeof name, "%s/card%d", folder, number);
        card = ScreenCard();
        read_card(name, card);
        static_cast<void>(inventory.cards.try_push_back(card));
    }
}

bool can_list_screens() { return true; }

}  // namespace tedavis::platform

#else

namespace tedavis::platform {

bool can_list_screens() { return false; }

void list_screens(std::string_view, ScreenInventory& inventory, const char*) { inventory.cards.clear(); }

}  // namespace tedavis::platform

#endif

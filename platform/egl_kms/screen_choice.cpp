#include "platform/egl_kms/screen_choice.hpp"

#include <algorithm>

namespace tedavis::platform {
namespace {

using ListText = base::FixedString<511>;

/// Appends ", name" to a list; a name that does not fit leaves "..." in its place.
void append_to_list(ListText& list, std::string_view name) {
    constexpr std::size_t kCapacity = 511, kRoomForDots = 8;
    if (list.size() + name.size() + kRoomForDots > kCapacity) {
        if (list.view().substr(list.size() - 3) != "...") list.append(", ...");
        return;
    }
    if (!list.empty()) list.append(", ");
    list.append(name);
}

ListText drivers_text(const ScreenInventory& inventory) {
    ListText list;
    for (const ScreenCard& card : inventory.cards)
        if (!card.driver.empty()) append_to_list(list, card.driver.view());
    if (list.empty()) list.append("none that can be opened");
    return list;
}

ModeText text_of(const ScreenMode& mode) { return mode_text(mode.width_px, mode.height_px, mode.refresh_mhz); }

base::Error permission_error(const ScreenCard& card) {
    const std::string_view group = card.group.empty() ? std::string_view("video") : card.group.view();
    return base::make_error(card.path.view(), ": may not be opened; it belongs to the group ", group,
                            ": add the user (usermod -aG ", group, " USER) and start again");
}

bool drives_screen(const ScreenCard& card) {
    return std::any_of(card.connectors.begin(), card.connectors.end(), [](const auto& c) { return c.is_connected; });
}

const ScreenConnector* find_connector(const ScreenCard& card, std::string_view name) {
    for (const ScreenConnector& connector : card.connectors)
        if (connector.name.view() == name) return &connector;
    return nullptr;
}

/// How well a card serves; 0: it does not. Cards of one driver differ by what is connected to them.
int rank_of(const ScreenCard& card, const ScreenSettings& settings) {
    if (card.access != CardAccess::open) return 0;
    if (settings.path.empty() && !settings.driver.empty() && card.driver != settings.driver) return 0;
    if (!settings.connector.empty())
        if (const ScreenConnector* const named = find_connector(card, settings.connector.view()))
            return named->is_connected ? 4 : 3;
    return drives_screen(card) ? 2 : 1;
}

/// A card that may not be opened is not mended by waiting; one whose driver is not loaded yet may come.
ScreenFault no_card_fault(const ScreenInventory& inventory, const ScreenSettings& settings) {
    if (inventory.cards.empty())
        return {
            base::make_error("this machine has no graphics card that the kernel drives (nothing in /dev/dri); load the card's "
                             "driver, or draw off-screen with backend = \"egl\""),
            true};
    const bool is_by_driver = settings.path.empty() && !settings.driver.empty();
    for (const ScreenCard& card : inventory.cards)
        if (card.access == CardAccess::no_permission || (is_by_driver && card.driver == settings.driver))
            return {card_error(card), false};
    if (is_by_driver)
        return {base::make_error("no card has the driver '", settings.driver.view(),
                                 "'; drivers here: ", drivers_text(inventory).view(), "; correct driver of [screen], or load it"),
                true};
    return {card_error(inventory.cards[0]), inventory.cards[0].access == CardAccess::missing};
}

base::Result<std::size_t, ScreenFault> choose_card(const ScreenInventory& inventory, const ScreenSettings& settings) {
    std::size_t best = 0;
    int best_rank = 0;
    for (std::size_t n = 0; n < inventory.cards.size(); ++n) {
        const int rank = rank_of(inventory.cards[n], settings);
        if (rank > best_rank) best = n;
        best_rank = std::max(rank, best_rank);
    }
    if (best_rank == 0) return base::fail(no_card_fault(inventory, settings));
    return best;
}

base::Result<std::size_t, ScreenFault> choose_connector(const ScreenCard& card, const ScreenSettings& settings) {
    const auto fault = [&card](bool may_come, std::initializer_list<std::string_view> what, std::string_view remedy) {
        base::Error error = base::make_error(card_text(card).view(), ": ");
        error.message.append(base::make_error(what).message.view());
        error.message.append(base::make_error("; connectors here: ", connectors_text(card).view(), "; ", remedy).message.view());
        return base::fail(ScreenFault{error, may_come});
    };
    for (std::size_t n = 0; n < card.connectors.size(); ++n) {
        const ScreenConnector& connector = card.connectors[n];
        if (settings.connector.empty() ? !connector.is_connected : connector.name != settings.connector) continue;
        if (connector.is_connected) return n;
        return fault(true, {"no screen is connected to ", connector.name.view()}, "connect it and switch it on");
    }
    if (settings.connector.empty()) return fault(true, {"no screen is connected"}, "connect one and switch it on");
    return fault(false, {"has no connector '", settings.connector.view(), "'"}, "correct connector of [screen]");
}

std::uint32_t distance(std::uint32_t a, std::uint32_t b) { return a > b ? a - b : b - a; }

bool meets(const ScreenMode& mode, const ScreenModeWish& wish) {
    if (mode.is_interlaced) return false;
    if (wish.is_preferred()) return mode.is_preferred;
    return mode.width_px == wish.width_px && mode.height_px == wish.height_px &&
           (wish.refresh_mhz == 0 || distance(mode.refresh_mhz, wish.refresh_mhz) <= kRefreshTolerance_mhz);
}

/// Whether `a` meets the wish better than `b`, both of which meet it.
bool is_nearer(const ScreenMode& a, const ScreenMode& b, const ScreenModeWish& wish) {
    if (wish.refresh_mhz != 0) return distance(a.refresh_mhz, wish.refresh_mhz) < distance(b.refresh_mhz, wish.refresh_mhz);
    return a.is_preferred && !b.is_preferred;
}

/// A screen that prefers no mode (no EDID) has its first one taken for it.
const ScreenMode* find_mode(const ScreenConnector& connector, const ScreenModeWish& wish) {
    const ScreenMode* best = nullptr;
    for (const ScreenMode& mode : connector.modes)
        if (meets(mode, wish) && (best == nullptr || is_nearer(mode, *best, wish))) best = &mode;
    if (best != nullptr || !wish.is_preferred()) return best;
    for (const ScreenMode& mode : connector.modes)
        if (!mode.is_interlaced) return &mode;
    return nullptr;
}

base::Result<ScreenMode, base::Error> choose_mode(const ScreenConnector& connector, const ScreenModeWish& wish,
                                                  std::uint32_t width_px, std::uint32_t height_px) {
    const ScreenMode* const mode = find_mode(connector, wish);
    if (mode == nullptr && wish.is_preferred())
        return base::fail(base::make_error("the screen at ", connector.name.view(),
                                           " has no mode that is not interlaced; use "
                                           "another screen"));
    if (mode == nullptr)
        return base::fail(base::make_error("the screen at ", connector.name.view(), " has no mode ",
                                           mode_text(wish.width_px, wish.height_px, wish.refresh_mhz).view(),
                                           "; modes here: ", modes_text(connector).view(), "; correct mode of [screen]"));
    if (mode->width_px == width_px && mode->height_px == height_px) return *mode;
    return base::fail(base::make_error("the board's picture of ", mode_text(width_px, height_px, 0).view(),
                                       " does not have the size of the mode ", text_of(*mode).view(), " of the screen at ",
                                       connector.name.view(),
                                       "; set width_px and height_px of [surface], or mode of [screen]; "
                                       "modes here: ",
                                       modes_text(connector).view()));
}

bool drives_another(const ScreenCard& card, const ScreenConnector& connector, std::uint32_t crtc_id) {
    return std::any_of(card.connectors.begin(), card.connectors.end(), [&](const ScreenConnector& other) {
        return other.id != connector.id && other.is_connected && other.crtc_id == crtc_id;
    });
}

/// False where the card has no CRTC for the connector.
bool choose_crtc(const ScreenCard& card, const ScreenConnector& connector, ScreenChoice& choice) {
    int best_rank = 0;
    for (std::size_t n = 0; n < card.crtcs.size(); ++n) {
        if ((connector.possible_crtcs >> n & 1u) == 0) continue;
        const std::uint32_t id = card.crtcs[n];
        const int rank = id == connector.crtc_id ? 3 : drives_another(card, connector, id) ? 1 : 2;
        if (rank <= best_rank) continue;
        best_rank = rank;
        choice.crtc_id = id;
        choice.crtc_index = static_cast<std::uint32_t>(n);
    }
    return best_rank > 0;
}

}  // namespace

base::FixedString<300> card_text(const ScreenCard& card) {
    base::FixedString<300> name(card.path.view());
    if (!card.driver.empty()) {
        name.append(" (");
        name.append(card.driver.view());
        name.append(")");
    }
    return name;
}

base::FixedString<511> connectors_text(const ScreenCard& card) {
    ListText list;
    for (const ScreenConnector& connector : card.connectors) {
        base::FixedString<63> text(connector.name.view());
        text.append(connector.is_connected ? " (connected)" : " (not connected)");
        append_to_list(list, text.view());
    }
    if (list.empty()) list.append("none");
    return list;
}

base::FixedString<511> modes_text(const ScreenConnector& connector) {
    ListText list;
    for (const ScreenMode& mode : connector.modes)
        if (!mode.is_interlaced) append_to_list(list, text_of(mode).view());
    if (list.empty()) list.append("none");
    return list;
}

base::Error card_error(const ScreenCard& card) {
    switch (card.access) {
        case CardAccess::missing:
            return base::make_error(card.path.view(),
                                    ": there is no such card; correct path of [screen] (ls /dev/dri/by-path), or load the "
                                    "card's driver");
        case CardAccess::no_permission: return permission_error(card);
        case CardAccess::no_screens:
            return base::make_error(card_text(card).view(), ": drives no screens (no KMS); name another card in [screen]");
        default: return base::make_error(card_text(card).view(), ": cannot be opened; the kernel's log says why (dmesg)");
    }
}

base::Result<ScreenChoice, ScreenFault> choose_screen(const ScreenInventory& inventory, const ScreenSettings& settings,
                                                      std::uint32_t width_px, std::uint32_t height_px) {
    ScreenChoice choice;
    const auto card = choose_card(inventory, settings);
    if (!card.ok()) return base::fail(card.error());
    choice.card = card.value();
    const ScreenCard& chosen = inventory.cards[choice.card];
    const auto connector = choose_connector(chosen, settings);
    if (!connector.ok()) return base::fail(connector.error());
    choice.connector = connector.value();
    const ScreenConnector& wire = chosen.connectors[choice.connector];
    const auto mode = choose_mode(wire, settings.mode, width_px, height_px);
    if (!mode.ok()) return base::fail(ScreenFault{mode.error(), false});
    choice.mode = mode.value();
    if (choose_crtc(chosen, wire, choice)) return choice;
    return base::fail(ScreenFault{base::make_error(card_text(chosen).view(), ": has no CRTC for the connector ", wire.name.view(),
                                                   "; name another connector in [screen]"),
                                  false});
}

}  // namespace tedavis::platform

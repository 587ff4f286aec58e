/// A machine that tests make up: cards, interfaces and GPIO chips, read by the ports of --probe. One at a time.
#pragma once

#include <memory>
#include <string>

#include "target/probe/probe_ports.hpp"

namespace tedavis::target {

struct FakeMachine {
    FakeMachine() { now = this; }
    ~FakeMachine() { now = nullptr; }
    FakeMachine(const FakeMachine&) = delete;
    FakeMachine& operator=(const FakeMachine&) = delete;

    [[nodiscard]] static ProbePorts ports() {
        ProbePorts made;
        made.list_screens = [](std::string_view path, platform::ScreenInventory& to) {
            to.cards.clear();
            for (const platform::ScreenCard& card : now->screens->cards)
                if (path.empty() || card.path.view() == path) static_cast<void>(to.cards.try_push_back(card));
        };
        made.is_card_held = [](const char* path) { return now->held == path; };
        made.card_holders = [](const char*) { return base::FixedString<191>(now->holders); };
        made.find_seat = [] { return now->seat; };
        made.list_interfaces = [](bus::InterfaceList& to) { to = now->interfaces; };
        made.list_gpio = [](GpioInventory& to) { to = *now->gpio; };
        return made;
    }
    /// A card with one screen of 640 x 480 and 1024 x 768, and a connector without.
    platform::ScreenCard& add_card(const char* path = "/dev/dri/card1", const char* driver = "virtio_gpu") {
        platform::ScreenCard card;
        card.path = path;
        card.driver = driver;
        card.access = platform::CardAccess::open;
        static_cast<void>(card.crtcs.try_push_back(31));
        platform::ScreenConnector screen;
        screen.name = "Virtual-1";
        screen.id = 40;
        screen.is_connected = true;
        screen.possible_crtcs = 1;
        static_cast<void>(screen.modes.try_push_back({1024, 768, 60000, 0, false, false}));
        static_cast<void>(screen.modes.try_push_back({640, 480, 60000, 1, true, false}));
        static_cast<void>(card.connectors.try_push_back(screen));
        platform::ScreenConnector bare;
        bare.name = "HDMI-A-1";
        bare.id = 41;
        static_cast<void>(card.connectors.try_push_back(bare));
        static_cast<void>(screens->cards.try_push_back(card));
        return screens->cards.back();
    }
    bus::NetInterface& add_controller(const char* name) {
        bus::NetInterface link;
        link.name = name;
        link.kind = "can";
        link.is_can = link.is_up = true;
        link.bit_rate_hz = 500000;
        link.restart_ms = 100;
        link.state = bus::ControllerState::active;
        static_cast<void>(interfaces.interfaces.try_push_back(link));
        return interfaces.interfaces.back();
    }
    GpioChip& add_chip(const char* name, const char* label, std::initializer_list<const char*> lines) {
        GpioChip chip;
        chip.name = name;
        chip.label = label;
        chip.may_open = true;
        chip.line_count = static_cast<std::uint32_t>(lines.size());
        for (const char* line : lines) static_cast<void>(chip.lines.try_push_back({line, {}, false}));
        static_cast<void>(gpio->chips.try_push_back(chip));
        return gpio->chips.back();
    }

    static inline FakeMachine* now = nullptr;
    std::unique_ptr<platform::ScreenInventory> screens = std::make_unique<platform::ScreenInventory>();
    std::unique_ptr<GpioInventory> gpio = std::make_unique<GpioInventory>();
    bus::InterfaceList interfaces = [] {
        bus::InterfaceList list;
        list.is_read = true;
        return list;
    }();
    std::string held;  ///< path of a card that another program has
    std::string holders;
    platform::SeatOffer seat;
};

}  // namespace tedavis::target

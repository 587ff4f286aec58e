#include "target/probe/switch_faults.hpp"

#include <initializer_list>

#include "bus/switches/gpio_lines.hpp"

namespace tedavis::target {
namespace {

using GpioText = base::FixedString<511>;

/// Appends ", item" to a list; an item that does not fit leaves "..." in its place.
void append_item(GpioText& list, std::string_view item) {
    constexpr std::size_t kCapacity = 511, kRoomForDots = 8;
    if (list.size() + item.size() + kRoomForDots > kCapacity) {
        if (list.view().substr(list.size() - 3) != "...") list.append(", ...");
        return;
    }
    if (!list.empty()) list.append(", ");
    list.append(item);
}

GpioText chips_text(const GpioInventory& inventory) {
    GpioText list;
    for (const GpioChip& chip : inventory.chips)
        if (chip.may_open) append_item(list, chip_text(chip).view());
    if (list.empty()) list.append("none");
    return list;
}

base::Error line_error(const bus::SwitchLine& line, std::initializer_list<std::string_view> what) {
    return bus::switch_line_error(line, base::make_error(what).message.view());
}

/// By its label, else by its name, as the lines are requested.
const GpioChip* find_chip(const GpioInventory& inventory, std::string_view wanted) {
    for (const GpioChip& chip : inventory.chips)
        if (chip.may_open && chip.label.view() == wanted) return &chip;
    for (const GpioChip& chip : inventory.chips)
        if (chip.name.view() == wanted) return &chip;
    return nullptr;
}

base::Error closed_error(const GpioChip& chip, const bus::SwitchLine& line) {
    const std::string_view group = chip.group.empty() ? std::string_view("gpio") : chip.group.view();
    return line_error(
        line, {"/dev/", chip.name.view(), " may not be opened; it belongs to the group ", group, ": add the user (usermod -aG ",
               group, " USER) and start again; where that is root, let a udev rule give it to the group gpio"});
}

base::Error no_chip_error(const GpioInventory& inventory, const bus::SwitchLine& line) {
    if (inventory.chips.empty())
        return line_error(line, {"this machine has no GPIO chip (nothing in /dev/gpiochip*); load the chip's driver"});
    for (const GpioChip& chip : inventory.chips)
        if (!chip.may_open) return closed_error(chip, line);
    return line_error(line,
                      {"no GPIO chip has this label or name; chips here: ", chips_text(inventory).view(), "; correct 'chip'"});
}

/// Null where the chip has no such line, or one beyond those that were read, which `is_beyond` says.
const GpioLine* find_gpio_line(const GpioChip& chip, const bus::SwitchLine& line, bool& is_beyond) {
    const auto offset = static_cast<std::uint32_t>(line.offset);
    is_beyond = line.offset >= 0 ? offset >= chip.lines.size() && offset < chip.line_count : chip.lines.size() < chip.line_count;
    if (line.offset >= 0) return offset < chip.lines.size() ? &chip.lines[offset] : nullptr;
    for (const GpioLine& known : chip.lines)
        if (known.name.view() == line.name.view()) return &known;
    return nullptr;
}

base::Error no_line_error(const GpioChip& chip, const bus::SwitchLine& line) {
    if (line.offset >= 0)
        return line_error(line, {"the chip ", chip_text(chip).view(), " has ", base::digits(chip.line_count).view(),
                                 " lines, numbered from 0, and none with this offset; correct 'offset'"});
    return line_error(line, {"the chip ", chip_text(chip).view(), " has no line of this name; its lines: ",
                             lines_text(chip).view(), "; correct 'name', or give its 'offset'"});
}

base::Error busy_error(const GpioLine& known, const bus::SwitchLine& line) {
    if (known.consumer.view() == "tedavis")
        return line_error(line, {"another tedavis-display uses it; end that first (systemctl stop tedavis-display)"});
    const std::string_view user =
        known.consumer.empty() ? std::string_view("a program or driver without a name") : known.consumer.view();
    return line_error(line, {"is used by ", user, "; end that, or correct the line in the switch file"});
}

}  // namespace

base::FixedString<95> chip_text(const GpioChip& chip) {
    if (chip.label.empty()) return chip.name.view();
    base::FixedString<95> text(chip.label.view());
    text.append(" (");
    text.append(chip.name.view());
    text.append(")");
    return text;
}

base::FixedString<511> lines_text(const GpioChip& chip) {
    GpioText list;
    for (std::size_t n = 0; n < chip.lines.size(); ++n) {
        const GpioLine& line = chip.lines[n];
        base::FixedString<127> text(base::digits(n).view());
        text.append(line.name.empty() ? "" : " ");
        text.append(line.name.view());
        if (line.is_used) {
            text.append(" (used by ");
            text.append(line.consumer.empty() ? std::string_view("someone") : line.consumer.view());
            text.append(")");
        }
        append_item(list, text.view());
    }
    if (list.empty()) list.append("none");
    return list;
}

base::Error switch_line_fault(const GpioInventory& inventory, const bus::SwitchLine& line) {
    const GpioChip* const chip = find_chip(inventory, line.chip.view());
    if (chip == nullptr) return no_chip_error(inventory, line);
    if (!chip->may_open) return closed_error(*chip, line);
    bool is_beyond = false;
    const GpioLine* const known = find_gpio_line(*chip, line, is_beyond);
    if (known == nullptr) return is_beyond ? base::Error() : no_line_error(*chip, line);
    return known->is_used ? busy_error(*known, line) : base::Error();
}

base::Error panel_fault(const GpioInventory& inventory, const bus::SwitchConfig& panel) {
    for (const bus::SwitchLine& line : panel.lines)
        if (base::Error error = switch_line_fault(inventory, line)) return error;
    return {};
}

}  // namespace tedavis::target

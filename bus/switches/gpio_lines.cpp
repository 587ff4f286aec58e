#include "bus/switches/gpio_lines.hpp"

namespace tedavis::bus {

base::Error switch_line_error(const SwitchLine& line, std::string_view what) {
    base::Error error;
    error.message = "switch line '";
    error.message.append(line.chip.view());
    error.message.append(".");
    error.message.append(line.name.view());
    error.message.append("': ");
    error.message.append(what);
    return error;
}

std::string_view what_is_missing(const SwitchLine& line) {
    return line.offset >= 0 ? "the chip has no line with this offset; see gpioinfo and correct 'offset'"
                            : "the chip has no line of this name; see gpioinfo and correct 'name', or give its 'offset'";
}

#if !defined(TEDAVIS_HAVE_GPIOD)
std::unique_ptr<GpioLines> make_gpiod_lines() { return nullptr; }
#endif

}  // namespace tedavis::bus

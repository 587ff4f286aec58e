#include "bus/switches/gpio_lines.hpp"

#include <unistd.h>

#include <cstdio>

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

std::string_view what_hides_the_chip() {
    constexpr int kMaxChips = 256;
    for (int number = 0; number < kMaxChips; ++number) {
        char path[32];
        std::snprintf(path, sizeof path, "/dev/gpiochip%d", number);
        if (::access(path, F_OK) == 0 && ::access(path, R_OK | W_OK) != 0)
            return "no GPIO chip that may be opened has this label or name; add the user to the group gpio, or correct 'chip'";
    }
    return "no GPIO chip has this label or name; see gpiodetect and correct 'chip'";
}

#if !defined(TEDAVIS_HAVE_GPIOD)
std::unique_ptr<GpioLines> make_gpiod_lines() { return nullptr; }
#endif

}  // namespace tedavis::bus

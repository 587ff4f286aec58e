#include "bus/switches/gpio_lines.hpp"

namespace tedavis::bus {

SwitchError switch_line_error(const SwitchLine& line, std::string_view what) {
    SwitchError error;
    error.sentence = "switch line '";
    error.sentence.append(line.chip.view());
    error.sentence.append(".");
    error.sentence.append(line.name.view());
    error.sentence.append("': ");
    error.sentence.append(what);
    return error;
}

#if !defined(TEDAVIS_HAVE_GPIOD)
std::unique_ptr<GpioLines> make_gpiod_lines() { return nullptr; }
#endif

}  // namespace tedavis::bus

#include "render_core/design/config_values.hpp"

#include "render_core/base/fixed_string.hpp"

namespace tedavis::design {

void fault_of(base::ConfigSection& section, std::string_view key, std::string_view what) {
    base::FixedString<447> message("'");
    message.append(key);
    message.append("' ");
    message.append(what);
    section.fault(key, message.view());
}

Color required_color(base::ConfigSection& section, std::string_view key) {
    const ParsedColor parsed = color_from_text(section.text(key));
    if (!parsed.ok) fault_of(section, key, "is no colour; write it as \"#rrggbb\"");
    return parsed.color;
}

void read_color(base::ConfigSection& section, std::string_view key, Color& color) {
    if (section.has(key)) color = required_color(section, key);
}

}  // namespace tedavis::design

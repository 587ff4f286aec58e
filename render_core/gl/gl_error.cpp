#include "render_core/gl/gl_error.hpp"

namespace tedavis::gl {

GlError make_error(std::string_view a, std::string_view b, std::string_view c, std::string_view d) {
    GlError error;
    for (std::string_view part : {a, b, c, d}) error.sentence.append(part);
    return error;
}

base::FixedString<20> digits(std::uint64_t value) {
    char text[20];
    std::size_t first = sizeof text;
    do {
        text[--first] = static_cast<char>('0' + value % 10);
        value /= 10;
    } while (value != 0);
    return base::FixedString<20>(std::string_view(text + first, sizeof text - first));
}

}  // namespace tedavis::gl

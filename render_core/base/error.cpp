#include "render_core/base/error.hpp"

namespace tedavis::base {

Error make_error(std::initializer_list<std::string_view> parts) {
    Error error;
    for (const std::string_view part : parts) error.message.append(part);
    return error;
}

FixedString<20> digits(std::uint64_t value) {
    char text[20];
    std::size_t first = sizeof text;
    do {
        text[--first] = static_cast<char>('0' + value % 10);
        value /= 10;
    } while (value != 0);
    return FixedString<20>(std::string_view(text + first, sizeof text - first));
}

}  // namespace tedavis::base

#include "target/json_line.hpp"

#include <cinttypes>
#include <cmath>
#include <cstdio>

namespace tedavis::target {

void JsonLine::quote(std::string_view value) {
    text_.append("\"");
    for (const char c : value) {
        const auto code = static_cast<unsigned char>(c);
        char escaped[8] = {c, '\0'};
        if (c == '"' || c == '\\')
            std::snprintf(escaped, sizeof escaped, "\\%c", c);
        else if (code < 0x20)
            std::snprintf(escaped, sizeof escaped, "\\u%04x", static_cast<unsigned>(code));
        text_.append(escaped);
    }
    text_.append("\"");
}

void JsonLine::begin(std::string_view key) {
    if (!first_) text_.append(",");
    first_ = false;
    if (key.empty()) return;
    quote(key);
    text_.append(":");
}

JsonLine& JsonLine::open(std::string_view key, std::string_view bracket) {
    begin(key);
    text_.append(bracket);
    first_ = true;
    return *this;
}

JsonLine& JsonLine::close(std::string_view bracket) {
    text_.append(bracket);
    first_ = false;
    return *this;
}

JsonLine& JsonLine::text(std::string_view key, std::string_view value) {
    begin(key);
    quote(value);
    return *this;
}

JsonLine& JsonLine::number(std::string_view key, std::uint64_t value) {
    char digits[24];
    std::snprintf(digits, sizeof digits, "%" PRIu64, value);
    begin(key);
    text_.append(digits);
    return *this;
}

JsonLine& JsonLine::number(std::string_view key, double value) {
    char digits[32] = "null";  // JSON has no infinity and no NaN
    if (std::isfinite(value)) std::snprintf(digits, sizeof digits, "%.15g", value);
    begin(key);
    text_.append(digits);
    return *this;
}

JsonLine& JsonLine::boolean(std::string_view key, bool value) {
    begin(key);
    text_.append(value ? "true" : "false");
    return *this;
}

std::string_view JsonLine::line() {
    text_.append("\n");
    return text_.view();
}

}  // namespace tedavis::target

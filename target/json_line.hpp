/// Builds one line of JSON in a fixed buffer, for scripts that read the program's results.
///
/// Memory  inside. Failure  text that does not fit is cut, and cut() returns true. The caller must balance the nesting.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_string.hpp"

namespace tedavis::target {

class JsonLine {
public:
    JsonLine& open_object(std::string_view key = {}) { return open(key, "{"); }
    JsonLine& close_object() { return close("}"); }
    JsonLine& open_list(std::string_view key = {}) { return open(key, "["); }
    JsonLine& close_list() { return close("]"); }
    JsonLine& text(std::string_view key, std::string_view value);
    JsonLine& number(std::string_view key, std::uint64_t value);
    JsonLine& number(std::string_view key, double value);
    JsonLine& boolean(std::string_view key, bool value);

    /// Begins another line.
    void clear() {
        text_.clear();
        first_ = true;
    }
    /// Returns the line with a newline at its end.
    [[nodiscard]] std::string_view line();
    [[nodiscard]] bool cut() const { return text_.cut(); }

private:
    JsonLine& open(std::string_view key, std::string_view bracket);
    JsonLine& close(std::string_view bracket);
    void begin(std::string_view key);
    void quote(std::string_view value);

    base::FixedString<65535> text_;
    bool first_ = true;  // no comma precedes the next element
};

}  // namespace tedavis::target

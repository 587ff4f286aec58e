/// Writes TOML, one line for each key. Empty texts, lists and optionals are left out.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/toml_text.hpp"

namespace tedavis::host_sim {

class TomlWriter {
public:
    TomlWriter() { text_.precision(std::numeric_limits<double>::max_digits10); }

    void word(std::string_view key, std::string_view value) {
        if (!value.empty()) text_ << key << " = " << toml_string(std::string(value)) << '\n';
    }
    /// Written with as many digits as give the same double when they are read.
    void number(std::string_view key, const std::optional<double>& value) {
        if (value) text_ << key << " = " << std::showpoint << *value << '\n';
    }
    void words(std::string_view key, const std::vector<std::string>& values) {
        if (values.empty()) return;
        text_ << key << " = [";
        for (std::size_t n = 0; n < values.size(); ++n) text_ << (n > 0 ? ", " : "") << toml_string(values[n]);
        text_ << "]\n";
    }
    void truth(std::string_view key, bool value) { text_ << key << " = " << (value ? "true" : "false") << '\n'; }
    void integer(std::string_view key, std::uint64_t value) { text_ << key << " = " << value << '\n'; }
    void section(std::string_view name) { text_ << "\n[" << name << "]\n"; }
    void list_entry(std::string_view name) { text_ << "\n[[" << name << "]]\n"; }
    [[nodiscard]] std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
};

}  // namespace tedavis::host_sim

/// Small switch configs and edges for the tests of bus/switches.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "bus/switches/switch_config.hpp"
#include "bus/switches/switch_edge.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::bus {

inline SwitchConfig config_from(const std::string& text) {
    const auto loaded = load_switch_config(text, "t.toml");
    EXPECT_TRUE(loaded.ok()) << loaded.error().message.view();
    return loaded.ok() ? loaded.value() : SwitchConfig{};
}

inline std::string shipped_text(const std::string& name) {
    std::ifstream file(test_support::source_dir() + "/configs/switches/" + name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Lines A (ground), B (cruise), C (approach), one-hot, debounce 30 ms, settle 200 ms.
inline SwitchConfig three_lines() {
    return config_from(
        "code = 'one_hot'\n[[line]]\nchip='p'\nname='A'\n[[line]]\nchip='p'\nname='B'\n[[line]]\nchip='p'\nname='C'\n"
        "[[pattern]]\nphase='ground'\nhigh=['A']\n[[pattern]]\nphase='cruise'\nhigh=['B']\n[[pattern]]\nphase='approach'\nhigh=['"
        "C']\n");
}

/// The same with a fourth line that asks for the legend.
inline SwitchConfig three_lines_and_legend() {
    return config_from(
        "code = 'one_hot'\n[[line]]\nchip='p'\nname='A'\n[[line]]\nchip='p'\nname='B'\n[[line]]\nchip='p'\nname='C'\n"
        "[legend]\nchip='p'\nname='LEGEND'\n"
        "[[pattern]]\nphase='ground'\nhigh=['A']\n[[pattern]]\nphase='cruise'\nhigh=['B']\n[[pattern]]\nphase='approach'\nhigh=['"
        "C']\n");
}

inline base::Time at_ms(std::int64_t ms) { return {1'700'000'000'000'000'000 + ms * 1'000'000}; }
inline SwitchEdge edge(std::int64_t ms, int line, bool level) { return {at_ms(ms), static_cast<std::uint8_t>(line), level}; }

}  // namespace tedavis::bus

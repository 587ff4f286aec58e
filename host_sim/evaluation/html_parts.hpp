/// HTML elements of the pages of evaluations. Texts are escaped here; `html` and `rows` are not.
#pragma once

#include <string>

#include "host_sim/evaluation/evaluated_flight.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::string html_section(const std::string& title, const std::string& html);
/// In a box that scrolls sideways on narrow screens.
[[nodiscard]] std::string html_table(const std::string& head_rows, const std::string& rows);
[[nodiscard]] std::string html_cell(const std::string& text);
[[nodiscard]] std::string html_number(const std::string& text);
/// A number that is hidden on narrow screens.
[[nodiscard]] std::string html_aside(const std::string& text);
/// The phase's name after a patch in its colour.
[[nodiscard]] std::string html_phase(const std::string& phase);
/// A large number with its label below.
[[nodiscard]] std::string html_fact(const std::string& number, const std::string& words);
/// A PNG's bytes as a picture of the page.
[[nodiscard]] std::string html_figure(const std::string& png, const std::string& caption, const std::string& spoken);

/// "312.0 s"
[[nodiscard]] std::string seconds_text(double time_s);
/// "0.187"
[[nodiscard]] std::string clutter_text(double clutter);
/// "34 %"
[[nodiscard]] std::string percent_text(double share);

/// Returns a bar of a span's layers, as wide as its box, with the prioritized one outlined; empty without layers.
[[nodiscard]] std::string layer_bar(const std::vector<LayerShare>& layers, const std::string& prioritized);
/// Returns the legend of layer_bar(): names beside their colours, and the meaning of the outline.
[[nodiscard]] std::string layer_key(const std::vector<LayerShare>& layers, bool with_outline = true);

}  // namespace tedavis::host_sim

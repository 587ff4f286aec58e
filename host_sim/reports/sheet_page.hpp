/// `index.html` and `sheet.json` of a contact sheet.
#pragma once

#include <string>

#include "host_sim/reports/drawn_sheet.hpp"

namespace tedavis::host_sim {

/// Returns a self-contained page: pictures as data URIs, no scripts, no network; readable on a phone and printable.
[[nodiscard]] std::string sheet_page(const DrawnSheet& sheet);
/// Keys that scripts may rely on: `pictures` [{`group`, `title`, `design`, `file`, `hash`, `triangles`, `flags`, `effects`}],
/// the last two as in `frames.jsonl`, and `weights`; of sheets that measure aspects also `measures` {`edge_density`,
/// `data_colors`, `glyphs`}, of pictures of a flight `caption`
/// and `flight_s`, and of sheets with layers beside the pictures `layers`, their names.
[[nodiscard]] std::string sheet_json(const DrawnSheet& sheet);

}  // namespace tedavis::host_sim

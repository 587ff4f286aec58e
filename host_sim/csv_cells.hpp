/// Splits comma-separated lines into cells; blanks, quotes and carriage returns round them are removed.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace tedavis::host_sim {

/// Returns the text without the blanks, tabs, quotes and carriage returns at both ends.
[[nodiscard]] inline std::string_view trimmed_cell(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '"')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r' || text.back() == '"'))
        text.remove_suffix(1);
    return text;
}

/// Returns the trimmed cells, at least one, as views into `line`.
[[nodiscard]] inline std::vector<std::string_view> csv_cells(std::string_view line) {
    std::vector<std::string_view> cells;
    for (;;) {
        const std::size_t comma = line.find(',');
        cells.push_back(trimmed_cell(line.substr(0, comma)));
        if (comma == std::string_view::npos) return cells;
        line.remove_prefix(comma + 1);
    }
}

/// Returns the number in a cell; nothing unless the whole cell is one finite decimal number.
[[nodiscard]] inline std::optional<double> number_in(std::string_view cell) {
    double value = 0;
    const auto [end, fault] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    const bool whole = fault == std::errc() && end == cell.data() + cell.size() && std::isfinite(value);
    return whole ? std::optional<double>(value) : std::nullopt;
}

}  // namespace tedavis::host_sim

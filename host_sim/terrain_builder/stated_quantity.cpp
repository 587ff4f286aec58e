#include "host_sim/terrain_builder/stated_quantity.hpp"

#include <cpl_string.h>

#include <algorithm>
#include <cctype>

#include "host_sim/terrain_builder/vertical_reference.hpp"

namespace tedavis::host_sim {
namespace {

std::string in_lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

bool names_a_height(const std::string& name) {
    for (const char* word : {"height", "altitude", "elevation", "depth", "topograph", "orograph", "geoid", "dem", "dtm", "dsm"})
        if (name.find(word) != std::string::npos) return true;
    return false;
}

/// "metres above sea level" begins with a length.
bool names_a_length(const std::string& unit) {
    return metres_per_unit(unit).has_value() || metres_per_unit(unit.substr(0, unit.find_first_of(" (,"))).has_value();
}

bool ends_as(const std::string& key, const std::string& word) {
    const std::size_t before = key.size() - word.size();
    return key.size() >= word.size() && key.compare(before, word.size(), word) == 0 &&
           (before == 0 || key[before - 1] == '_' || key[before - 1] == '/' || key[before - 1] == '.');
}

/// A coordinate's own lines have its name before a '#'; they say nothing about the values.
bool says_otherwise(const std::string& key, const std::string& value) {
    if (value.empty() || key.find('#') != std::string::npos) return false;
    if (ends_as(key, "quantity") || key == "standard_name") return !names_a_height(value);
    return (key == "units" || key == "unit") && !names_a_length(value);
}

std::optional<std::string> other_quantity_in(CSLConstList metadata) {
    for (int n = 0; n < CSLCount(metadata); ++n) {
        char* key = nullptr;
        const char* const value = CPLParseNameValue(metadata[n], &key);
        const std::string name = key == nullptr ? "" : key, stated = value == nullptr ? "" : value;
        CPLFree(key);
        if (says_otherwise(in_lower_case(name), in_lower_case(stated))) return "'" + stated + "' (" + name + ")";
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> other_quantity(GDALDataset& dataset) {
    if (auto found = other_quantity_in(dataset.GetRasterBand(1)->GetMetadata())) return found;
    return other_quantity_in(dataset.GetMetadata());
}

}  // namespace tedavis::host_sim

#include "host_sim/flight_test/script_table.hpp"

#include <algorithm>
#include <cstdio>

#include "host_sim/flight_test/nearest_names.hpp"

namespace tedavis::host_sim {
namespace {

std::string quoted_key(std::string_view key) { return "'" + std::string(key) + "'"; }

std::string short_number(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", number);
    return text;
}

}  // namespace

ScriptTable::ScriptTable(const ScriptValue& value, ScriptFaults& faults) : value_(value), faults_(faults) {
    if (value.kind != ScriptValue::Kind::table)
        faults.add(value.file, value.line, "a table { key = value, ... } is expected here");
}

const ScriptValue* ScriptTable::take(std::string_view key) {
    known_.insert(std::string(key));
    return value_.find(key);
}

bool ScriptTable::is_kind(const ScriptValue& value, ScriptValue::Kind kind, std::string_view key, const char* words) {
    if (value.kind == kind) return true;
    if (value.kind != ScriptValue::Kind::faulty) faults_.add(value.file, value.line, quoted_key(key) + " must be " + words);
    return false;
}

std::optional<double> ScriptTable::number(std::string_view key, double low, double high) {
    const ScriptValue* const value = take(key);
    if (value == nullptr || !is_kind(*value, ScriptValue::Kind::number, key, "a number")) return std::nullopt;
    if (value->number >= low && value->number <= high) return value->number;
    faults_.add(value->file, value->line, quoted_key(key) + " must be " + short_number(low) + " to " + short_number(high));
    return std::nullopt;
}

std::optional<std::string> ScriptTable::text(std::string_view key) {
    const ScriptValue* const value = take(key);
    if (value == nullptr || !is_kind(*value, ScriptValue::Kind::text, key, "a text")) return std::nullopt;
    return value->text;
}

std::optional<bool> ScriptTable::boolean(std::string_view key) {
    const ScriptValue* const value = take(key);
    if (value == nullptr || !is_kind(*value, ScriptValue::Kind::boolean, key, "true or false")) return std::nullopt;
    return value->boolean;
}

std::vector<std::string> ScriptTable::texts(std::string_view key) {
    const ScriptValue* const value = take(key);
    if (value == nullptr) return {};
    if (value->kind == ScriptValue::Kind::text) return {value->text};
    std::vector<std::string> all;
    if (!is_kind(*value, ScriptValue::Kind::list, key, "a list of texts")) return {};
    for (const ScriptValue& item : value->items)
        if (is_kind(item, ScriptValue::Kind::text, key, "a list of texts")) all.push_back(item.text);
    return all;
}

std::vector<const ScriptValue*> ScriptTable::tables(std::string_view key) {
    const ScriptValue* const value = take(key);
    std::vector<const ScriptValue*> all;
    if (value == nullptr || !is_kind(*value, ScriptValue::Kind::list, key, "a list of tables, [[...]]")) return all;
    for (const ScriptValue& item : value->items)
        if (is_kind(item, ScriptValue::Kind::table, key, "a list of tables, [[...]]")) all.push_back(&item);
    return all;
}

std::vector<const ScriptValue::Entry*> ScriptTable::entries(std::string_view key) {
    const ScriptValue* const value = take(key);
    std::vector<const ScriptValue::Entry*> all;
    if (value == nullptr || !is_kind(*value, ScriptValue::Kind::table, key, "a table { name = value, ... }")) return all;
    for (const ScriptValue::Entry& entry : value->entries)
        if (entry.second.kind != ScriptValue::Kind::faulty) all.push_back(&entry);
    return all;
}

void ScriptTable::fault(std::string_view key, const std::string& message) {
    const ScriptValue* const value = value_.find(key);
    faults_.add(value != nullptr ? value->file : value_.file, value != nullptr ? value->line : value_.line, message);
}

void ScriptTable::finish() {
    for (const auto& [key, value] : value_.entries) {
        if (known_.count(key) != 0) continue;
        const std::string near = nearest_names(key, {known_.begin(), known_.end()});
        faults_.add(value.file, value.line, "unknown key " + quoted_key(key) + "; say " + near + ", or remove it");
    }
}

std::optional<std::size_t> place_among(ScriptTable& table, std::string_view key, std::string_view name,
                                       const std::vector<std::string>& names) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    table.fault(key, quoted_key(key) + ": there is no '" + std::string(name) + "'; say " + nearest_names(name, names));
    return std::nullopt;
}

}  // namespace tedavis::host_sim

/// Reads the keys of a table of a flight test; faults are collected, and a key that nobody read is one.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/flight_test/script_value.hpp"

namespace tedavis::host_sim {

class ScriptTable {
public:
    /// A value that is no table is a fault, and reads as an empty table. Both must outlive this object.
    ScriptTable(const ScriptValue& value, ScriptFaults& faults);

    [[nodiscard]] std::size_t line() const { return value_.line; }
    [[nodiscard]] const std::string& file() const { return value_.file; }
    [[nodiscard]] bool has(std::string_view key) const { return value_.find(key) != nullptr; }
    /// The value at a key, or null; it counts as read.
    const ScriptValue* take(std::string_view key);
    /// Nothing where the key is absent, and after a fault. Numbers outside [low, high] and NaN are faults.
    std::optional<double> number(std::string_view key, double low, double high);
    std::optional<std::string> text(std::string_view key);
    std::optional<bool> boolean(std::string_view key);
    /// A text, or a list of texts.
    std::vector<std::string> texts(std::string_view key);
    /// The tables of [[key]].
    std::vector<const ScriptValue*> tables(std::string_view key);
    /// The entries of the table at a key.
    std::vector<const ScriptValue::Entry*> entries(std::string_view key);
    /// A fault at a key's line, or the table's where the key is absent.
    void fault(std::string_view key, const std::string& message);
    /// Names the keys that nobody read.
    void finish();

private:
    [[nodiscard]] bool is_kind(const ScriptValue& value, ScriptValue::Kind kind, std::string_view key, const char* words);

    const ScriptValue& value_;
    ScriptFaults& faults_;
    std::set<std::string, std::less<>> known_;
};

/// The place of a name among others; a fault at the key, which names the nearest ones, and nothing for another name.
[[nodiscard]] std::optional<std::size_t> place_among(ScriptTable& table, std::string_view key, std::string_view name,
                                                     const std::vector<std::string>& names);

}  // namespace tedavis::host_sim

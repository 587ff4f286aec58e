/// Reads the keys of a table of a flight test and collects faults. A key that was not read is a fault, too.
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
    /// A value that is no table is a fault and is read as an empty table. Both arguments must outlive this object.
    ScriptTable(const ScriptValue& value, ScriptFaults& faults);

    [[nodiscard]] std::size_t line() const { return value_.line; }
    [[nodiscard]] const std::string& file() const { return value_.file; }
    [[nodiscard]] bool has(std::string_view key) const { return value_.find(key) != nullptr; }
    /// Returns the value of a key, or null, and marks the key as read.
    const ScriptValue* take(std::string_view key);
    /// These return nothing where the key is absent or has a fault. Numbers outside [low, high] and NaN are faults.
    std::optional<double> number(std::string_view key, double low, double high);
    std::optional<std::string> text(std::string_view key);
    std::optional<bool> boolean(std::string_view key);
    /// A text, or a list of texts.
    std::vector<std::string> texts(std::string_view key);
    /// The tables of [[key]].
    std::vector<const ScriptValue*> tables(std::string_view key);
    /// The entries of the table at a key.
    std::vector<const ScriptValue::Entry*> entries(std::string_view key);
    /// Adds a fault at the key's line, or at the table's where the key is absent.
    void fault(std::string_view key, const std::string& message);
    /// Adds a fault for each key that was not read.
    void finish();

private:
    [[nodiscard]] bool is_kind(const ScriptValue& value, ScriptValue::Kind kind, std::string_view key, const char* words);

    const ScriptValue& value_;
    ScriptFaults& faults_;
    std::set<std::string, std::less<>> known_;
};

/// Returns the index of a name in `names`. For any other name it adds a fault at the key, with the most similar names, and
/// returns nothing.
[[nodiscard]] std::optional<std::size_t> place_among(ScriptTable& table, std::string_view key, std::string_view name,
                                                     const std::vector<std::string>& names);

}  // namespace tedavis::host_sim

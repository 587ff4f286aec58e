/// A flight test's file as a tree of values, each with its line, and the faults that are found in it.
///
/// Faults are collected, so that all faults of a script are reported together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tedavis::host_sim {

/// Sentences "file:line: what is wrong; what to do".
class ScriptFaults {
public:
    void add(const std::string& file, std::size_t line, const std::string& message);
    [[nodiscard]] bool empty() const { return faults_.empty(); }
    [[nodiscard]] std::size_t count() const { return faults_.size(); }
    /// In the order of files and lines.
    [[nodiscard]] std::vector<std::string> sentences() const;

private:
    struct Fault {
        std::string file;
        std::size_t line = 0;
        std::string message;
    };
    std::vector<Fault> faults_;
};

/// A value as the file states it. Whole numbers are numbers.
struct ScriptValue {
    enum class Kind : std::uint8_t { text, number, boolean, list, table, faulty };  // faulty: its fault has been reported
    using Entry = std::pair<std::string, ScriptValue>;

    Kind kind = Kind::table;
    std::string text;
    double number = 0;
    bool boolean = false;
    std::vector<ScriptValue> items;  ///< of a list
    std::vector<Entry> entries;      ///< of a table, in the order of their lines
    std::string file;
    std::size_t line = 0, column = 0;

    /// Null where the table has no such key.
    [[nodiscard]] const ScriptValue* find(std::string_view key) const;
};

/// Parameters of scripts by their names: numbers and texts.
using ScriptParameters = std::map<std::string, ScriptValue>;

/// Parses TOML. A file that is no TOML is one fault, and the tree is empty.
[[nodiscard]] ScriptValue parse_script_value(std::string_view text, const std::string& file, ScriptFaults& faults);

/// Replaces each text "$name" by the parameter of this name, and "${name}" within texts and keys. An unknown name is a fault. The
/// names that occur are added to `used`.
void put_parameters(ScriptValue& value, const ScriptParameters& parameters, ScriptFaults& faults, std::set<std::string>& used);

/// The value of "--set name=value": a number where it is one, else a text.
[[nodiscard]] ScriptValue stated_parameter(const std::string& text);

}  // namespace tedavis::host_sim

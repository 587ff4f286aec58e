/// Reads TOML settings with units and ranges checked where they are read. Start-up only (allocates).
///
/// The first fault is kept as one sentence "file:line: what, what to do"; a faulty read returns the lower bound (empty
/// for texts), so a loader reads all keys and asks `finish()` once. A key that nobody read is a fault too: misspelt
/// settings are never ignored. Texts returned live as long as the reader.
///
/// A file may be based on others: the loader takes the key that says so and hands over what it names, before it reads the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <type_traits>

#include "render_core/base/error.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::base {

class ConfigReader;

/// A file that a key names, and the file that says so, from whose folder a relative path is meant.
struct StatedFile {
    std::string_view name, stated_in;
};

/// A table of the file; a section of a table that is absent reads as empty (every key at its fallback).
class ConfigSection {
public:
    [[nodiscard]] bool present() const { return table_ != nullptr; }
    [[nodiscard]] bool has(std::string_view key) const;

    /// With a fallback the key may be absent; without, absence is a fault. Numbers outside [low, high] and NaN are faults.
    double number(std::string_view key, double low, double high, double fallback);
    double number(std::string_view key, double low, double high);
    std::int64_t integer(std::string_view key, std::int64_t low, std::int64_t high, std::int64_t fallback);
    std::int64_t integer(std::string_view key, std::int64_t low, std::int64_t high);
    bool boolean(std::string_view key, bool fallback);
    std::string_view text(std::string_view key, std::string_view fallback);
    std::string_view text(std::string_view key);
    /// As text().
    StatedFile file(std::string_view key);
    /// Sets `value` (an enumeration, a bool or an index) to what the name at this key stands for: names[0] for `first`, the
    /// others for what follows it. Absent it stays; faults list the names and set `first`.
    template <class Value>
    void choose(std::string_view key, Span<const std::string_view> names, Value& value, Value first = Value()) {
        static_assert(std::is_enum_v<Value> || std::is_same_v<Value, bool> || std::is_same_v<Value, std::size_t>);
        if (has(key)) value = static_cast<Value>(static_cast<std::size_t>(first) + index_among(names, key));
    }
    /// Fills `out` from an array of exactly out.size() numbers; absent leaves it untouched.
    void numbers(std::string_view key, double low, double high, Span<double> out);
    /// How many elements an array has; 0 where it is absent. What is no array is a fault.
    [[nodiscard]] std::size_t element_count(std::string_view key);
    /// An array of texts; returns how many there are, writes at most out.size(), more is a fault.
    std::size_t texts(std::string_view key, Span<std::string_view> out);

    ConfigSection section(std::string_view key);
    /// Arrays of tables: [[key]].
    [[nodiscard]] std::size_t table_count(std::string_view key);
    ConfigSection table_at(std::string_view key, std::size_t index);
    /// Keys of this table in alphabetical order, to iterate tables whose names are data.
    [[nodiscard]] std::size_t key_count() const;
    [[nodiscard]] std::string_view key_at(std::size_t index) const;

    /// Forgets the key and what it says; texts that it returned are gone.
    void remove(std::string_view key);

    /// Reports a fault of the loader's own at this key's line.
    void fault(std::string_view key, std::string_view sentence);

private:
    friend class ConfigReader;
    ConfigSection(ConfigReader* reader, void* table) : reader_(reader), table_(table) {}
    void* find(std::string_view key, bool required);
    /// Where the text at this key stands among the names; 0 after a fault.
    std::size_t index_among(Span<const std::string_view> names, std::string_view key);
    ConfigReader* reader_;
    void* table_;
};

class ConfigReader {
public:
    /// `name` is how the file is called in messages.
    ConfigReader(std::string_view text, std::string_view name);
    ~ConfigReader();
    ConfigReader(const ConfigReader&) = delete;
    ConfigReader& operator=(const ConfigReader&) = delete;

    /// As it was given.
    [[nodiscard]] std::string_view name() const;
    [[nodiscard]] ConfigSection root();
    /// Adds what the file `name` says and this reader's does not say: tables key by key, at any depth, and lists of tables by the
    /// text `name` of each where this reader's tables all have one: equal names are one table, further tables stand behind those
    /// of `name`. Any other value of this reader's stays as it is. `own` are keys of the root that `name` keeps to itself. Faults
    /// name the file that says what is wrong.
    void inherit(std::string_view text, std::string_view name, Span<const std::string_view> own);
    /// True when nothing was wrong and every key was read.
    [[nodiscard]] bool finish();
    [[nodiscard]] bool ok() const;
    [[nodiscard]] const base::Error& error() const;

    /// What an inherited relative path is called in this reader's own file.
    using PathFrom = FixedString<1023> (*)(const StatedFile& stated, std::string_view own_file);
    /// All that the file says and inherits, as JSON; of inherited values those that were read by file() as `path_from` calls
    /// them.
    [[nodiscard]] std::string_view json(PathFrom path_from);

private:
    friend class ConfigSection;
    struct Document;
    void report(const void* node, std::string_view sentence);
    std::unique_ptr<Document> document_;
};

}  // namespace tedavis::base

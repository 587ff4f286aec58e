/// Reads TOML settings and checks units and ranges at each read. Start-up only (allocates).
///
/// Each fault is one sentence "file:line: what, what to do"; a faulty read returns the lower bound (an empty text for texts), so
/// a loader reads all keys and calls finish() once. A value has one fault at most, and a file that is not TOML that one alone.
/// Keys that were not read are faults where there is no other, so misspelt settings are never ignored. Returned texts live as
/// long as the reader.
///
/// A file may be based on other files: the loader reads the key that names them and passes their content to inherit() before it
/// reads the rest.
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

/// A file that a key names, and the file that contains the key; a relative path is relative to the latter's folder.
struct StatedFile {
    std::string_view name, stated_in;
};

/// Keys of a table that say the same in different units.
using KeyGroup = Span<const std::string_view>;

/// A table of the file. An absent table reads as an empty one (every key has its fallback).
class ConfigSection {
public:
    [[nodiscard]] bool present() const { return table_ != nullptr; }
    [[nodiscard]] bool has(std::string_view key) const;

    /// With a fallback the key may be absent; without one, absence is a fault. Numbers outside [low, high] and NaN are faults.
    double number(std::string_view key, double low, double high, double fallback);
    double number(std::string_view key, double low, double high);
    std::int64_t integer(std::string_view key, std::int64_t low, std::int64_t high, std::int64_t fallback);
    std::int64_t integer(std::string_view key, std::int64_t low, std::int64_t high);
    bool boolean(std::string_view key, bool fallback);
    std::string_view text(std::string_view key, std::string_view fallback);
    std::string_view text(std::string_view key);
    /// As text().
    StatedFile file(std::string_view key);
    /// Sets `value` (an enumeration, a bool or an index) from the name at this key: names[0] stands for `first`, the next names
    /// for the next values. If the key is absent, `value` is unchanged; a fault lists the names and sets `first`.
    template <class Value>
    void choose(std::string_view key, Span<const std::string_view> names, Value& value, Value first = Value()) {
        static_assert(std::is_enum_v<Value> || std::is_same_v<Value, bool> || std::is_same_v<Value, std::size_t>);
        if (has(key)) value = static_cast<Value>(static_cast<std::size_t>(first) + index_among(names, key));
    }
    /// Sets `value` (an enumeration) where a key is false, true or the text `word`: these stand for its first three values. If
    /// the key is absent, `value` is unchanged; a fault sets the first.
    template <class Value>
    void boolean_or(std::string_view key, std::string_view word, Value& value) {
        static_assert(std::is_enum_v<Value>);
        if (has(key)) value = static_cast<Value>(index_of_boolean_or(key, word));
    }
    /// Fills `out` from an array of exactly out.size() numbers; if the key is absent, `out` is unchanged.
    void numbers(std::string_view key, double low, double high, Span<double> out);
    /// Number of elements of an array; 0 if the key is absent. A value that is not an array is a fault.
    [[nodiscard]] std::size_t element_count(std::string_view key);
    /// Reads an array of texts: writes at most out.size() and returns the number there are. More than out.size() is a fault.
    std::size_t texts(std::string_view key, Span<std::string_view> out);

    ConfigSection section(std::string_view key);
    /// Arrays of tables: [[key]].
    [[nodiscard]] std::size_t table_count(std::string_view key);
    ConfigSection table_at(std::string_view key, std::size_t index);
    /// Keys of this table in alphabetical order, to iterate tables whose names are data.
    [[nodiscard]] std::size_t key_count() const;
    [[nodiscard]] std::string_view key_at(std::size_t index) const;

    /// Removes the key with its value; texts read from it become invalid.
    void remove(std::string_view key);

    /// Reports a fault found by the loader, at this key's line.
    void fault(std::string_view key, std::string_view message);

private:
    friend class ConfigReader;
    ConfigSection(ConfigReader* reader, void* table) : reader_(reader), table_(table) {}
    void* find(std::string_view key, bool required);
    /// Index of the key's text among the names; 0 after a fault.
    std::size_t index_among(Span<const std::string_view> names, std::string_view key);
    /// 0 for false and after a fault, 1 for true, 2 for the word.
    std::size_t index_of_boolean_or(std::string_view key, std::string_view word);
    ConfigReader* reader_;
    void* table_;
};

class ConfigReader {
public:
    /// `name` is the file's name in error messages.
    ConfigReader(std::string_view text, std::string_view name);
    ~ConfigReader();
    ConfigReader(const ConfigReader&) = delete;
    ConfigReader& operator=(const ConfigReader&) = delete;

    /// The name passed to the constructor.
    [[nodiscard]] std::string_view name() const;
    [[nodiscard]] ConfigSection root();
    /// Adds the settings of the file `name` that this reader's file does not have. Tables are merged key by key at any depth.
    /// Arrays of tables are merged by the key "name" where all tables of this reader have one: tables with the same name are
    /// merged, further ones follow those of `name`. Any other value of this reader is kept. `own` lists root keys of `name`
    /// that are not inherited; of the keys of a group of `alternatives`, in whatever table, one that is stated here stands for
    /// all. Faults name the file that contains the wrong value.
    void inherit(std::string_view text, std::string_view name, Span<const std::string_view> own,
                 Span<const KeyGroup> alternatives = {});
    /// True when nothing was wrong and every key was read.
    [[nodiscard]] bool finish();
    [[nodiscard]] bool ok() const;
    /// The first fault; empty where there is none.
    [[nodiscard]] const base::Error& error() const;
    /// The first 32 faults in the order in which they were found; they live as long as the reader.
    [[nodiscard]] Span<const base::Error> errors() const;

    /// Returns how an inherited relative path is written in this reader's own file.
    using PathFrom = FixedString<1023> (*)(const StatedFile& stated, std::string_view own_file);
    /// Returns all settings, inherited ones included, as JSON; inherited values that were read by file() are rewritten by
    /// `path_from`.
    [[nodiscard]] std::string_view json(PathFrom path_from);

private:
    friend class ConfigSection;
    struct Document;
    void report(const void* node, std::string_view message);
    std::unique_ptr<Document> document_;
};

}  // namespace tedavis::base

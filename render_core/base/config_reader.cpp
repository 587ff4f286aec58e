#include "render_core/base/config_reader.hpp"

#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wnull-dereference"
#include <toml++/toml.h>
#include <algorithm>
#pragma GCC diagnostic pop

#include <cmath>
#include <cstdio>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace tedavis::base {

struct ConfigReader::Document {
    std::string name;
    toml::table root;
    std::set<const toml::node*> read;
    std::set<toml::node*> files;  ///< values that name a file
    std::string json;             ///< printed last
    std::vector<base::Error> errors;
    std::set<const toml::node*> faulty;  ///< values that have a fault
    bool is_toml = true;

    void report(const toml::source_region& place, std::string_view message);
    void report_parse_error(const toml::parse_error& error);
};

namespace {

constexpr std::size_t kMaxFaults = 32;  // more are not kept

toml::table& as_table(void* table) { return *static_cast<toml::table*>(table); }
toml::node& as_node(void* node) { return *static_cast<toml::node*>(node); }

std::string_view file_of(const toml::node& node) {
    const auto& path = node.source().path;
    return path ? std::string_view(*path) : std::string_view();
}

std::string printed(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string quoted(std::string_view key) { return "'" + std::string(key) + "'"; }

struct UnreadKey {
    const toml::node* node;
    std::string path;
};

/// The nodes below `table` that were never read. Depth is bounded by the document's own nesting.
std::vector<UnreadKey> unread_keys(const toml::table& root, const std::set<const toml::node*>& read) {
    std::vector<UnreadKey> found;
    std::vector<std::pair<const toml::table*, std::string>> open{{&root, ""}};
    while (!open.empty()) {
        auto [table, prefix] = open.back();
        open.pop_back();
        for (const auto& [key, node] : *table) {
            const std::string full = prefix + std::string(key.str());
            if (read.count(&node) == 0) {
                found.push_back({&node, full});
                continue;
            }
            if (const toml::table* child = node.as_table()) open.emplace_back(child, full + ".");
            if (const toml::array* array = node.as_array())
                for (const toml::node& element : *array)
                    if (const toml::table* child = element.as_table()) open.emplace_back(child, full + ".");
        }
    }
    return found;
}

/// The text `name` of a table; empty where there is none.
std::string_view name_of(const toml::node& node) {
    const toml::table* const table = node.as_table();
    const toml::node* const name = table != nullptr ? table->get("name") : nullptr;
    return name != nullptr ? name->value_exact<std::string_view>().value_or("") : std::string_view();
}

bool all_have_names(const toml::array& list) {
    for (const toml::node& element : list)
        if (name_of(element).empty()) return false;
    return !list.empty();
}

/// A table, and the one that it is based on.
struct BasedTable {
    toml::table *own, *base;
};

/// Brings the own list into the order of the base's, and adds what only that has; tables of one name are left to be merged.
void inherit_list(toml::array& own, toml::array& base, std::vector<BasedTable>& open) {
    if (!all_have_names(own) || !base.is_homogeneous<toml::table>()) return;
    for (std::size_t n = 0; n < base.size(); ++n) {
        std::size_t same = n;
        while (same < own.size() && name_of(own[same]) != name_of(base[n])) ++same;
        const bool is_own = same < own.size();
        toml::table moved = std::move(is_own ? *own[same].as_table() : *base[n].as_table());
        if (is_own) own.erase(own.begin() + static_cast<std::ptrdiff_t>(same));
        own.insert(own.begin() + static_cast<std::ptrdiff_t>(n), std::move(moved));
        if (is_own) open.push_back({own[n].as_table(), base[n].as_table()});
    }
}

/// True where the table says the same by another key of the group.
bool has_alternative(const toml::table& own, std::string_view key, Span<const KeyGroup> alternatives) {
    for (const KeyGroup& group : alternatives) {
        if (std::find(group.begin(), group.end(), key) == group.end()) continue;
        for (const std::string_view other : group)
            if (own.contains(other)) return true;
    }
    return false;
}

/// Moves into the first table what it does not say itself; what is moved keeps its place in its file. What it says by one key of
/// `alternatives` it does not inherit by another.
void inherit_tables(toml::table& root, toml::table& base_root, Span<const KeyGroup> alternatives) {
    std::vector<BasedTable> open{{&root, &base_root}};
    while (!open.empty()) {
        const auto [own, base] = open.back();
        open.pop_back();
        for (auto&& [key, node] : *base) {
            toml::node* const said = own->get(key.str());
            if (said == nullptr && has_alternative(*own, key.str(), alternatives)) continue;
            if (said == nullptr)
                node.visit([table = own, &at = key](auto& value) { table->insert(at.str(), std::move(value)); });
            else if (said->is_table() && node.is_table())
                open.push_back({said->as_table(), node.as_table()});
            else if (said->is_array() && node.is_array())
                inherit_list(*said->as_array(), *node.as_array(), open);
        }
    }
}

}  // namespace

ConfigReader::ConfigReader(std::string_view text, std::string_view name) : document_(std::make_unique<Document>()) {
    document_->name = std::string(name);
    toml::parse_result parsed = toml::parse(text, document_->name);
    if (parsed) {
        document_->root = std::move(parsed).table();
    } else {
        document_->report_parse_error(parsed.error());
    }
}

ConfigReader::~ConfigReader() = default;

std::string_view ConfigReader::name() const { return document_->name; }

ConfigSection ConfigReader::root() { return {this, &document_->root}; }

void ConfigReader::inherit(std::string_view text, std::string_view name, Span<const std::string_view> own,
                           Span<const KeyGroup> alternatives) {
    toml::parse_result parsed = toml::parse(text, name);
    if (!parsed) return document_->report_parse_error(parsed.error());
    toml::table base = std::move(parsed).table();
    for (const std::string_view key : own) base.erase(key);
    inherit_tables(document_->root, base, alternatives);
}

bool ConfigReader::finish() {
    if (!ok()) return false;
    for (const UnreadKey& unread : unread_keys(document_->root, document_->read))
        report(unread.node, "unknown key " + quoted(unread.path) + "; correct or remove it");
    return ok();
}

bool ConfigReader::ok() const { return document_->errors.empty(); }

const base::Error& ConfigReader::error() const {
    static const base::Error kNone;
    return ok() ? kNone : document_->errors.front();
}

Span<const base::Error> ConfigReader::errors() const { return {document_->errors.data(), document_->errors.size()}; }

std::string_view ConfigReader::json(PathFrom path_from) {
    for (toml::node* const node : document_->files) {
        toml::value<std::string>& path = *node->as_string();
        if (file_of(path) != document_->name) path = std::string(path_from({*path, file_of(path)}, document_->name).view());
    }
    document_->files.clear();
    std::ostringstream text;
    text << toml::json_formatter(document_->root);
    document_->json = std::move(text).str();
    return document_->json;
}

/// Of a table there may be several faults: a key that is missing is one of its table.
void ConfigReader::report(const void* node, std::string_view message) {
    const auto* const place = static_cast<const toml::node*>(node);
    if (place != nullptr && !place->is_table() && !document_->faulty.insert(place).second) return;
    document_->report(place != nullptr ? place->source() : toml::source_region(), message);
}

/// What was reported before stays the first fault; what would follow from the missing content is not reported.
void ConfigReader::Document::report_parse_error(const toml::parse_error& error) {
    report(error.source(), std::string(error.description()) + "; mend the TOML there");
    is_toml = false;
}

void ConfigReader::Document::report(const toml::source_region& place, std::string_view message) {
    if (!is_toml || errors.size() == kMaxFaults) return;
    base::Error& error = errors.emplace_back();
    error.message.append(place.path ? *place.path : name);
    if (place.begin.line > 0) error.message.append(":" + std::to_string(place.begin.line));
    error.message.append(": ");
    error.message.append(message);
}

bool ConfigSection::has(std::string_view key) const { return table_ != nullptr && as_table(table_).contains(key); }

void* ConfigSection::find(std::string_view key, bool required) {
    toml::node* const node = table_ != nullptr ? as_table(table_).get(key) : nullptr;
    if (node != nullptr) {
        reader_->document_->read.insert(node);
    } else if (required) {
        const toml::node* const table = table_ != nullptr ? &as_table(table_) : nullptr;
        reader_->report(table, "key " + quoted(key) + " is missing; add it");
    }
    return node;
}

double ConfigSection::number(std::string_view key, double low, double high, double fallback) {
    return has(key) ? number(key, low, high) : fallback;
}

double ConfigSection::number(std::string_view key, double low, double high) {
    void* const found = find(key, true);
    if (found == nullptr) return low;
    const auto value = as_node(found).value<double>();
    if (value && *value >= low && *value <= high) return *value;
    reader_->report(found, quoted(key) + " must be a number from " + printed(low) + " to " + printed(high));
    return low;
}

std::int64_t ConfigSection::integer(std::string_view key, std::int64_t low, std::int64_t high, std::int64_t fallback) {
    return has(key) ? integer(key, low, high) : fallback;
}

std::int64_t ConfigSection::integer(std::string_view key, std::int64_t low, std::int64_t high) {
    void* const found = find(key, true);
    if (found == nullptr) return low;
    const auto value = as_node(found).value_exact<std::int64_t>();
    if (value && *value >= low && *value <= high) return *value;
    reader_->report(found, quoted(key) + " must be a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return low;
}

bool ConfigSection::boolean(std::string_view key, bool fallback) {
    void* const found = find(key, false);
    if (found == nullptr) return fallback;
    const auto value = as_node(found).value_exact<bool>();
    if (!value) reader_->report(found, quoted(key) + " must be true or false");
    return value.value_or(fallback);
}

std::string_view ConfigSection::text(std::string_view key, std::string_view fallback) { return has(key) ? text(key) : fallback; }

std::string_view ConfigSection::text(std::string_view key) {
    void* const found = find(key, true);
    if (found == nullptr) return {};
    const auto value = as_node(found).value_exact<std::string_view>();
    if (!value) reader_->report(found, quoted(key) + " must be a text in quotes");
    return value.value_or(std::string_view());
}

StatedFile ConfigSection::file(std::string_view key) {
    const std::string_view name = text(key);
    toml::node* const node = table_ != nullptr ? as_table(table_).get(key) : nullptr;
    if (node == nullptr || !node->is_string()) return {};
    reader_->document_->files.insert(node);
    return {name, file_of(*node)};
}

std::size_t ConfigSection::index_among(Span<const std::string_view> names, std::string_view key) {
    const std::string_view value = text(key);
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (value == names[i]) return i;
        list += (i > 0 ? ", " : "") + std::string(names[i]);
    }
    fault(key, quoted(key) + " must be one of: " + list);
    return 0;
}

std::size_t ConfigSection::index_of_boolean_or(std::string_view key, std::string_view word) {
    void* const found = find(key, true);
    if (found == nullptr) return 0;
    if (as_node(found).value_exact<std::string_view>() == word) return 2;
    const auto value = as_node(found).value_exact<bool>();
    if (!value) reader_->report(found, quoted(key) + " must be true, false or \"" + std::string(word) + "\"");
    return value.value_or(false) ? 1 : 0;
}

void ConfigSection::numbers(std::string_view key, double low, double high, Span<double> out) {
    void* const found = find(key, false);
    if (found == nullptr) return;
    const toml::array* array = as_node(found).as_array();
    bool good = array != nullptr && array->size() == out.size();
    for (std::size_t i = 0; good && i < out.size(); ++i) {
        const auto value = array->get(i)->value<double>();
        good = value && *value >= low && *value <= high;
        if (good) out[i] = *value;
    }
    if (!good)
        reader_->report(found, quoted(key) + " must be " + std::to_string(out.size()) + " numbers from " + printed(low) + " to " +
                                   printed(high));
}

std::size_t ConfigSection::element_count(std::string_view key) {
    void* const found = find(key, false);
    if (found == nullptr) return 0;
    const toml::array* array = as_node(found).as_array();
    if (array != nullptr) return array->size();
    fault(key, quoted(key) + " must be an array such as [1, 2]");
    return 0;
}

std::size_t ConfigSection::texts(std::string_view key, Span<std::string_view> out) {
    void* const found = find(key, false);
    if (found == nullptr) return 0;
    const toml::array* array = as_node(found).as_array();
    bool good = array != nullptr && array->size() <= out.size();
    const std::size_t count = good ? array->size() : 0;
    for (std::size_t i = 0; good && i < count; ++i) {
        const auto value = array->get(i)->value_exact<std::string_view>();
        good = value.has_value();
        out[i] = value.value_or(std::string_view());
    }
    if (!good) fault(key, quoted(key) + " must be a list of at most " + std::to_string(out.size()) + " texts");
    return count;
}

ConfigSection ConfigSection::section(std::string_view key) {
    void* const found = find(key, false);
    toml::table* table = found != nullptr ? as_node(found).as_table() : nullptr;
    if (found != nullptr && table == nullptr) fault(key, quoted(key) + " must be a table");
    return {reader_, table};
}

std::size_t ConfigSection::table_count(std::string_view key) {
    void* const found = find(key, false);
    if (found == nullptr) return 0;
    const toml::array* array = as_node(found).as_array();
    if (array != nullptr && array->empty()) return 0;
    if (array == nullptr || !array->is_homogeneous<toml::table>()) {
        fault(key, quoted(key) + " must be written as [[" + std::string(key) + "]] tables");
        return 0;
    }
    return array->size();
}

ConfigSection ConfigSection::table_at(std::string_view key, std::size_t index) {
    toml::node* const node = table_ != nullptr ? as_table(table_).get(key) : nullptr;
    toml::array* const array = node != nullptr ? node->as_array() : nullptr;
    return {reader_, array != nullptr && index < array->size() ? array->get(index)->as_table() : nullptr};
}

std::size_t ConfigSection::key_count() const { return table_ != nullptr ? as_table(table_).size() : 0; }

std::string_view ConfigSection::key_at(std::size_t index) const {
    std::size_t i = 0;
    if (table_ != nullptr)
        for (const auto& [key, node] : as_table(table_))
            if (i++ == index) return key.str();  // alphabetical: toml::table is ordered
    return {};
}

void ConfigSection::fault(std::string_view key, std::string_view message) {
    const toml::node* node = table_ != nullptr ? as_table(table_).get(key) : nullptr;
    reader_->report(node, message);
}

void ConfigSection::remove(std::string_view key) {
    if (table_ == nullptr) return;
    toml::node* const node = as_table(table_).get(key);
    reader_->document_->read.erase(node);
    reader_->document_->faulty.erase(node);
    reader_->document_->files.erase(node);
    as_table(table_).erase(key);
}

}  // namespace tedavis::base

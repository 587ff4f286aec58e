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
#pragma GCC diagnostic pop

#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <vector>

namespace tedavis::base {

struct ConfigReader::Document {
    std::string name;
    toml::table root;
    std::set<const toml::node*> read;
    base::Error error;
    bool failed = false;
};

namespace {

const toml::table& as_table(const void* table) { return *static_cast<const toml::table*>(table); }
const toml::node& as_node(const void* node) { return *static_cast<const toml::node*>(node); }
std::uint32_t line_of(const toml::node& node) { return node.source().begin.line; }

std::string printed(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string quoted(std::string_view key) { return "'" + std::string(key) + "'"; }

/// The first node below `table` that was never read, or null. Depth is bounded by the document's own nesting.
const toml::node* first_unread(const toml::table& root, const std::set<const toml::node*>& read, std::string& path) {
    std::vector<std::pair<const toml::table*, std::string>> open{{&root, ""}};
    while (!open.empty()) {
        auto [table, prefix] = open.back();
        open.pop_back();
        for (const auto& [key, node] : *table) {
            const std::string full = prefix + std::string(key.str());
            if (read.count(&node) == 0) {
                path = full;
                return &node;
            }
            if (const toml::table* child = node.as_table()) open.emplace_back(child, full + ".");
            if (const toml::array* array = node.as_array())
                for (const toml::node& element : *array)
                    if (const toml::table* child = element.as_table()) open.emplace_back(child, full + ".");
        }
    }
    return nullptr;
}

}  // namespace

ConfigReader::ConfigReader(std::string_view text, std::string_view name) : document_(std::make_unique<Document>()) {
    document_->name = std::string(name);
    toml::parse_result parsed = toml::parse(text, document_->name);
    if (parsed) {
        document_->root = std::move(parsed).table();
    } else {
        report(parsed.error().source().begin.line, std::string(parsed.error().description()) + "; mend the TOML there");
    }
}

ConfigReader::~ConfigReader() = default;

ConfigSection ConfigReader::root() { return {this, &document_->root}; }

bool ConfigReader::finish() {
    std::string path;
    if (const toml::node* unread = ok() ? first_unread(document_->root, document_->read, path) : nullptr)
        report(line_of(*unread), "unknown key " + quoted(path) + "; correct or remove it");
    return ok();
}

bool ConfigReader::ok() const { return !document_->failed; }
const base::Error& ConfigReader::error() const { return document_->error; }

void ConfigReader::report(std::uint32_t line, std::string_view sentence) {
    if (document_->failed) return;
    document_->failed = true;
    document_->error.message.append(document_->name);
    if (line > 0) document_->error.message.append(":" + std::to_string(line));
    document_->error.message.append(": ");
    document_->error.message.append(sentence);
}

bool ConfigSection::has(std::string_view key) const { return table_ != nullptr && as_table(table_).contains(key); }

const void* ConfigSection::find(std::string_view key, bool required) {
    const toml::node* node = table_ != nullptr ? as_table(table_).get(key) : nullptr;
    if (node != nullptr) {
        reader_->document_->read.insert(node);
    } else if (required) {
        const std::uint32_t line = table_ != nullptr ? line_of(as_table(table_)) : 0;
        reader_->report(line, "key " + quoted(key) + " is missing; add it");
    }
    return node;
}

double ConfigSection::number(std::string_view key, double low, double high, double fallback) {
    return has(key) ? number(key, low, high) : fallback;
}

double ConfigSection::number(std::string_view key, double low, double high) {
    const void* found = find(key, true);
    if (found == nullptr) return low;
    const auto value = as_node(found).value<double>();
    if (value && *value >= low && *value <= high) return *value;
    reader_->report(line_of(as_node(found)), quoted(key) + " must be a number from " + printed(low) + " to " + printed(high));
    return low;
}

std::int64_t ConfigSection::integer(std::string_view key, std::int64_t low, std::int64_t high, std::int64_t fallback) {
    return has(key) ? integer(key, low, high) : fallback;
}

std::int64_t ConfigSection::integer(std::string_view key, std::int64_t low, std::int64_t high) {
    const void* found = find(key, true);
    if (found == nullptr) return low;
    const auto value = as_node(found).value_exact<std::int64_t>();
    if (value && *value >= low && *value <= high) return *value;
    reader_->report(line_of(as_node(found)),
                    quoted(key) + " must be a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return low;
}

bool ConfigSection::boolean(std::string_view key, bool fallback) {
    const void* found = find(key, false);
    if (found == nullptr) return fallback;
    const auto value = as_node(found).value_exact<bool>();
    if (!value) reader_->report(line_of(as_node(found)), quoted(key) + " must be true or false");
    return value.value_or(fallback);
}

std::string_view ConfigSection::text(std::string_view key, std::string_view fallback) { return has(key) ? text(key) : fallback; }

std::string_view ConfigSection::text(std::string_view key) {
    const void* found = find(key, true);
    if (found == nullptr) return {};
    const auto value = as_node(found).value_exact<std::string_view>();
    if (!value) reader_->report(line_of(as_node(found)), quoted(key) + " must be a text in quotes");
    return value.value_or(std::string_view());
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

void ConfigSection::numbers(std::string_view key, double low, double high, Span<double> out) {
    const void* found = find(key, false);
    if (found == nullptr) return;
    const toml::array* array = as_node(found).as_array();
    bool good = array != nullptr && array->size() == out.size();
    for (std::size_t i = 0; good && i < out.size(); ++i) {
        const auto value = array->get(i)->value<double>();
        good = value && *value >= low && *value <= high;
        if (good) out[i] = *value;
    }
    if (!good)
        reader_->report(line_of(as_node(found)), quoted(key) + " must be " + std::to_string(out.size()) + " numbers from " +
                                                     printed(low) + " to " + printed(high));
}

std::size_t ConfigSection::element_count(std::string_view key) {
    const void* found = find(key, false);
    if (found == nullptr) return 0;
    const toml::array* array = as_node(found).as_array();
    if (array != nullptr) return array->size();
    fault(key, quoted(key) + " must be an array such as [1, 2]");
    return 0;
}

std::size_t ConfigSection::texts(std::string_view key, Span<std::string_view> out) {
    const void* found = find(key, false);
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
    const void* found = find(key, false);
    const toml::table* table = found != nullptr ? as_node(found).as_table() : nullptr;
    if (found != nullptr && table == nullptr) fault(key, quoted(key) + " must be a table");
    return {reader_, table};
}

std::size_t ConfigSection::table_count(std::string_view key) {
    const void* found = find(key, false);
    if (found == nullptr) return 0;
    const toml::array* array = as_node(found).as_array();
    if (array == nullptr || !array->is_homogeneous<toml::table>()) {
        fault(key, quoted(key) + " must be written as [[" + std::string(key) + "]] tables");
        return 0;
    }
    return array->size();
}

ConfigSection ConfigSection::table_at(std::string_view key, std::size_t index) {
    const toml::node* node = table_ != nullptr ? as_table(table_).get(key) : nullptr;
    const toml::array* array = node != nullptr ? node->as_array() : nullptr;
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

void ConfigSection::fault(std::string_view key, std::string_view sentence) {
    const toml::node* node = table_ != nullptr ? as_table(table_).get(key) : nullptr;
    reader_->report(node != nullptr ? line_of(*node) : 0, sentence);
}

}  // namespace tedavis::base

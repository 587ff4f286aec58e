#include "host_sim/toml_text.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "host_sim/json_text.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kBareKeyLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";

/// A text of JSON is one of TOML, too.
std::string key_text(const std::string& key) {
    const bool is_bare = !key.empty() && key.find_first_not_of(kBareKeyLetters) == std::string::npos;
    return is_bare ? key : json_text(Json(key));
}

bool is_list_of_tables(const Json& value) { return value.is_array() && !value.empty() && value.front().is_object(); }

/// A value on one line.
std::string value_text(const Json& value) {
    if (!value.is_array()) return json_text(value);
    std::string text;
    for (const Json& element : value) text += (text.empty() ? "" : ", ") + json_text(element);
    return "[" + text + "]";
}

bool has_lines(const Json& table) {
    for (const Json& value : table)
        if (!value.is_object() && !is_list_of_tables(value)) return true;
    return table.empty();
}

/// `path` is empty, or ends in a dot.
void write(const Json& table, const std::string& path, std::string& text) {
    for (const auto& [key, value] : table.items())
        if (!value.is_object() && !is_list_of_tables(value)) text += key_text(key) + " = " + value_text(value) + "\n";
    for (const auto& [key, value] : table.items()) {
        const std::string name = path + key_text(key);
        if (value.is_object()) {
            if (has_lines(value)) text += "\n[" + name + "]\n";
            write(value, name + ".", text);
        } else if (is_list_of_tables(value)) {
            for (const Json& element : value) {
                text += "\n[[" + name + "]]\n";
                write(element, name + ".", text);
            }
        }
    }
}

}  // namespace

std::string toml_text(const Json& table) {
    std::string text;
    write(table, "", text);
    return text;
}

std::string toml_string(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        char escaped[8];
        std::snprintf(escaped, sizeof escaped, "\\u%04x", byte);
        if (byte < 0x20 || byte == 0x7f)
            out += escaped;
        else
            out += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    }
    return out + '"';
}

}  // namespace tedavis::host_sim

#include "host_sim/flight_test/script_value.hpp"

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "host_sim/name_choices.hpp"

namespace tedavis::host_sim {
namespace {

ScriptValue script_value_of(const toml::node& node, const std::string& file);

void add_table(const toml::table& table, const std::string& file, ScriptValue& value) {
    for (const auto& [key, node] : table) value.entries.emplace_back(std::string(key.str()), script_value_of(node, file));
    std::stable_sort(value.entries.begin(), value.entries.end(), [](const auto& a, const auto& b) {
        return std::pair(a.second.line, a.second.column) < std::pair(b.second.line, b.second.column);
    });
}

ScriptValue script_value_of(const toml::node& node, const std::string& file) {
    ScriptValue value;
    value.file = file;
    value.line = node.source().begin.line;
    value.column = node.source().begin.column;
    if (const toml::table* const table = node.as_table(); table != nullptr) {
        add_table(*table, file, value);
    } else if (const toml::array* const list = node.as_array(); list != nullptr) {
        value.kind = ScriptValue::Kind::list;
        for (const toml::node& item : *list) value.items.push_back(script_value_of(item, file));
    } else if (node.is_boolean()) {
        value.kind = ScriptValue::Kind::boolean;
        value.boolean = node.value_or(false);
    } else if (node.is_number()) {
        value.kind = ScriptValue::Kind::number;
        value.number = node.value_or(0.0);
    } else {
        value.kind = ScriptValue::Kind::text;
        value.text = node.value_or(std::string());
    }
    return value;
}

std::string plain_number(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", number);
    return text;
}

struct ParameterWriter {
    const ScriptParameters& parameters;
    ScriptFaults& faults;
    std::set<std::string>& used;

    /// Null where there is no such parameter; `from` has the place of the fault.
    [[nodiscard]] const ScriptValue* find(const std::string& name, const ScriptValue& from) const {
        used.insert(name);
        const auto found = parameters.find(name);
        if (found != parameters.end()) return &found->second;
        std::vector<std::string> names;
        for (const auto& [known, parameter] : parameters) names.push_back(known);
        faults.add(from.file, from.line, "'$" + name + "' is no parameter; [parameters] has: " + name_choices(names));
        return nullptr;
    }

    /// The text with each "${name}" replaced.
    [[nodiscard]] std::string with_parameters(const std::string& text, const ScriptValue& from) const {
        std::string written;
        std::size_t done = 0;
        for (std::size_t at = text.find("${"); at != std::string::npos; at = text.find("${", done)) {
            const std::size_t end = text.find('}', at);
            if (end == std::string::npos) break;
            const ScriptValue* const found = find(text.substr(at + 2, end - at - 2), from);
            written += text.substr(done, at - done);
            if (found != nullptr) written += found->kind == ScriptValue::Kind::number ? plain_number(found->number) : found->text;
            done = end + 1;
        }
        return written + text.substr(done);
    }
};

}  // namespace

void ScriptFaults::add(const std::string& file, std::size_t line, const std::string& message) {
    faults_.push_back({file, line, message});
}

std::vector<std::string> ScriptFaults::sentences() const {
    std::vector<Fault> sorted = faults_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Fault& a, const Fault& b) { return a.file == b.file ? a.line < b.line : a.file < b.file; });
    std::vector<std::string> all;
    for (const Fault& fault : sorted) all.push_back(fault.file + ":" + std::to_string(fault.line) + ": " + fault.message);
    return all;
}

const ScriptValue* ScriptValue::find(std::string_view key) const {
    for (const Entry& entry : entries)
        if (entry.first == key) return &entry.second;
    return nullptr;
}

ScriptValue parse_script_value(std::string_view text, const std::string& file, ScriptFaults& faults) {
    const toml::parse_result parsed = toml::parse(text, file);
    if (parsed) return script_value_of(parsed.table(), file);
    faults.add(file, parsed.error().source().begin.line, std::string(parsed.error().description()) + "; correct the TOML there");
    ScriptValue nothing;
    nothing.file = file;
    return nothing;
}

void put_parameters(ScriptValue& value, const ScriptParameters& parameters, ScriptFaults& faults, std::set<std::string>& used) {
    const ParameterWriter writer{parameters, faults, used};
    for (ScriptValue& item : value.items) put_parameters(item, parameters, faults, used);
    for (ScriptValue::Entry& entry : value.entries) {
        entry.first = writer.with_parameters(entry.first, entry.second);
        put_parameters(entry.second, parameters, faults, used);
    }
    if (value.kind != ScriptValue::Kind::text) return;
    if (value.text.size() < 2 || value.text.front() != '$' || value.text[1] == '{') {
        value.text = writer.with_parameters(value.text, value);
        return;
    }
    const ScriptValue* const found = writer.find(value.text.substr(1), value);
    value.kind = found == nullptr ? ScriptValue::Kind::faulty : found->kind;
    if (found == nullptr) return;
    value.text = found->text;
    value.number = found->number;
}

ScriptValue stated_parameter(const std::string& text) {
    ScriptValue value;
    char* end = nullptr;
    value.number = std::strtod(text.c_str(), &end);
    const bool is_number = !text.empty() && end == text.c_str() + text.size();
    value.kind = is_number ? ScriptValue::Kind::number : ScriptValue::Kind::text;
    value.text = text;
    return value;
}

}  // namespace tedavis::host_sim

#include "host_sim/flight_test/recorded_script.hpp"

#include <cstdio>
#include <filesystem>

#include "host_sim/toml_text.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kTextWidth = 110;

/// Lines that begin with "# ", broken at blanks; control characters become blanks.
std::string comment(const std::string& text) {
    std::string lines, line = "#", word;
    const auto end_word = [&] {
        if (word.empty()) return;
        if (line.size() > 1 && line.size() + 1 + word.size() > kTextWidth) {
            lines += line + "\n";
            line = "#";
        }
        line += " " + word;
        word.clear();
    };
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte <= 0x20 || byte == 0x7f)
            end_word();
        else
            word += c;
    }
    end_word();
    return lines + line + "\n";
}

std::string seconds_key(const char* key, double seconds) {
    char text[64];
    std::snprintf(text, sizeof text, "%s = %.10g\n", key, seconds);
    return text;
}

std::string window_text(const RecordedExpectation& one) {
    if (one.kind == WindowKind::at) return seconds_key("at_s", one.from_s);
    if (one.kind == WindowKind::during) return seconds_key("from_s", one.from_s) + seconds_key("to_s", one.to_s);
    return seconds_key("after_s", one.from_s) + seconds_key("within_s", one.to_s - one.from_s);
}

/// flags = ["a", "b"], a name a line where they are many.
std::string list_text(const char* key, const std::vector<std::string>& names) {
    if (names.empty()) return "";
    std::string row, rows;
    for (const std::string& name : names) {
        row += (row.empty() ? "" : ", ") + toml_string(name);
        rows += "    " + toml_string(name) + ",\n";
    }
    const std::string line = std::string(key) + " = [" + row + "]\n";
    return line.size() <= kTextWidth ? line : std::string(key) + " = [\n" + rows + "]\n";
}

/// signals = { a = "lost" }, a line for each where they are many.
std::string table_text(const char* key, const std::vector<RecordedScript::Named>& entries) {
    if (entries.empty()) return "";
    std::string row, rows;
    for (const auto& [name, value] : entries) {
        row += (row.empty() ? "" : ", ") + name + " = " + toml_string(value);
        rows += std::string(key) + "." + name + " = " + toml_string(value) + "\n";
    }
    const std::string line = std::string(key) + " = { " + row + " }\n";
    return line.size() <= kTextWidth ? line : rows;
}

std::string conditions_text(const RecordedExpectation& one) {
    std::string text;
    std::vector<std::string> there, gone;
    std::vector<RecordedScript::Named> signals, effects;
    const auto word = [&](const char* key, const std::string& value) { text += key + (" = " + toml_string(value)) + "\n"; };
    for (const RecordedFact& fact : one.facts) switch (fact.kind) {
            case FactKind::phase: word("phase", fact.value); break;
            case FactKind::phase_source: word("phase_source", fact.value); break;
            case FactKind::design: word("design", fact.value); break;
            case FactKind::alert: word("alert", fact.value); break;
            case FactKind::obstacle_alert: word("obstacle_alert", fact.value); break;
            case FactKind::signal: signals.emplace_back(fact.name, fact.value); break;
            case FactKind::flag: (fact.value == kFlagThere ? there : gone).push_back(fact.name); break;
            case FactKind::effect: effects.emplace_back(fact.name, fact.value); break;
        }
    return text + list_text("flags", there) + list_text("no_flags", gone) + table_text("signals", signals) +
           table_text("effects", effects);
}

std::string named_text(const std::vector<RecordedScript::Named>& named) {
    std::string text;
    for (const auto& [key, value] : named)
        if (!value.empty()) text += key + " = " + toml_string(value) + "\n";
    return text;
}

}  // namespace

std::string recorded_script_text(const RecordedScript& script) {
    std::string text = "title = " + toml_string(script.title) + "\n";
    for (const std::string& note : script.notes) text += comment(note);
    text += named_text(script.settings) + "\n[input]\n" + named_text(script.input);
    for (const RecordedExpectation& one : script.expectations)
        text += "\n" + comment(one.words) + "[[expect]]\n" + window_text(one) + conditions_text(one);
    return text;
}

std::string path_in_script(const std::string& path, const std::string& folder) {
    namespace fs = std::filesystem;
    const fs::path plain = fs::absolute(folder.empty() ? "." : folder).lexically_normal() / "";
    const fs::path file = fs::weakly_canonical(path), from = fs::weakly_canonical(plain);
    const fs::path relative = file.lexically_relative(from);
    const bool goes_up = *relative.begin() == "..";
    fs::path ancestor = from / "";
    for (const fs::path& part : relative)
        if (part == "..") ancestor = ancestor.parent_path().parent_path() / "";
    // A link in the folder's path would lead elsewhere from it.
    const bool is_link = plain.lexically_relative(from) != ".";
    if (goes_up && (is_link || ancestor == ancestor.root_path())) return file.string();
    return goes_up ? relative.string() : "./" + relative.string();
}

}  // namespace tedavis::host_sim

#include "bus/switches/switch_config.hpp"

#include <string>

namespace tedavis::bus {
namespace {

enum class Code : std::uint8_t { one_hot, odd_parity, even_parity, free };
constexpr std::string_view kCodeNames[] = {"one_hot", "odd_parity", "even_parity", "free"};
constexpr std::string_view kPullNames[] = {"none", "off", "up", "down"};

bool obeys(Code code, std::uint32_t high) {
    int ones = 0;
    for (std::uint32_t rest = high; rest != 0; rest &= rest - 1) ++ones;
    switch (code) {
        case Code::one_hot: return ones == 1;
        case Code::odd_parity: return ones % 2 == 1;
        case Code::even_parity: return ones % 2 == 0;
        case Code::free: return true;
    }
    return false;
}

constexpr std::int64_t kMaxLineOffset = 65535;

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

/// Names become words of the switch log, so they must be one word.
bool is_word(std::string_view text) {
    return !text.empty() && text.size() <= 63 && text.find_first_of(" \t\r\n#") == std::string_view::npos;
}

void read_line(base::ConfigSection section, SwitchConfig& config) {
    SwitchLine line;
    for (const std::string_view key : {std::string_view("chip"), std::string_view("name")}) {
        const std::string_view text = section.text(key);
        if (!is_word(text)) section.fault(key, quoted(key) + " must be 1 to 63 characters without blanks or '#'");
        (key == "chip" ? line.chip : line.name) = text;
    }
    if (section.has("offset")) line.offset = static_cast<std::int32_t>(section.integer("offset", 0, kMaxLineOffset));
    line.active_low = section.boolean("active_low", false);
    section.choose("pull", kPullNames, line.pull);
    const std::string full = std::string(line.chip.view()) + "." + std::string(line.name.view());
    for (const SwitchLine& other : config.lines)
        if (line.offset >= 0 && other.offset == line.offset && other.chip.view() == line.chip.view())
            section.fault("offset", "another line of this chip has this offset; correct one");
    if (config.find_line(full) != config.lines.size())
        section.fault("name", "line " + quoted(full) + " is listed twice; remove one");
    if (!config.lines.try_push_back(line))
        section.fault("name", "more than " + std::to_string(kMaxSwitchLines) + " lines; remove some");
}

/// The bit of the line with this name; 0 and a fault when there is none or more than one (two chips).
std::uint32_t bit_of(base::ConfigSection& section, const SwitchConfig& config, std::string_view name) {
    std::uint32_t bits = 0;
    int found = 0;
    for (std::size_t i = 0; i < config.lines.size(); ++i) {
        const std::string full = std::string(config.lines[i].chip.view()) + "." + std::string(config.lines[i].name.view());
        if (config.lines[i].name.view() != name && full != name) continue;
        bits |= std::uint32_t{1} << i;
        ++found;
    }
    if (found == 1) return bits;
    section.fault("high", found == 0 ? quoted(name) + " is none of the lines; correct it"
                                     : quoted(name) + " names several lines; write \"chip.name\"");
    return 0;
}

void read_pattern(base::ConfigSection section, Code code, SwitchConfig& config) {
    SwitchPattern pattern;
    const std::string_view phase = section.text("phase");
    const flight::ParsedPhase parsed = flight::phase_from_name(phase);
    if (!parsed.ok) section.fault("phase", quoted(phase) + " is no flight phase; write for instance \"takeoff.first_climb\"");
    pattern.phase = parsed.phase;
    if (!section.has("high")) section.fault("phase", "this pattern has no 'high'; list the active lines, [] for none");
    std::string_view names[kMaxSwitchLines];
    const std::size_t count = section.texts("high", names);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t bit = bit_of(section, config, names[i]);
        if ((pattern.high & bit) != 0) section.fault("high", quoted(names[i]) + " is listed twice; remove one");
        pattern.high |= bit;
    }
    if (!obeys(code, pattern.high))
        section.fault("high",
                      "this pattern breaks the code " + quoted(kCodeNames[static_cast<std::size_t>(code)]) + "; correct it");
    if (config.find_pattern(pattern.high) != nullptr)
        section.fault("high", "another pattern has the same lines high; make them differ");
    if (!config.patterns.try_push_back(pattern))
        section.fault("phase", "more than " + std::to_string(kMaxSwitchPatterns) + " patterns; remove some");
}

}  // namespace

std::size_t SwitchConfig::find_line(std::string_view full_name) const {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string_view chip = lines[i].chip.view();
        const std::string_view name = lines[i].name.view();
        if (full_name.size() == chip.size() + 1 + name.size() && full_name.substr(0, chip.size()) == chip &&
            full_name[chip.size()] == '.' && full_name.substr(chip.size() + 1) == name)
            return i;
    }
    return lines.size();
}

const SwitchPattern* SwitchConfig::find_pattern(std::uint32_t high) const {
    for (const SwitchPattern& pattern : patterns)
        if (pattern.high == high) return &pattern;
    return nullptr;
}

base::Result<SwitchConfig, base::Error> load_switch_config(std::string_view text, std::string_view name) {
    base::ConfigReader reader(text, name);
    base::ConfigSection root = reader.root();
    SwitchConfig config;
    config.title = root.text("title", "");
    config.debounce = base::Duration::milliseconds(root.integer("debounce_ms", 0, 1000, 30));
    config.settle = base::Duration::milliseconds(root.integer("settle_ms", 0, 5000, 200));
    Code code = Code::free;
    root.choose("code", kCodeNames, code);
    for (std::size_t i = 0; reader.ok() && i < root.table_count("line"); ++i) read_line(root.table_at("line", i), config);
    for (std::size_t i = 0; reader.ok() && i < root.table_count("pattern"); ++i)
        read_pattern(root.table_at("pattern", i), code, config);
    if (config.lines.empty()) root.fault("line", "no line is listed; add at least one [[line]]");
    if (base::ConfigSection legend = root.section("legend"); reader.ok() && legend.present()) {
        read_line(legend, config);
        config.has_legend_line = true;
    }
    if (config.patterns.empty()) root.fault("pattern", "no pattern is listed; add at least one [[pattern]]");
    if (!reader.finish()) return base::fail(reader.error());
    return config;
}

}  // namespace tedavis::bus

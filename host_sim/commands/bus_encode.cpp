#include "host_sim/commands/bus_encode.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "bus/canaerospace/message_encoder.hpp"
#include "bus/canaerospace/message_header.hpp"
#include "bus/candump/candump_line.hpp"
#include "host_sim/flight_test/nearest_names.hpp"
#include "host_sim/flight_test/read_conditions.hpp"
#include "host_sim/flight_test/sent_message.hpp"
#include "host_sim/flight_test/signal_value.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

const std::string kOriginKey = "phase_origin=";

bus::BusSettings bus_of(const BusEncodeOptions& options) {
    const std::string path = resolve_config(options.bus, "buses");
    const auto settings = bus::load_bus_settings(read_file(path), path);
    if (!settings.ok()) throw UserError(std::string(settings.error().message.view()));
    return settings.value();
}

void require_interface_name(const std::string& name) {
    constexpr std::size_t kMaxLength = 15;
    const bool has_strange = std::any_of(name.begin(), name.end(), [](char c) { return c <= ' ' || c > '~' || c == '/'; });
    if (name.empty() || name.size() > kMaxLength || has_strange)
        throw UserError("--interface " + name + ": a name has 1 to 15 characters without blanks; say for example can0");
}

class EncodedFrames {
public:
    explicit EncodedFrames(const BusEncodeOptions& options)
        : bus_(bus_of(options)),
          encoder_(bus_, kMadeFrameNode),
          interface_(options.interface_name),
          time_(base::Time{} + base::Duration::from_seconds(options.at_s)),
          code_(options.code) {}

    void add(const std::vector<std::string>& values) {
        take_origin(values);
        for (const std::string& word : values) {
            const std::size_t equals = word.find('=');
            if (equals == std::string::npos || equals == 0)
                fault(word, "no signal=value; say for example indicated_airspeed_kt=90");
            else
                add(word, word.substr(0, equals), word.substr(equals + 1));
        }
    }

    [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
    [[nodiscard]] const std::vector<std::string>& faults() const { return faults_; }

private:
    void fault(const std::string& word, const std::string& sentence) { faults_.push_back(word + ": " + sentence); }

    /// Stands for the phase, wherever it lies among the words.
    void take_origin(const std::vector<std::string>& values) {
        const std::vector<std::string>& names = phase_origin_names();
        const auto has = [&](const std::string& key) {
            return std::count_if(values.begin(), values.end(),
                                 [&](const std::string& word) { return word.compare(0, key.size(), key) == 0; });
        };
        for (const std::string& word : values) {
            if (word.compare(0, kOriginKey.size(), kOriginKey) != 0) continue;
            const auto place = std::find(names.begin(), names.end(), word.substr(kOriginKey.size()));
            if (place == names.end())
                fault(word, "no sender of a phase; say unknown, fms, pilot, computed or simulator");
            else if (has("phase=") == 0)
                fault(word, "it belongs to a phase; say phase=cruise or the like, too");
            else if (has(kOriginKey) > 1)
                fault(word, "it is said more than once; remove one");
            else
                origin_ = static_cast<bus::PhaseOrigin>(place - names.begin());
        }
    }

    void add(const std::string& word, const std::string& key, const std::string& value) {
        if (key + "=" == kOriginKey) return;
        if (key == "phase") return add_phase(word, value);
        std::string sentence;
        const auto unit = read_signal_key(key, sentence);
        if (!unit) return faults_.push_back(word + ": " + sentence);
        char* end = nullptr;
        const double number = std::strtod(value.c_str(), &end);
        const bool is_decimal = value.find_first_not_of("0123456789+-.eE") == std::string::npos;
        if (value.empty() || *end != '\0' || !is_decimal || !std::isfinite(number))
            return fault(word, "'" + value + "' is no decimal number");
        if (const std::string wrong = fault_of_value(key, *unit, number); !wrong.empty()) return fault(word, wrong);
        add_signal(word, *unit, number);
    }

    void add_phase(const std::string& word, const std::string& name) {
        const flight::ParsedPhase parsed = flight::phase_from_name(name);
        if (!parsed.ok) return fault(word, "no such phase; say " + nearest_names(name, phase_names()));
        put(encoder_.encode_phase(parsed.phase, origin_, bus::kConfidenceNotStated, true, time_, out()));
    }

    void add_signal(const std::string& word, const StatedSignalUnit& unit, double number) {
        const auto message = sent_message(unit.signal, bus_);
        if (!message || is_stated(bus_.messages, unit.signal))
            return fault(word, "this bus has no message of the standard for it; see the bus file");
        const double si = unit.to_si(number);
        if (unit.signal == flight::Signal::magnetic_variation) encoder_.set_variation(si);
        const std::size_t count = encoder_.encode(message->identifier, si, message->type, time_, out());
        if (count == 0)
            return fault(word, "the value cannot be sent; a magnetic direction needs magnetic_variation_deg before it");
        put(count);
    }

    base::Span<bus::CanFrame> out() { return {frames_.data(), frames_.size()}; }

    void put(std::size_t count) {
        for (std::size_t n = 0; n < count; ++n) {
            frames_[n].time = time_;
            bus::MessageHeader header = bus::read_header(frames_[n]);
            header.message_code = static_cast<std::uint8_t>(header.message_code + code_);  // 0 follows 255
            bus::write_header(frames_[n], header);
            time_ = time_ + kMadeFrameTime;
            std::array<char, bus::kMaxCandumpLine> line;
            const std::size_t length =
                bus::format_candump_line(frames_[n], interface_, bus::StampDigits::micro, false, {line.data(), line.size()});
            TEDAVIS_CHECK(length > 0);  // the name has been checked
            lines_.emplace_back(line.data(), length - 1);
        }
    }

    bus::BusSettings bus_;
    bus::MessageEncoder encoder_;
    std::string interface_;
    base::Time time_;
    unsigned code_;
    bus::PhaseOrigin origin_ = bus::PhaseOrigin::fms;
    std::array<bus::CanFrame, 2> frames_;
    std::vector<std::string> lines_, faults_;
};

}  // namespace

int run_bus_encode(const BusEncodeOptions& options, Console& console) {
    require_interface_name(options.interface_name);
    EncodedFrames frames(options);
    frames.add(options.values);
    for (const std::string& sentence : frames.faults()) console.note("tedavis: " + sentence);
    if (!frames.faults().empty()) return kFaultyInputExitCode;
    std::string text;
    for (const std::string& line : frames.lines()) text += line + "\n";
    console.result(text, json_text(nlohmann::ordered_json{{"lines", frames.lines()}}));
    return 0;
}

}  // namespace tedavis::host_sim

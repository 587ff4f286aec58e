#include "render_core/effects/calibration.hpp"

namespace tedavis::effects {
namespace {

constexpr double kMaxMs = 1e6, kMaxErrorPx = 1e6, kMaxErrorColor = 1000;
constexpr std::string_view kAnew =
    "; measure this display with `tedavis calibrate`, on a board with `tedavis-display --calibrate`";

void read_line(base::ConfigSection costs, std::string_view name, CostLine& line) {
    if (!costs.has(name)) {
        base::FixedString<255> message("the cost of '");
        message.append(name);
        message.append("' is missing");
        message.append(kAnew);
        return costs.fault(name, message.view());
    }
    base::ConfigSection section = costs.section(name);
    line.fixed_ms = section.number("fixed_ms", 0, kMaxMs);
    line.ms_per_megapixel = section.number("ms_per_megapixel", 0, kMaxMs);
    line.ms_per_thousand = section.number("ms_per_thousand", 0, kMaxMs);
}

void read_costs(base::ConfigSection costs, CostTable& table) {
    for (std::size_t n = 0; n < kEffectCount; ++n) read_line(costs, row_of(static_cast<Effect>(n)).name, table.effects[n]);
    for (std::size_t n = 0; n < kOverheads; ++n) {
        const bool may_lack = static_cast<Overhead>(n) == Overhead::rays;  // older files have none: it was not measured
        if (!may_lack || costs.has(kOverheadNames[n])) read_line(costs, kOverheadNames[n], table.overheads[n]);
    }
    table.is_known = true;
}

/// The effects that a level gives up, and that may be given up.
EffectSet read_given_up(base::ConfigSection& section) {
    std::array<std::string_view, kEffectCount> names;
    const std::size_t count = section.texts("given_up", {names.data(), names.size()});
    EffectSet given_up;
    for (std::size_t n = 0; n < count && n < names.size(); ++n) {
        const Effect effect = effect_of(names[n]);
        if (effect != Effect::count_ && row_of(effect).may_be_given_up) {
            given_up.add(effect);
            continue;
        }
        base::FixedString<255> message("'");
        message.append(names[n]);
        message.append(effect == Effect::count_ ? "' is no effect" : "' may not be given up for time");
        message.append(kAnew);
        section.fault("given_up", message.view());
    }
    return given_up;
}

void read_level(base::ConfigSection section, QualityLevels& levels, std::size_t n) {
    QualityLevel& level = levels.at[n];
    level.tau_factor = section.number("tau_factor", 1, 100);
    level.detail_factor = section.number("detail_factor", 0, 1);
    level.given_up = read_given_up(section);
    level.ms = section.number("ms", 0, kMaxMs);
    level.error_px = section.number("error_px", 0, kMaxErrorPx);
    level.error_color = section.number("error_color", 0, kMaxErrorColor);
    const std::string_view fault = fault_of(levels, n);
    if (fault.empty()) return;
    base::FixedString<255> message(fault);
    message.append(kAnew);
    section.fault("ms", message.view());
}

void read_levels(base::ConfigSection& root, QualityLevels& levels) {
    const std::size_t count = root.table_count("quality");
    if (count == 0) return root.fault("quality", "the quality levels are missing; measure it anew with `tedavis calibrate`");
    if (count > kQualityLevelCount)
        return root.fault("quality", "a calibration has at most 6 quality levels; measure it anew with `tedavis calibrate`");
    static_assert(kQualityLevelCount == 6, "the sentence above");
    levels.count = static_cast<std::uint8_t>(count);
    for (std::size_t n = 0; n < count; ++n) read_level(root.table_at("quality", n), levels, n);
}

void read_subject(base::ConfigSection& root, CalibrationSubject& subject) {
    constexpr std::int64_t kMaxEdgePx = 16384;
    subject.device = root.text("device");
    subject.renderer = root.text("renderer");
    subject.width_px = static_cast<std::uint32_t>(root.integer("width_px", 16, kMaxEdgePx));
    subject.height_px = static_cast<std::uint32_t>(root.integer("height_px", 16, kMaxEdgePx));
    if (subject.device.cut() || subject.renderer.cut())
        root.fault("renderer", "device and renderer have at most 31 and 127 letters; shorten them");
}

/// "these costs were measured for 'a', not for 'b'; measure ..."
void refuse(base::ConfigSection& root, std::string_view key, std::string_view of, std::string_view display) {
    base::FixedString<511> message("these costs were measured for '");
    message.append(of);
    message.append("', not for '");
    message.append(display);
    message.append("'");
    message.append(kAnew);
    root.fault(key, message.view());
}

void require_subject(base::ConfigSection& root, const CalibrationSubject& of, const CalibrationSubject& display) {
    if (of.device != display.device) refuse(root, "device", of.device.view(), display.device.view());
    if (of.renderer != display.renderer) refuse(root, "renderer", of.renderer.view(), display.renderer.view());
    if (of.width_px != display.width_px || of.height_px != display.height_px)
        root.fault("width_px",
                   "these costs were measured for pictures of another size; measure this display with `tedavis calibrate`");
}

base::Result<Calibration, base::Error> read(std::string_view text, std::string_view file_name,
                                            const CalibrationSubject* display) {
    base::ConfigReader reader(text, file_name);
    base::ConfigSection root = reader.root();
    Calibration calibration;
    read_subject(root, calibration.subject);
    calibration.date = root.text("date", "");
    if (display != nullptr) require_subject(root, calibration.subject, *display);
    read_costs(root.section("cost"), calibration.costs);
    read_levels(root, calibration.quality);
    if (!reader.finish()) return base::fail(reader.error());
    return calibration;
}

}  // namespace

base::Result<Calibration, base::Error> read_calibration(std::string_view text, std::string_view file_name) {
    return read(text, file_name, nullptr);
}

base::Result<Calibration, base::Error> read_calibration(std::string_view text, std::string_view file_name,
                                                        const CalibrationSubject& display) {
    return read(text, file_name, &display);
}

}  // namespace tedavis::effects

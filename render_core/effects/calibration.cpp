#include "render_core/effects/calibration.hpp"

namespace tedavis::effects {
namespace {

constexpr double kMaxMs = 1e6;
constexpr std::string_view kAnew = "; measure this display with `tedavis calibrate`";

void read_line(base::ConfigSection costs, std::string_view name, CostLine& line) {
    if (!costs.has(name)) {
        base::FixedString<127> message("the cost of '");
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
    for (std::size_t n = 0; n < kOverheads; ++n) read_line(costs, kOverheadNames[n], table.overheads[n]);
    table.is_known = true;
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
    base::FixedString<383> message("these costs were measured for '");
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

#include "target/calibrate_board.hpp"

#include <ctime>
#include <memory>

#include "platform/runtime/cost_bench.hpp"
#include "target/board_bench.hpp"
#include "target/json_line.hpp"
#include "target/new_file.hpp"

namespace tedavis::target {
namespace {

/// "2026-06-01T14:00:00Z"
base::FixedString<31> utc_text(base::Time wall) {
    const std::time_t seconds = wall.ns / 1'000'000'000;
    std::tm parts{};
    char text[32] = "";
    if (gmtime_r(&seconds, &parts) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

/// Not what costs nothing by itself, since others measure it.
bool is_measured(const effects::MeasuredCost& cost) { return cost.note.empty() && !cost.design.empty(); }

void print_json(const effects::MeasuredCosts& measured, const effects::QualityLevels& levels, const char* output,
                std::FILE* out) {
    JsonLine json;
    std::uint64_t count = 0;
    json.open_object().text("costs", output).open_list("not_measured");
    for (const effects::MeasuredCost& cost : measured.costs) {
        count += is_measured(cost) ? 1 : 0;
        if (!cost.note.empty()) json.open_object().text("name", cost.name.view()).text("why", cost.note.view()).close_object();
    }
    json.close_list().number("measured", count).open_list("levels");
    for (std::size_t n = 0; n < levels.count; ++n)
        json.open_object()
            .number("ms", levels.at[n].ms)
            .number("error_px", levels.at[n].error_px)
            .number("error_color", levels.at[n].error_color)
            .close_object();
    std::fputs(json.close_list().close_object().line().data(), out);
}

void print_text(const effects::MeasuredCosts& measured, const effects::QualityLevels& levels, const char* output,
                std::FILE* out) {
    std::fprintf(out, "%s: what everything costs on %s, %s\n", output, measured.subject.device.c_str(),
                 measured.subject.renderer.c_str());
    for (const effects::MeasuredCost& cost : measured.costs)
        if (is_measured(cost))
            std::fprintf(out, "  %-18s %8.3f ms +- %.3f\n", cost.name.c_str(), cost.ms, cost.spread_ms);
        else if (!cost.note.empty())
            std::fprintf(out, "  %-18s not measured: %s\n", cost.name.c_str(), cost.note.c_str());
    for (std::size_t n = 0; n < levels.count; ++n)
        std::fprintf(out, "  level %zu %8.3f ms, terrain within %.2f px, picture differs by %.2f (CIEDE2000)\n", n,
                     levels.at[n].ms, levels.at[n].error_px, levels.at[n].error_color);
}

/// What one calibration needs that is too large for the stack.
struct Room {
    effects::MeasuredCosts measured;
    effects::CalibrationText text;
};

base::Error measure(const BoardSettings& settings, BoardBench& bench, std::uint32_t rounds, effects::MeasuredCosts& measured) {
    platform::BenchPlace place;
    if (base::Error error = bench.find_place(place)) return error;
    const auto costs = std::make_unique<platform::CostBench>(bench, place, rounds);
    if (base::Error error = costs->measure(measured)) return error;
    measured.program = "tedavis-display --calibrate";
    measured.design = settings.design.name.view();
    measured.terrain = settings.terrain.view();
    return {};
}

}  // namespace

base::Error calibrate_board(const BoardSettings& settings, const CalibrateRequest& request, const CalibratePorts& ports,
                            const StopSignal& stop, std::FILE* out) {
    NewFile file;
    if (base::Error error = file.open(request.output)) return error;
    const auto room = std::make_unique<Room>();
    BoardBench bench(settings, ports.clocks, stop, ports.log);
    if (base::Error error = measure(settings, bench, request.rounds, room->measured)) return error;
    room->measured.date = utc_text(ports.clocks.live.wall());
    write_calibration(room->measured, room->text);
    if (base::Error error = file.write(room->text.view())) return error;
    const effects::QualityLevels levels = choose_levels(room->measured.candidates);
    (request.json ? print_json : print_text)(room->measured, levels, request.output, out);
    return {};
}

}  // namespace tedavis::target

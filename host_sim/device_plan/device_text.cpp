#include "host_sim/device_plan/device_text.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/effects/effect_table.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

template <class Names>
void write_names(std::ostream& text, const char* key, const Names& names) {
    if (names.empty()) return;
    text << key << " = [";
    for (std::size_t n = 0; n < names.size(); ++n) text << (n > 0 ? ", " : "") << '"' << names[n].view() << '"';
    text << "]\n";
}

std::string rate_text(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.15g", number);
    return text;
}

void write_gl(std::ostream& text, const effects::DeviceCapability& capability) {
    text << "\n[gl]\nlane = \"" << effects::to_string(capability.lane) << "\"\ncalls = \""
         << effects::to_string(capability.gl.calls) << "\"\n";
    write_names(text, "also", capability.gl.also);
    write_names(text, "never", capability.gl.never);
    write_names(text, "ignore_faults", capability.gl.ignored_faults);
    text << "max_texture_px = " << capability.gl.max_texture_px << "\nmax_attributes = " << capability.gl.max_attributes
         << "\nmax_texture_units = " << capability.gl.max_texture_units
         << "\nsurface_depth_bits = " << capability.surface_depth_bits
         << "\ndepth24_targets = " << (capability.depth24_targets ? "true" : "false")
         << "\noff_screen_pictures = " << capability.off_screen_pictures << "\nshadow_map_px = " << capability.shadow_map_px
         << "\nblur_square_px = " << capability.blur_square_px << '\n';
}

const char* memory_word(base::MemoryKind kind) { return kind == base::MemoryKind::cpu ? "cpu" : "gpu"; }

void write_effects(std::ostream& text, const effects::DeviceSettings& device) {
    base::FixedVector<base::FixedString<31>, effects::kEffectCount> forbidden;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n)
        if (const auto effect = static_cast<effects::Effect>(n); device.forbidden.has(effect))
            static_cast<void>(forbidden.try_push_back(base::FixedString<31>(effects::row_of(effect).name)));
    if (!device.affords_antialiasing && forbidden.empty()) return;
    text << "\n[effects]\n";
    if (device.affords_antialiasing) text << "affords_antialiasing = true   # for designs that leave it to the device\n";
    write_names(text, "forbid", forbidden);
}

void write_budget_line(std::ostream& text, const base::BudgetLine& line) {
    text << "\n[[budget]]\nname = \"" << line.name.view() << "\"\nkind = \"" << memory_word(line.kind)
         << "\"\nbytes = " << line.bytes << "\nowner = \"" << line.owner.view() << "\"\nreason = \"" << line.reason.view()
         << "\"\n";
}

}  // namespace

std::string device_text(const effects::DeviceSettings& device, const std::string& comment) {
    std::ostringstream text;
    std::istringstream lines(comment);
    for (std::string line; std::getline(lines, line);) text << "# " << line << '\n';
    text << "name = \"" << device.name.view() << "\"\nwidth_px = " << device.width_px << "\nheight_px = " << device.height_px
         << "\nframe_rate_hz = " << rate_text(device.frame_rate_hz) << "\ntriangle_budget = " << device.triangle_budget
         << "\nmax_chunk_slots = " << device.max_chunk_slots << "\nattribute_pages = " << device.attribute_pages
         << "\ndrape_pages = " << device.drape_pages << "\narrival_frames = " << device.arrival_frames << '\n';
    if (device.deadline_ms > 0) text << "deadline_ms = " << rate_text(device.deadline_ms) << '\n';
    write_gl(text, device.capability);
    write_effects(text, device);
    for (const base::BudgetLine& line : device.budget.lines()) write_budget_line(text, line);
    return text.str();
}

Json plan_json(const DevicePlan& plan, std::uint64_t memory_bytes) {
    const effects::DeviceSettings& device = plan.device;
    const std::uint64_t total = total_bytes(device);
    Json given_up = Json::array(), budget = Json::array(), larger = Json::array();
    for (const DevicePlan::Larger& one : plan.larger) larger.push_back({{"device", one.name}, {"bytes", one.bytes}});
    for (const GivenUp& one : plan.given_up)
        given_up.push_back({{"what", one.what}, {"bytes", one.bytes}, {"sentence", one.sentence}});
    for (const base::BudgetLine& line : device.budget.lines())
        budget.push_back({{"name", line.name.view()},
                          {"kind", memory_word(line.kind)},
                          {"bytes", line.bytes},
                          {"reason", line.reason.view()}});
    return {{"device", device.name.view()},
            {"made_from", plan.shipped},
            {"lane", effects::to_string(device.capability.lane)},
            {"width_px", device.width_px},
            {"height_px", device.height_px},
            {"frame_rate_hz", device.frame_rate_hz},
            {"memory_bytes", memory_bytes},
            {"total_bytes", total},
            {"cpu_bytes", device.budget.total(base::MemoryKind::cpu)},
            {"gpu_bytes", device.budget.total(base::MemoryKind::gpu)},
            {"left_bytes", memory_bytes - total},
            {"max_chunk_slots", device.max_chunk_slots},
            {"attribute_pages", device.attribute_pages},
            {"drape_pages", device.drape_pages},
            {"off_screen_pictures", device.capability.off_screen_pictures},
            {"larger", larger},
            {"given_up", given_up},
            {"budget", budget}};
}

std::string plan_text(const DevicePlan& plan, std::uint64_t memory_bytes) {
    const effects::DeviceSettings& device = plan.device;
    std::ostringstream text;
    text << "made from " << plan.shipped << ", " << total_bytes(device) << " of " << memory_bytes
         << " bytes: " << device.budget.total(base::MemoryKind::cpu) << " of the processor, "
         << device.budget.total(base::MemoryKind::gpu) << " of the GPU\nmax_chunk_slots " << device.max_chunk_slots
         << ", attribute_pages " << device.attribute_pages << ", drape_pages " << device.drape_pages << ", off_screen_pictures "
         << device.capability.off_screen_pictures;
    for (const DevicePlan::Larger& one : plan.larger)
        text << "\nthe larger device " << one.name << " takes " << one.bytes << " bytes";
    if (plan.given_up.empty()) text << "\nnothing of this device is given up";
    for (const GivenUp& one : plan.given_up) text << "\ngiven up: " << one.sentence;
    return text.str();
}

}  // namespace tedavis::host_sim

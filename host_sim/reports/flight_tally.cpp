#include "host_sim/reports/flight_tally.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reports/line_chart.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kMaxSpans = 3;

bool has_flag(const display::FrameRecord& record, std::string_view name) {
    return std::any_of(record.flags.begin(), record.flags.end(), [&](const display::Name& flag) { return flag.view() == name; });
}

bool has_place(const display::FrameRecord& record) {
    return record.own_ship.state == base::SignalState::valid || record.own_ship.state == base::SignalState::stale;
}

}  // namespace

void FlightTally::add(const display::FrameRecord& record, double height_above_terrain_m) {
    const double time_s = (record.time - origin_).to_seconds();
    ++frames_;
    add_place(record, time_s);
    const std::uint64_t with_terrain_before = with_terrain_;
    add_error(record, time_s);
    add_stale(record);
    alerts_.add(record);
    const bool is_over_ground = record.own_ship.state == base::SignalState::valid && was_inside_;
    const bool is_void = is_over_ground && std::isnan(height_above_terrain_m);
    without_height_ += is_void ? 1 : 0;
    terrain_over_void_ += is_void && with_terrain_ > with_terrain_before ? 1 : 0;
    if (!has_flag(record, "terrain.above_own_ship")) return;
    if (below_++ == 0) first_below_s_ = time_s;
    if (height_above_terrain_m < 0) deepest_m_ = std::max(deepest_m_, -height_above_terrain_m);
}

void FlightTally::add_place(const display::FrameRecord& record, double time_s) {
    const bool is_outside = has_flag(record, "terrain.outside_database");
    const bool is_inside = has_place(record) && !is_outside;
    without_position_ += has_place(record) ? 0 : 1;
    outside_ += is_outside ? 1 : 0;
    if (has_place(record))
        extent_.include(base::degrees(record.own_ship.position.latitude_rad),
                        base::degrees(record.own_ship.position.longitude_rad));
    if (is_inside && !was_inside_ && spans_in_all_++ < kMaxSpans) spans_.push_back({time_s, time_s});
    if (is_inside && spans_in_all_ <= kMaxSpans) spans_.back().last_s = time_s;
    was_inside_ = is_inside;
}

void FlightTally::add_stale(const display::FrameRecord& record) {
    for (const display::StaleRecord& stale : record.stale) {
        StaleLayer& layer = stale_[std::string(stale.layer.view())];
        ++layer.frames;
        layer.oldest_s = std::max(layer.oldest_s, stale.age_s);
    }
}

void FlightTally::add_error(const display::FrameRecord& record, double time_s) {
    const display::TerrainRecord& terrain = record.terrain;
    constexpr double kLongestStart_s = 2;
    if (terrain.limit.empty()) {  // none was planned
        is_starting_ = true;
        start_s_ = time_s;
        return;
    }
    with_terrain_ += record.terrain_aspect.technique.view() != "none" ? 1 : 0;
    if (frames_ == 1) start_s_ = time_s;
    is_starting_ = is_starting_ && terrain.pending > 0 && std::abs(time_s - start_s_) <= kLongestStart_s &&
                   !has_flag(record, "terrain.failing");
    if (!is_starting_) {
        worst_error_px_ = std::max(worst_error_px_, terrain.worst_error_px);
        return;
    }
    worst_start_error_px_ = std::max(worst_start_error_px_, terrain.worst_error_px);
    if (!has_flag(record, "terrain.coarse")) return;
    if (coarse_starts_++ == 0) first_coarse_s_ = time_s;
    worst_coarse_px_ = std::max(worst_coarse_px_, terrain.worst_error_px);
}

std::string FlightTally::frames_of(std::uint64_t count) const {
    if (frames_ == 1) return "the only frame lies";
    return part_of(count, frames_) + (count == 1 ? " frames lies" : " frames lie");
}

std::string FlightTally::inside_words() const {
    std::string words;
    for (const Span& span : spans_) {
        const auto [from_s, to_s] = std::minmax(span.first_s, span.last_s);
        words += (words.empty() ? "" : ", ") + decimal(from_s, 0) + " - " + decimal(to_s, 0) + " s";
    }
    if (spans_in_all_ > spans_.size()) words += " and " + counted(spans_in_all_ - spans_.size(), "more span");
    return words;
}

void FlightTally::find_places(const std::string& terrain, const terrain::TerrainDatabase& database, Findings& findings) const {
    if (outside_ > 0) {
        const std::string inside = inside_words();
        findings.push_back({"terrain.outside",
                            frames_of(outside_) + " outside " + terrain +
                                (inside.empty() ? ": it covers " + extent_of(database).words() + ", the flight " + extent_.words()
                                                : "; inside: " + inside),
                            outside_});
    }
    if (without_height_ > 0)
        findings.push_back({"terrain.no_height",
                            frames_of(without_height_) + " over ground without a height in " + terrain + " (void or damaged)",
                            without_height_});
    if (with_terrain_ == 0 && outside_ + below_ + without_position_ == 0)  // which say why themselves
        findings.push_back({"terrain.never_shown",
                            "no terrain of " + terrain + " is shown in any frame; the flags of the records say why", frames_});
    if (below_ > 0)
        findings.push_back({"terrain.above_own_ship",
                            frames_of(below_) + " below the ground of " + terrain + ", first at " + decimal(first_below_s_, 1) +
                                " s, at most by " + decimal(deepest_m_, 0) + " m",
                            below_});
    if (coarse_starts_ > 0)
        findings.push_back({"terrain.start_error",
                            "while the first chunks of " + terrain + " arrived, " + counted(coarse_starts_, "frame") + " from " +
                                decimal(first_coarse_s_, 1) + " s on showed terrain coarser than the design allows, up to " +
                                decimal(worst_coarse_px_, 0) + " px wrong",
                            coarse_starts_});
}

void FlightTally::find_stale(Findings& findings) const {
    for (const auto& [name, layer] : stale_)
        findings.push_back({"data.stale",
                            "the layer " + name + " is stale in " + counted(layer.frames, "frame") + " of " +
                                std::to_string(frames_) + ", at most " + age_words(layer.oldest_s) + " old",
                            layer.frames});
}

Findings FlightTally::findings(const std::string& terrain, const terrain::TerrainDatabase* database) const {
    Findings findings;
    if (frames_ > 0 && without_position_ == frames_)
        findings.push_back(
            {"flight.no_position", "the own ship's position is not known in any of " + counted(frames_, "frame"), frames_});
    if (database != nullptr) find_places(terrain, *database, findings);
    find_stale(findings);
    return findings;
}

}  // namespace tedavis::host_sim

"""The faults that seeded_faults puts into a copy of the product. They are faults of the code. What configuration files can state
wrongly is seeded by the tests of `tedavis verify` (tests/host_sim/commands/test_verify.cpp)."""
import collections

# One text of one file, which must be there exactly once, and what takes its place.
Edit = collections.namedtuple("Edit", "file before after")
# `script`: the one that is meant to find it, though others may, too.
Fault = collections.namedtuple("Fault", "name script what edits")


def fault(name, script, what, *edits):
    return Fault(name, script, what, [Edit(*edit) for edit in edits])


DECODER = "bus/canaerospace/message_decoder.cpp"
ENCODER = "bus/canaerospace/message_encoder.cpp"
ARBITER = "render_core/flight/phase_arbiter.cpp"
POLICY = "render_core/policy/failure_policy.cpp"
PITCH_ENTRY = '{311, "body pitch angle", BusUnit::degree, kAnalogue, Signal::pitch, 0, false, false, -kPi / 2, kPi / 2},'
ROLL_ENTRY = '{312, "body roll angle", BusUnit::degree, kAnalogue, Signal::roll, 0, false, false, -kPi, kPi},'

FAULTS = [
    fault("phase_code_decoded", "message_phases", "a phase code on the bus is read as the next one",
          (DECODER, "phase_from_code(static_cast<std::uint8_t>(value.parts[0]))",
           "phase_from_code(static_cast<std::uint8_t>(value.parts[0] + 1))")),
    fault("phase_code_encoded", "message_phases", "a phase is sent with the next code",
          (ENCODER, "{phase.code(), 0, static_cast<std::int64_t>(origin), confidence}",
           "{phase.code() + 1, 0, static_cast<std::int64_t>(origin), confidence}")),
    fault("phase_code_both", "message_faults", "a phase is sent with the next code, and read with it: another table of codes",
          (DECODER, "phase_from_code(static_cast<std::uint8_t>(value.parts[0]))",
           "phase_from_code(static_cast<std::uint8_t>(value.parts[0] - 1))"),
          (ENCODER, "{phase.code(), 0, static_cast<std::int64_t>(origin), confidence}",
           "{phase.code() + 1, 0, static_cast<std::int64_t>(origin), confidence}")),
    fault("invalid_as_valid", "loss_of_pitch", "a value that its sender states as not valid is taken",
          (DECODER, "return service_code != 0 && dialect_.service_code == ServiceCodeMeaning::invalid;",
           "return service_code != 0 && dialect_.service_code != ServiceCodeMeaning::invalid;")),
    fault("signals_swapped", "bus_frames", "pitch and roll have each other's identifier, sent and read",
          ("bus/canaerospace/identifier_table.cpp", f"{PITCH_ENTRY}\n    {ROLL_ENTRY}",
           f"{PITCH_ENTRY.replace('Signal::pitch', 'Signal::roll')}\n    {ROLL_ENTRY.replace('Signal::roll', 'Signal::pitch')}")),
    fault("phase_time_out", "message_time_out", "a phase message counts for twice its time-out",
          ("bus/tracker/flight_tracker.cpp", "can_timeout = bus.phase.timeout;", "can_timeout = {2 * bus.phase.timeout.ns};")),
    fault("phase_held", "message_time_out", "the last phase is held for twice as long",
          (ARBITER, "now - state.stated_at > settings.hold", "now - state.stated_at > base::Duration{2 * settings.hold.ns}")),
    fault("authority", "authority", "the message is believed before the switch",
          (ARBITER, "return {PhaseVote{PhaseSource::switches, inputs.switches}, PhaseVote{PhaseSource::can, {can, can_states}},",
           "return {PhaseVote{PhaseSource::can, {can, can_states}}, PhaseVote{PhaseSource::switches, inputs.switches},")),
    fault("debounce", "panel_bounce", "the switches are not debounced",
          ("bus/switches/switch_debounce.hpp", ": stable_(stable) {}", ": stable_{0 * stable.ns} {}")),
    fault("switch_fault_time", "panel_faults", "an impossible pattern is said after twice the time",
          ("bus/switches/switch_to_phase.cpp", "now - at_now.impossible_since >= config_.settle",
           "now - at_now.impossible_since >= base::Duration{2 * config_.settle.ns}")),
    fault("designs_swapped", "designs_without_scene", "the first two designs of phases have each other's place",
          ("render_core/display/planner/frame_planner_designs.cpp", "    const std::size_t place = phases_.place_of(phase);\n",
           "    std::size_t place = phases_.place_of(phase);\n    if (place == 1 || place == 2) place = 3 - place;\n")),
    fault("stale_limit", "loss_of_pitch", "a signal turns stale after twice the time",
          ("bus/state/state_assembler.cpp", "result.state.limits[i] = settings_.limits[i];",
           "result.state.limits[i] = {{2 * settings_.limits[i].stale.ns}, settings_.limits[i].lost};")),
    fault("extrapolation", "loss_of_position", "the position moves on for twice the time before it is stale",
          ("bus/state/own_ship_filter.cpp", "axis.age > settings.extrapolation_limit ?",
           "axis.age > base::Duration{2 * settings.extrapolation_limit.ns} ?")),
    fault("utc_time_out", "silent_bus", "the time of day is confirmed for twice its time-out",
          ("bus/state/utc_clock.cpp", "is_within(now - confirmed_, timeout_)", "is_within(now - confirmed_, {2 * timeout_.ns})")),
    fault("flag_of_signal", "loss_of_pitch", "the flag of a stale signal is lost",
          (POLICY, "if ((bits & kFlag) != 0 &&", "if ((bits & kFlag) != 0 && state != SignalState::stale &&")),
    fault("flag_of_phase", "disagreement", "the flag phase.disagreement is lost",
          (POLICY, "if (conditions_.phase.disagreement) flag(RecordFlag::phase_disagreement);", "")),
    fault("flag_of_terrain", "terrain_alert", "the flag terrain.ahead is lost, the notice is there",
          (POLICY, "if (out_.terrain_ahead != TerrainAhead::none) flag(RecordFlag::terrain_ahead);", "")),
    fault("terrain_alert", "terrain_alert", "terrain ahead is never warned of",
          (POLICY, "out_.terrain_ahead = knows_terrain_ahead() ? conditions_.terrain_ahead : TerrainAhead::none;",
           "out_.terrain_ahead = TerrainAhead::none;")),
    fault("terrain_kept", "terrain_alert_lost_position", "the terrain stays on the display without a position",
          (POLICY, "const bool known = (all_gathered_ & kRemoveTerrain) == 0;", "const bool known = true;")),
    fault("attitude_kept", "loss_of_pitch", "an attitude that is lost stays on the display",
          ("render_core/policy/signal_rules.cpp",
           "constexpr std::uint8_t kNoTerrainFailed = kRemoveTerrain | kFailElement | kFlag;",
           "constexpr std::uint8_t kNoTerrainFailed = kRemoveTerrain | kFlag;")),
    fault("text_not_drawn", "designs_of_phases", "the words of the phase are placed, and drawn without opacity",
          ("render_core/draw/symbology/annunciations.cpp",
           "is_phase ? TextAnchor::left : TextAnchor::center, field.size, color);",
           "is_phase ? TextAnchor::left : TextAnchor::center, field.size, is_phase ? design::Color{0, 0, 0, 0} : color);")),
]
